//! Mirrored copies added to a pattern: those that are named, and those that the file asks for.

use super::mirror::{MIRROR, mirrored};
use super::{Panel, Pattern};
use crate::fault::{PatternCode, Warning};
use std::borrow::Cow;
use std::collections::BTreeSet;

impl Pattern {
    /// Returns the pattern with those mirrored copies that are named: `X~mirror` for each panel X
    /// that is there and no copy itself. They come after all other panels, in the pattern's order,
    /// placed as the mirror images of their sources; names of anything else are left to others.
    pub fn with_copies<'a>(&self, names: impl IntoIterator<Item = &'a str>) -> Cow<'_, Self> {
        let wanted = names
            .into_iter()
            .filter_map(|name| name.strip_suffix(MIRROR));
        let mut wanted: BTreeSet<&str> = wanted.collect();
        for panel in &self.panels {
            wanted.remove(panel.id.strip_suffix(MIRROR).unwrap_or(""));
        }
        let sources = self.panels.iter();
        let sources = sources.filter(|p| p.copy_of.is_none() && wanted.contains(p.id.as_str()));
        let copies: Vec<Panel> = sources.map(mirrored).collect();
        if copies.is_empty() {
            return Cow::Borrowed(self);
        }
        let mut pattern = self.clone();
        for copy in &copies {
            let source = copy.copy_of.as_ref().and_then(|id| self.placements.get(id));
            let placement = source.map(|source| (copy.id.clone(), source.mirrored()));
            pattern.placements.extend(placement);
        }
        pattern.panels.extend(copies);
        Cow::Owned(pattern)
    }
}

/// Adds the copies that the file itself asks for by its quantities, and warns where it does not say
/// whether pieces are a mirrored pair.
pub(super) fn add_stated(panels: &mut Vec<Panel>) -> Vec<Warning> {
    let copies: Vec<Panel> = panels
        .iter()
        .filter(|panel| panel.quantity.is_some_and(|quantity| quantity.right > 0))
        .map(mirrored)
        .collect();
    let unclear = panels.iter().enumerate().filter(|(_, panel)| {
        let is_several = panel.quantity.is_some_and(|q| q.left > 1 && q.right == 0);
        is_several && !panel.unfolded
    });
    let warnings = unclear.map(|(i, panel)| {
        let count = panel.quantity.map_or(0, |quantity| quantity.left);
        let id = &panel.id;
        let detail = format!(
            "{count} of {id:?} are cut, and the file does not say whether they are a mirrored pair; \
             {id}{MIRROR} in a seam is the mirrored one"
        );
        Warning::new(PatternCode::Quantity, format!("/panels/{i}/quantity"), detail)
    });
    let warnings = warnings.collect();
    panels.extend(copies);
    warnings
}
