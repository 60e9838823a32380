//! Front or back of side panels that no name tells of: each lies beside the front or the back whose
//! side is as long as one of its own.

use super::labeled_panel::LabeledPanel;
use super::labels::{EdgeRole, FrontBack, PanelKind};

/// Gives two side panels that their names place nowhere the places that they fit best together. A
/// single one lies between front and back.
pub(super) fn assign_front_back(parts: &mut [LabeledPanel]) {
    let unsaid: Vec<usize> = (0..parts.len())
        .filter(|i| {
            let part = &parts[*i];
            part.kind == PanelKind::Side && part.front_back.is_none() && !part.features.mirrored
        })
        .collect();
    let [a, b] = unsaid[..] else { return };
    if parts[a].features.is_twin(&parts[b].features) {
        return; // A left and a right one.
    }
    let off = |i: usize, of| misfit(parts, &parts[i], of);
    let straight = off(a, FrontBack::Front) + off(b, FrontBack::Back);
    let crossed = off(b, FrontBack::Front) + off(a, FrontBack::Back);
    let (front, back) = if straight <= crossed { (a, b) } else { (b, a) };
    parts[front].front_back = Some(FrontBack::Front);
    parts[back].front_back = Some(FrontBack::Back);
}

/// Returns the least difference of a long edge of a side panel from the side of the front or the
/// back, as a logarithm of their ratio.
fn misfit(parts: &[LabeledPanel], side: &LabeledPanel, front_back: FrontBack) -> f64 {
    let body = |p: &&LabeledPanel| p.kind == PanelKind::Bodice && p.front_back == Some(front_back);
    let length = |p: &LabeledPanel, role| p.mean_length(role).max(1e-6);
    let all = parts.iter().filter(body).flat_map(|p| {
        let own = length(p, EdgeRole::Side);
        [EdgeRole::Side, EdgeRole::Center].map(|role| (own / length(side, role)).ln().abs())
    });
    all.fold(1.0, f64::min)
}
