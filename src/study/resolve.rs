//! A study resolved: its lists filled in, and its garment resolved for every mesh.

use super::request::StudyRequest;
use super::validate;
use crate::config::Limits;
use crate::fault::{Faults, Warning};
use crate::fit::{self, AssetLibrary, Garment, ResolvedGarment};
use crate::scene::AvatarCache;
use crate::seam::suggest::SuggestedSeam;
use crate::solver::{Analysis, Method, SolverOptions};
use std::sync::Arc;

/// Methods of a drape, where none are listed.
const DRAPE_METHODS: [Method; 3] = [
    Method::Newton,
    Method::ImplicitEuler,
    Method::SymplecticEuler,
];
/// Methods of a motion, where none are listed.
const MOTION_METHODS: [Method; 4] = [
    Method::SymplecticEuler,
    Method::Verlet,
    Method::ImplicitEuler,
    Method::Bdf2,
];
/// Tolerances of a drape, where none are listed.
const DRAPE_TOLERANCES: [f64; 4] = [1e-1, 1e-2, 1e-3, 1e-4];
/// CPU time where none is given \[s\]: a worker is not to be kept for hours unasked.
const DEFAULT_TIME_S: f64 = 600.0;

/// A study that was checked whole. Built only by [`resolve`].
#[derive(Clone, Debug)]
pub struct ResolvedStudy {
    request: StudyRequest,
    /// The garment for the first of the edge lengths, and for the others.
    first: ResolvedGarment,
    others: Vec<ResolvedGarment>,
}

impl ResolvedStudy {
    /// Returns the same study, whose garments take their body from `bodies` if it was made
    /// before.
    #[must_use]
    pub fn with_bodies(self, bodies: &Arc<AvatarCache>) -> Self {
        let with = |garment: ResolvedGarment| garment.with_bodies(bodies);
        Self {
            request: self.request,
            first: with(self.first),
            others: self.others.into_iter().map(with).collect(),
        }
    }

    /// Returns the request with nothing left open: the garment complete in itself, empty lists
    /// filled in (but for steps, which depend on the scene). To be stored.
    pub fn request(&self) -> &StudyRequest {
        &self.request
    }

    /// Returns the seams with their reasons, where the garment left them to the service; else none.
    pub fn suggested(&self) -> &[SuggestedSeam] {
        self.first.suggested()
    }

    /// Returns what a user should know about the garment's seams.
    pub fn warnings(&self) -> &[Warning] {
        self.first.warnings()
    }

    /// Returns the garment for each of the edge lengths.
    pub(super) fn garments(&self) -> impl Iterator<Item = &ResolvedGarment> {
        std::iter::once(&self.first).chain(&self.others)
    }
}

/// Checks the request for a study, and finds everything that its garment refers to.
///
/// # Errors
/// All its faults at once, with JSON Pointers into the request.
pub fn resolve(
    mut request: StudyRequest,
    library: &dyn AssetLibrary,
    limits: &Limits,
) -> Result<ResolvedStudy, Faults> {
    fill_in(&mut request, limits);
    let mut faults = validate::faults(&request, limits);
    request.garment.over = None;
    request.garment.start_from = None;
    let options = std::mem::take(&mut request.garment.simulate);
    let [least, most] = limits.edge_length_m;
    let lengths = request.edge_lengths_m.iter().copied();
    let lengths = lengths.filter(|length| (least..=most).contains(length));
    let mut lengths = lengths.take(limits.study_list);
    // Without a right length the garment's other faults are to be found all the same.
    let default = SolverOptions::default().edge_length_m;
    let garment = on_mesh(
        &request.garment,
        &options,
        lengths.next().unwrap_or(default),
    );
    let first = match fit::resolve(garment, library, limits) {
        Ok(first) => first,
        Err(found) => {
            faults.extend(found.under("/garment").0);
            return Err(Faults(faults));
        }
    };
    let mut others = Vec::new();
    for length in lengths {
        // A mesh of its own may divide edges in another way, so each is checked.
        match fit::resolve(on_mesh(first.garment(), &options, length), library, limits) {
            Ok(garment) => others.push(garment),
            Err(found) => faults.extend(found.under("/garment").0),
        }
    }
    Faults(faults).or(())?;
    request.garment = Garment {
        simulate: options,
        ..first.garment().clone()
    };
    Ok(ResolvedStudy {
        request,
        first,
        others,
    })
}

/// Returns the garment for one mesh. Options of a motion alone belong to the study and not to the
/// fit.
fn on_mesh(garment: &Garment, options: &SolverOptions, edge_length_m: f64) -> Garment {
    let simulate = SolverOptions {
        analysis: Analysis::Static,
        method: Method::Auto,
        step_s: None,
        duration_s: None,
        frame_rate_hz: None,
        edge_length_m,
        ..options.clone()
    };
    Garment {
        simulate,
        ..garment.clone()
    }
}

/// Fills empty lists with what they stand for.
fn fill_in(request: &mut StudyRequest, limits: &Limits) {
    let default = DEFAULT_TIME_S.min(limits.study_cpu_s);
    request.time_limit_s.get_or_insert(default);
    let is_motion = request.garment.simulate.analysis == Analysis::Transient;
    if request.methods.is_empty() {
        request.methods = if is_motion {
            MOTION_METHODS.to_vec()
        } else {
            DRAPE_METHODS.to_vec()
        };
    }
    if request.tolerances.is_empty() && !is_motion {
        request.tolerances = DRAPE_TOLERANCES.to_vec();
    }
    if request.edge_lengths_m.is_empty() {
        request.edge_lengths_m = vec![request.garment.simulate.edge_length_m];
    }
}
