//! Start of each panel of a garment: on the body, turned to its seams, outside of what is beneath.

use super::resolve::ResolvedGarment;
use crate::fault::{PlacementCode, Warning, pointer_token};
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
        panel: mesh
            .panels
            .partition_point(|range| range.vertices.end <= vertex),
        uv: mesh.uv[vertex],
    };
    let stitches = mesh.stitches.iter();
    let stitches: Vec<_> = stitches.map(|s| [point(s.a), point(s.b)]).collect();
    let placed = scene::place_panels(&panels, &stitches, avatar);
    let warnings = panels.iter().zip(&placed);
    let warnings = warnings.filter_map(|(panel, placed)| warning(panel, placed, avatar));
    let warnings = warnings.collect();
    (outside(garment, placed, avatar), warnings)
}

/// Returns what was decided about a panel's start that neither the garment nor its file states.
fn warning(
    panel: &PanelPlacement<'_>,
    placed: &Placed,
    avatar: Option<&Avatar>,
) -> Option<Warning> {
    let id = &panel.panel.id;
    let pointer = format!("/panels/{}/placement", pointer_token(id));
    let stated = panel.placement.place(panel.panel, panel.face, avatar);
    let moved_mm = (placed.middle() - stated.middle()).norm() * 1e3;
    if panel.placement.is_about_other_body() {
        return (moved_mm > 0.0).then(|| {
            let detail = format!(
                "panel `{id}` starts rolled about the arm of this body, {moved_mm:.0} mm from where its file puts it"
            );
            Warning::new(PlacementCode::Moved, pointer, detail)
        });
    }
    (placed.up_deg() != stated.up_deg()).then(|| {
        let detail = format!(
            "panel `{id}` starts with {:.0} degrees on its drawing up: its seams are shorter so than as it is drawn",
            placed.up_deg()
        );
        Warning::new(PlacementCode::Turned, pointer, detail)
    })
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
