//! Graded files: every size of a piece is a block of its own; one size is imported.

use super::Findings;
use super::label::Labels;
use crate::fault::Fault;
use std::collections::{BTreeMap, BTreeSet};

/// The sizes of a file and the one that is imported.
pub(super) struct Sizes {
    /// All sizes, in file order.
    pub(super) all: Vec<String>,
    /// The size that is imported.
    pub(super) chosen: Option<String>,
}

/// Chooses the size: the one asked for, else the sample size, else the only one, else the first with a warning.
pub(super) fn choose(
    asked: Option<&str>,
    file: &Labels,
    pieces: &[&Labels],
    findings: &mut Findings,
) -> Result<Sizes, Fault> {
    let mut seen = BTreeSet::new();
    let all: Vec<String> = pieces
        .iter()
        .filter_map(|l| l.get("size"))
        .filter(|s| seen.insert((*s).to_owned()))
        .map(str::to_owned)
        .collect();
    let find = |name: &str| {
        all.iter()
            .find(|size| size.eq_ignore_ascii_case(name.trim()))
            .cloned()
    };
    if let Some(asked) = asked {
        let Some(found) = find(asked) else {
            let fix = if all.is_empty() {
                "leave size out: the file has no sizes".to_owned()
            } else {
                format!("choose one of {}", all.join(", "))
            };
            return Err(Fault::new(
                "pattern/unknown_size",
                "line 1",
                format!("the file has no size {asked:?}"),
            )
            .fix(fix));
        };
        return Ok(Sizes {
            all,
            chosen: Some(found),
        });
    }
    let sample = file.with_line("sample size");
    let chosen = sample.and_then(|(name, _)| find(name));
    if chosen.is_none() && all.len() > 1 {
        let line = sample.map_or(1, |(_, line)| line);
        findings.warn(
            "pattern/sample_size",
            line,
            format!("the file does not say which of its sizes ({}) is the sample; {} was taken (size= chooses)", all.join(", "), all[0]),
        );
    }
    let chosen = chosen
        .or_else(|| all.first().cloned())
        .or_else(|| sample.map(|(name, _)| name.to_owned()));
    Ok(Sizes { all, chosen })
}

/// Which pieces are imported: those of the chosen size, those without a size, and those that exist in one size only.
pub(super) fn keep(sizes: &Sizes, pieces: &[(&str, Option<&str>)]) -> Vec<bool> {
    let Some(chosen) = sizes.chosen.as_deref() else {
        return vec![true; pieces.len()];
    };
    let mut by_name: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (name, size) in pieces {
        by_name.entry(name).or_default().extend(size);
    }
    let only_size = |name: &str| by_name.get(name).is_some_and(|found| found.len() == 1);
    pieces
        .iter()
        .map(|(name, size)| size.is_none_or(|size| size == chosen || only_size(name)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_of_the_chosen_size_and_of_one_size_are_kept() {
        let sizes = Sizes {
            all: vec!["S".into(), "M".into()],
            chosen: Some("M".into()),
        };
        let pieces = [
            ("front", Some("S")),
            ("front", Some("M")),
            ("patch", Some("ONE")),
            ("label", None),
        ];
        assert_eq!(keep(&sizes, &pieces), [false, true, true, true]);
    }
}
