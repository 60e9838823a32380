//! Front or back of side panels that no name tells of: each lies beside the front or the back whose
//! side is as long as one of its own.

use super::evidence::fit;
use super::labeled_panel::LabeledPanel;
use super::labels::{EdgeRole, FrontBack, PanelKind};

/// Fit that counts, and by how much it must be better than the other.
const MIN_FIT: f64 = 0.3;

/// Gives side panels that their names place nowhere their place. One that fits both front and back
/// lies between them.
pub(super) fn assign_front_back(parts: &mut [LabeledPanel]) {
    for i in 0..parts.len() {
        if parts[i].kind != PanelKind::Side || parts[i].front_back.is_some() {
            continue;
        }
        let fits = [FrontBack::Front, FrontBack::Back].map(|of| best_fit(parts, &parts[i], of));
        let [front, back] = fits;
        if (front - back).abs() >= MIN_FIT {
            parts[i].front_back = Some(if front > back {
                FrontBack::Front
            } else {
                FrontBack::Back
            });
        }
    }
}

/// Returns how well a long edge of a side panel fits the side of the front or the back.
fn best_fit(parts: &[LabeledPanel], side: &LabeledPanel, front_back: FrontBack) -> f64 {
    let body = |p: &&LabeledPanel| p.kind == PanelKind::Bodice && p.front_back == Some(front_back);
    let length =
        |p: &LabeledPanel, role| p.role_length(role) / p.segments_of(role).count().max(1) as f64;
    let fits = parts.iter().filter(body).flat_map(|p| {
        let own = length(p, EdgeRole::Side);
        [EdgeRole::Side, EdgeRole::Center].map(|role| fit(own, length(side, role)))
    });
    fits.fold(0.0, f64::max)
}
