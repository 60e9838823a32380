//! What can be told of a fit before it is sewn.

use super::garment::{Garment, PatternRef};
use super::library::AssetLibrary;
use super::resolve::resolve;
use super::run;
use crate::config::Limits;
use crate::fault::Warning;
use crate::pattern::Pattern;
use crate::progress::CancelToken;
use crate::scene::AvatarCache;
use crate::solver::Context;
use std::sync::Arc;

/// Length of mesh edges on which a garment is measured \[m\]: its girths are exact on any mesh but
/// for the curves of its edges.
const EDGE_LENGTH: f64 = 0.03;

/// Returns what a user should know about the size of `garment`, sewn of `pattern`, before it is
/// sewn; nothing where it has no body yet, or faults.
pub(crate) fn size_warnings(
    mut garment: Garment,
    pattern: &Pattern,
    assets: (&dyn AssetLibrary, &Arc<AvatarCache>),
    limits: &Limits,
) -> Vec<Warning> {
    if garment.avatar.is_none() {
        return vec![];
    }
    garment.pattern = Some(PatternRef::Whole(Box::new(pattern.clone())));
    garment.simulate.edge_length_m = EDGE_LENGTH;
    let (library, bodies) = assets;
    let Ok(resolved) = resolve(garment, library, limits) else {
        return vec![];
    };
    let resolved = resolved.with_bodies(bodies);
    let context = Context {
        cpu_s: &|| 0.0,
        cancel: &CancelToken::new(),
        progress: &mut |_| {},
        limits,
    };
    let assembled = run::scene(&resolved, &context);
    assembled.map_or_else(|_| vec![], |scene| run::size_warnings(&scene).collect())
}
