//! The seams of a garment, checked with the faces of its panels and the places where they start.

use super::garment::{Garment, PanelSpec, SeamsSpec};
use super::panel_spec::panel_specs;
use super::sewing_pattern::{faces, garment_faces, with_copies, without_allowances};
use crate::config::Limits;
use crate::fault::{Fault, Faults, RequestCode, SeamCode, Warning};
use crate::pattern::{Panel, Pattern, SeamPair};
use crate::scene::{AnchoredPlacement, Placed};
use crate::seam::{self, Face, FaceRequest, SeamCheck, SeamCheckInput, SeamSet};
use std::cell::OnceCell;

/// Checks the seams of `garment` on `pattern`; what else is wrong with the garment, and its own
/// `pattern`, are not looked at.
///
/// # Errors
/// Faults that concern the request as a whole and not a single seam: those of seams are in the
/// findings.
pub(crate) fn check_seams(
    garment: &Garment,
    pattern: &Pattern,
    limits: &Limits,
) -> Result<SeamCheck, Faults> {
    let pairs = listed_pairs(garment)?;
    let edge_length = edge_length(garment, limits)?;
    let whole = with_copies(garment, pairs, pattern);
    let specs = panel_specs(garment, &whole);
    let pattern = without_allowances(garment, &specs, whole)?;
    let placements: Vec<_> = anchored_placements(&specs, &pattern);
    let to_check = SeamCheckInput {
        pattern: &pattern,
        pairs,
        faces: &faces(&specs, &pattern),
        edge_length,
        limits,
    };
    let (check, set) = check_faced(&to_check, &specs, &placements);
    match set {
        Err(faults) if check.seams.iter().all(|seam| seam.errors.is_empty()) => Err(faults),
        _ => Ok(check),
    }
}

fn listed_pairs(garment: &Garment) -> Result<&[SeamPair], Fault> {
    match &garment.seams {
        SeamsSpec::Pairs(pairs) => Ok(pairs),
        SeamsSpec::Keyword(_) => {
            let detail = "suggested seams have nothing to check";
            Err(Fault::new(SeamCode::NothingToCheck, "/seams", detail)
                .fix("give the list of seams; POST seams/suggest finds one"))
        }
    }
}

fn edge_length(garment: &Garment, limits: &Limits) -> Result<f64, Fault> {
    let [low, high] = limits.edge_length_m;
    let requested = garment.simulate.edge_length_m;
    if (low..=high).contains(&requested) {
        return Ok(requested);
    }
    let detail = format!("the edge length is {requested} m; it must be from {low} to {high} m");
    let pointer = "/simulate/edge_length_m";
    Err(Fault::new(RequestCode::OutOfRange, pointer, detail))
}

/// Returns where each panel starts: where the garment puts it, or the pattern's file, or its name.
///
/// A panel of which nothing says so has a fault in its place.
pub(super) fn anchored_placements(
    specs: &[PanelSpec],
    pattern: &Pattern,
) -> Vec<Result<AnchoredPlacement, Faults>> {
    let panels = pattern.panels.iter().zip(specs);
    panels
        .map(|(panel, spec)| {
            let of_file = pattern.placements.get(&panel.id);
            match (&spec.placement, of_file) {
                (None, Some(_)) => Ok(AnchoredPlacement::new(panel, of_file)?.of_file()),
                (stated, _) => AnchoredPlacement::new(panel, stated.as_ref()),
            }
        })
        .collect()
}

/// Checks seams as [`check_placed`] does. Where the faces that the pattern's file states contradict
/// its seams and those that the garment states do not, the file's are left to the seams, which is
/// said: a lapel is drawn from outside and sewn with its inner side out.
///
/// # Errors
/// As [`check_placed`].
pub(super) fn check_faced(
    to_check: &SeamCheckInput<'_>,
    specs: &[PanelSpec],
    placements: &[Result<AnchoredPlacement, Faults>],
) -> (SeamCheck, Result<SeamSet, Faults>) {
    let (check, set) = check_placed(to_check, placements);
    let is_twisted = |faults: &Faults| faults.0.iter().any(|f| f.code == SeamCode::Twisted);
    let of_garment = garment_faces(specs, to_check.pattern);
    if !set.as_ref().is_err_and(is_twisted) || of_garment == *to_check.faces {
        return (check, set);
    }
    let by_seams = SeamCheckInput {
        faces: &of_garment,
        ..*to_check
    };
    let (mut other, of_seams) = check_placed(&by_seams, placements);
    if of_seams.is_err() {
        return (check, set);
    }
    let panels = to_check.pattern.panels.iter().zip(specs);
    let is_other = |(panel, spec): &(&Panel, &PanelSpec)| {
        spec.face == FaceRequest::Auto
            && panel.face.is_some()
            && panel.face != other.faces.get(&panel.id).copied()
    };
    let others = panels.filter(is_other);
    let ids: Vec<_> = others.map(|(p, _)| format!("`{}`", p.id)).collect();
    let detail = format!(
        "the faces that the pattern's file states contradict its seams: the other side of {} is out, as the seams say; `panels.<id>.face` chooses",
        ids.join(", ")
    );
    let warning = Warning::new(SeamCode::FileFaces, "/panels", detail);
    other.warnings.push(warning);
    (other, of_seams)
}

/// Checks seams between panels that start as `placements` say, each in the pattern's order.
///
/// Panels start about no body: the body moves them all outwards and changes nothing of the order in
/// which their edges meet.
///
/// # Errors
/// Every fault of every seam at once, in the second part.
pub(super) fn check_placed(
    to_check: &SeamCheckInput<'_>,
    placements: &[Result<AnchoredPlacement, Faults>],
) -> (SeamCheck, Result<SeamSet, Faults>) {
    let placed: Vec<[OnceCell<Option<Placed>>; 2]> =
        placements.iter().map(|_| Default::default()).collect();
    let start = |panel: usize, face: Face, uv| {
        let placed = placed[panel][usize::from(face == Face::Down)].get_or_init(|| {
            let placement = placements[panel].as_ref().ok()?;
            Some(placement.place(&to_check.pattern.panels[panel], face, None))
        });
        Some(placed.as_ref()?.position(uv).into())
    };
    seam::check_placed(to_check, &start)
}
