//! The key point of the body that a panel's name speaks of.

use crate::pattern::{Panel, PlacementAnchor};

/// The key point that a panel's name speaks of.
pub(super) fn guess(panel: &Panel) -> Option<PlacementAnchor> {
    let name = format!("{} {}", panel.id, panel.name).to_lowercase();
    let words: Vec<&str> = name.split(|c: char| !c.is_alphabetic()).collect();
    let any = |list: &[&str]| words.iter().any(|word| list.contains(word));
    let within = |list: &[&str]| list.iter().any(|part| name.contains(part));
    let back = any(&["back", "bk", "rear", "b"]) || within(&["back", "btorso"]);
    let front = any(&["front", "fr", "frt", "f"]) || within(&["front", "ftorso"]);
    let band = any(&["wb", "band", "waistband"]) || within(&["waistband"]);
    let skirt = within(&["skirt"]);
    // Which arm, which opening: a name alone does not tell, and "sleeve_f" must not pass for a
    // front.
    if within(&["sleeve", "collar", "cuff", "hood"]) {
        return None;
    }
    Some(match (band, skirt, front, back) {
        (true, _, true, false) => PlacementAnchor::WaistFront,
        (true, _, false, true) => PlacementAnchor::WaistBack,
        (true, ..) => PlacementAnchor::Waist,
        (false, true, _, true) => PlacementAnchor::SkirtBack,
        (false, true, _, false) => PlacementAnchor::SkirtFront,
        (false, false, true, false) => PlacementAnchor::TorsoFront,
        (false, false, false, true) => PlacementAnchor::TorsoBack,
        _ => return None,
    })
}
