//! A garment resolved: every id it refers to replaced by its value, and everything checked.

use super::garment::{
    AvatarRef, Garment, PanelSpec, PatternRef, SeamsSpec, StartRef, StartShape, WindSpec,
};
use super::layers;
use super::library::AssetLibrary;
use super::limbs;
use super::over;
use super::panel_spec::{panel_specs, spell_out_copies};
use super::references::{self, NamedFabric, PanelFabrics};
use super::seam_check::{anchored_placements, check_faced};
use super::sewing_pattern::{faces, with_copies, without_allowances};
use super::start_from;
use super::suggest::{self, ListedSeams};
use super::validate::{self, PinnedCorner};
use crate::config::Limits;
use crate::fault::{Fault, Faults, Warning};
use crate::pattern::{Panel, Pattern};
use crate::scene::{AnchoredPlacement, AvatarCache, BodySource, Cut, FixedCloth, Wind};
use crate::seam::suggest::SuggestedSeam;
use crate::seam::{Face, SeamCheckInput, SeamSet};
use crate::solver::SolverOptions;
use std::sync::Arc;

/// Direction of the warp where neither the pattern nor the garment states one: +y \[degrees\].
const DEFAULT_WARP_DEG: f64 = 90.0;

/// A garment as values: nothing in it has to be looked up or checked again. Built only by
/// [`resolve`].
#[derive(Clone, Debug)]
pub struct ResolvedGarment {
    /// The garment file, complete in itself.
    file: Garment,
    /// The panels as they are sewn: mirrored copies among them, seam allowances cut away.
    pub(super) pattern: Pattern,
    /// The seams, checked, with the face of each panel.
    pub(super) seams: SeamSet,
    /// The rest that is known of each panel, in the pattern's order.
    pub(super) panels: Vec<ResolvedPanel>,
    /// The fabrics in use, in the order in which panels are cut from them.
    pub(super) fabrics: Vec<NamedFabric>,
    /// The body, if there is one.
    pub(super) avatar: Option<BodySource>,
    /// The garments that it is worn over, if there are any.
    pub(super) over: Option<Arc<FixedCloth>>,
    /// Bodies made before.
    pub(super) bodies: Arc<AvatarCache>,
    /// The layer of each panel, counted from the body outwards; empty where they have no order.
    pub(super) layers: Vec<usize>,
    /// The corners that do not move.
    pub(super) pins: Vec<PinnedCorner>,
    /// Moving air, if there is any.
    pub(super) wind: Option<Wind>,
    suggested: Vec<SuggestedSeam>,
    warnings: Vec<Warning>,
}

/// A panel, besides its outline.
#[derive(Clone, Debug)]
pub(super) struct ResolvedPanel {
    /// The fabric, by its index, and the direction that the panel is cut in.
    pub(super) cut: Cut,
    /// The side that is out.
    pub(super) face: Face,
    /// The place where it starts.
    pub(super) placement: AnchoredPlacement,
}

impl ResolvedGarment {
    /// Returns the same garment, which takes its body from `bodies` if it was made before.
    #[must_use]
    pub fn with_bodies(mut self, bodies: &Arc<AvatarCache>) -> Self {
        self.bodies = Arc::clone(bodies);
        self
    }

    /// Returns the garment file complete in itself: the pattern, avatar and fabrics that it
    /// referred to are inside. It resolves to the same garment again, with any library.
    pub fn garment(&self) -> &Garment {
        &self.file
    }

    /// Returns the shape that it starts from, if it does from one.
    pub(super) fn start(&self) -> Option<&StartShape> {
        match &self.file.start_from {
            Some(StartRef::Whole(start)) => Some(start),
            Some(StartRef::Id(_)) | None => None,
        }
    }

    /// Returns the seams with their reasons, where the garment left them to the service; else none.
    pub fn suggested(&self) -> &[SuggestedSeam] {
        &self.suggested
    }

    /// Returns what a user should know about its seams.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

/// Finds everything that a garment refers to, and checks it whole.
///
/// # Errors
/// All its faults at once, with JSON Pointers into the garment.
pub fn resolve(
    mut garment: Garment,
    library: &dyn AssetLibrary,
    limits: &Limits,
) -> Result<ResolvedGarment, Faults> {
    let mut faults = validate::own_faults(&garment, limits);
    references::inline_fabrics(&mut garment, library, limits, &mut faults);
    let avatar = references::inline_avatar(&mut garment, library, &mut faults);
    let over = over::inline_over(&mut garment, library, limits, &mut faults);
    start_from::inline_start(&mut garment, library, limits, &mut faults);
    let mut pattern = references::find_pattern(garment.pattern.take(), library, limits)
        .map_err(|found| joined(&mut faults, found))?;
    let ListedSeams { pairs, suggested } = suggest::list_seams(&mut garment, &mut pattern, limits)
        .map_err(|fault| joined(&mut faults, fault.into()))?;
    let whole = with_copies(&garment, &pairs, &pattern);
    faults.extend(validate::panel_faults(&garment, &whole));
    let pins = validate::find_pins(&garment.pins, &whole, &mut faults);
    let specs = panel_specs(&garment, &whole);
    // The saved file keeps the outlines as they were given: they are cut anew each time.
    let pattern = without_allowances(&garment, &specs, whole.clone()).unwrap_or_else(|found| {
        faults.extend(found.0);
        whole.clone()
    });
    spell_out_copies(&mut garment, &whole, &specs);
    let placements = anchored_placements(&specs, &pattern);
    let to_check = SeamCheckInput {
        pattern: &pattern,
        pairs: &pairs,
        faces: &faces(&specs, &pattern),
        edge_length: allowed_edge_length(&garment.simulate, limits),
        limits,
    };
    let (check, seams) = check_faced(&to_check, &specs, &placements);
    let seams = seams.map_err(|found| faults.extend(found.0)).ok();
    let fabrics = references::panel_fabrics(&garment, &specs);
    let (Some(seams), Some(fabrics), true) = (seams, fabrics, faults.is_empty()) else {
        return Err(Faults(faults));
    };
    let panels = resolve_panels(&pattern, &specs, &seams.faces, (&fabrics, placements))?;
    let avatar = avatar.map(|body| match body {
        BodySource::Form(form) => {
            let panels = pattern.panels.iter().zip(&panels);
            let panels = panels.map(|(outline, panel)| (outline, &panel.placement));
            BodySource::Form(limbs::with_limbs(form, panels))
        }
        BodySource::Own(_) => body,
    });
    let of_seams = check.seams.into_iter().flat_map(|seam| seam.warnings);
    let warnings = suggest::warnings(&pattern).into_iter();
    let warnings = warnings.chain(check.warnings).chain(of_seams).collect();
    garment.avatar = avatar.clone().map(AvatarRef::whole);
    garment.seams = SeamsSpec::Pairs(pairs);
    garment.pattern = Some(PatternRef::Whole(Box::new(whole)));
    Ok(ResolvedGarment {
        pattern,
        seams,
        panels,
        fabrics: fabrics.fabrics,
        avatar,
        over,
        layers: layers::ranks(&specs),
        bodies: Arc::default(),
        pins,
        wind: garment.wind.map(wind),
        suggested,
        warnings,
        file: garment,
    })
}

/// Adds `more` to the faults found before, and takes all of them.
fn joined(faults: &mut Vec<Fault>, more: Faults) -> Faults {
    faults.extend(more.0);
    Faults(std::mem::take(faults))
}

/// Returns the length of mesh edges that seams are checked for \[m\]: where the stated one is at
/// fault, seams are still checked.
fn allowed_edge_length(options: &SolverOptions, limits: &Limits) -> f64 {
    let [low, high] = limits.edge_length_m;
    options.edge_length_m.clamp(low, high)
}

/// Puts together what is known of each panel.
///
/// # Errors
/// `placement/unknown` for every panel of which nothing says where it goes.
fn resolve_panels(
    pattern: &Pattern,
    specs: &[PanelSpec],
    faces: &[Face],
    (fabrics, placements): (&PanelFabrics, Vec<Result<AnchoredPlacement, Faults>>),
) -> Result<Vec<ResolvedPanel>, Faults> {
    let (mut panels, mut faults) = (Vec::new(), Vec::new());
    let specs = specs.iter().zip(&fabrics.of_panel);
    let known = pattern.panels.iter().zip(specs).zip(faces);
    for (((panel, (spec, fabric)), face), placement) in known.zip(placements) {
        match placement {
            Ok(placement) => panels.push(ResolvedPanel {
                cut: Cut {
                    fabric: *fabric,
                    warp_angle: warp_deg(panel, spec).to_radians(),
                    face_down: *face == Face::Down,
                },
                face: *face,
                placement,
            }),
            Err(found) => faults.extend(found.0),
        }
    }
    Faults(faults).or(panels)
}

fn warp_deg(panel: &Panel, spec: &PanelSpec) -> f64 {
    let drawn = panel.grain.map(|grain| grain.angle_deg);
    spec.grain_deg.or(drawn).unwrap_or(DEFAULT_WARP_DEG)
}

fn wind(spec: WindSpec) -> Wind {
    Wind {
        velocity: spec.velocity_m_s.into(),
        gust: spec.gust,
    }
}
