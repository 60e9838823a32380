//! Start of each panel of a garment: on the body, turned to its seams, outside of what is beneath.

use super::resolve::ResolvedGarment;
use crate::fault::{PlacementCode, Warning, pointer_token, quoted_list};
use crate::mesh::ClothMesh;
use crate::scene::{self, Avatar, PanelPlacement, Placed, SeamPoint};

/// Returns where each panel starts, and what a user should know about it.
pub(super) fn starts(
    garment: &ResolvedGarment,
    mesh: &ClothMesh,
    avatar: Option<&Avatar>,
) -> (Vec<Placed>, Vec<Warning>) {
    let panels = garment.pattern.panels.iter().zip(&garment.panels);
    let panels = panels.map(|(outline, panel)| PanelPlacement {
        panel: outline,
        placement: &panel.placement,
        face: panel.face,
    });
    let panels: Vec<_> = panels.collect();
    let point = |vertex: usize| SeamPoint {
        panel: mesh.panel_of_vertex(vertex),
        uv: mesh.uv[vertex],
    };
    let stitches = mesh.stitches.iter();
    let stitches: Vec<_> = stitches.map(|s| [point(s.a), point(s.b)]).collect();
    let placed = scene::place_panels(&panels, &stitches, avatar);
    let starts = panels.iter().zip(&placed);
    let changes = starts.map(|(panel, placed)| Change::of(panel, placed, avatar));
    let changes: Vec<_> = changes.collect();
    let each = panels.iter().zip(&changes);
    let mut warnings: Vec<_> = each
        .filter_map(|(panel, change)| change.warning(&panel.panel.id))
        .collect();
    warnings.extend(rolled(&panels, &changes));
    warnings.extend(lifted(&panels, &changes));
    (outside(garment, placed, avatar), warnings)
}

/// A change of a panel's start from what the garment, its file or its name states.
enum Change {
    None,
    /// Rolled about a limb, its middle so far from where its file puts it \[m\].
    MovedFromFile(f64),
    /// Rolled about a leg, not flat before or behind it.
    Rolled,
    /// With this direction of the drawing up \[degrees\].
    Turned(f64),
    /// So much higher \[m\].
    Lifted(f64),
}

impl Change {
    fn of(panel: &PanelPlacement<'_>, placed: &Placed, avatar: Option<&Avatar>) -> Self {
        let stated = panel.placement.place(panel.panel, panel.face, avatar);
        let moved = placed.middle() - stated.middle();
        if placed.is_about_limb() && !stated.is_about_limb() {
            if panel.placement.is_about_other_body() {
                Self::MovedFromFile(moved.norm())
            } else {
                Self::Rolled
            }
        } else if placed.up_deg() != stated.up_deg() {
            Self::Turned(placed.up_deg())
        } else if moved.y > 0.0 && moved.xz().norm() == 0.0 {
            Self::Lifted(moved.y)
        } else {
            Self::None
        }
    }

    /// Returns what a user should know of the start of panel `id` alone.
    fn warning(&self, id: &str) -> Option<Warning> {
        let pointer = format!("/panels/{}/placement", pointer_token(id));
        match self {
            Self::MovedFromFile(moved) => {
                let detail = format!(
                    "panel `{id}` starts rolled about an arm or a leg of this body, {:.0} mm from where its file puts it",
                    moved * 1e3
                );
                Some(Warning::new(PlacementCode::Moved, pointer, detail))
            }
            Self::Turned(up_deg) => {
                let detail = format!(
                    "panel `{id}` starts with {up_deg:.0} degrees on its drawing up: its seams are shorter so than as it is drawn"
                );
                Some(Warning::new(PlacementCode::Turned, pointer, detail))
            }
            Self::None | Self::Rolled | Self::Lifted(_) => None,
        }
    }
}

/// Returns which panels start rolled about the legs.
fn rolled(panels: &[PanelPlacement<'_>], changes: &[Change]) -> Option<Warning> {
    let is_rolled = |(_, change): &(_, &Change)| matches!(change, Change::Rolled);
    let ids = panels.iter().zip(changes).filter(is_rolled);
    let ids: Vec<_> = ids.map(|(panel, _)| &panel.panel.id).collect();
    let detail = || {
        let ids = quoted_list(ids.iter().copied());
        format!("{ids} start rolled about the legs, not flat before and behind them")
    };
    (!ids.is_empty()).then(|| Warning::new(PlacementCode::Moved, "/panels", detail()))
}

/// Returns which panels start higher than they are put.
fn lifted(panels: &[PanelPlacement<'_>], changes: &[Change]) -> Option<Warning> {
    let height = |change: &Change| match change {
        Change::Lifted(height) => Some(*height),
        _ => None,
    };
    let most = changes.iter().filter_map(height).reduce(f64::max)?;
    let ids = panels.iter().zip(changes);
    let ids = ids.filter(|(_, change)| height(change).is_some());
    let ids = quoted_list(ids.map(|(panel, _)| &panel.panel.id));
    let detail = format!(
        "{ids} start higher than they are put, by {:.0} mm at most, so that their seams close above the shoulders and their hems above the ankles",
        most * 1e3
    );
    Some(Warning::new(PlacementCode::Lifted, "/panels", detail))
}

/// Returns the same starts outside of a garment worn beneath, and each layer outside of the lower
/// ones.
fn outside(
    garment: &ResolvedGarment,
    mut placed: Vec<Placed>,
    avatar: Option<&Avatar>,
) -> Vec<Placed> {
    let outlines = &garment.pattern.panels;
    if let Some(over) = &garment.over {
        let tip = avatar.and_then(|avatar| avatar.landmarks.get("shoulder_tip_l"));
        let trunk = tip.map_or(f64::INFINITY, |tip| tip.x);
        let panels = outlines.iter().zip(placed);
        placed = panels
            .map(|(outline, placed)| placed.outside(outline, &over.vertices, trunk))
            .collect();
    }
    let mut upwards: Vec<usize> = (0..garment.layers.len()).collect();
    upwards.sort_by_key(|&panel| garment.layers[panel]);
    for (number, &panel) in upwards.iter().enumerate() {
        let lower = upwards[..number].iter();
        let lower = lower.filter(|&&other| garment.layers[other] < garment.layers[panel]);
        let lower = lower.map(|&other| (&outlines[other], &placed[other]));
        placed[panel] = placed[panel].clone().above(&outlines[panel], lower);
    }
    placed
}
