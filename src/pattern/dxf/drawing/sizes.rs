//! Sizes of graded files, where every size of a piece is a block of its own; one size is imported.

use super::labels::DxfLabels;
use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::findings::{DxfFindings, excerpt};
use std::collections::{BTreeMap, BTreeSet};

/// The sizes of a file and the one that is imported.
pub(crate) struct SizeChoice {
    /// All sizes, in file order.
    pub(crate) all: Vec<String>,
    /// The size that is imported.
    pub(crate) chosen: Option<String>,
}

/// Chooses the size: the one that is wanted, else the sample size, else the only one, else the
/// first with a warning.
pub(crate) fn choose(
    wanted: Option<&str>,
    file: &DxfLabels,
    pieces: &[&DxfLabels],
    findings: &mut DxfFindings,
) -> Result<SizeChoice, Fault> {
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
    if let Some(wanted) = wanted {
        let Some(found) = find(wanted) else {
            return Err(unknown_size(wanted, &all));
        };
        return Ok(SizeChoice {
            all,
            chosen: Some(found),
        });
    }
    let sample = file.with_line("sample size");
    let chosen = sample.and_then(|(name, _)| find(name));
    if chosen.is_none() && all.len() > 1 {
        warn_of_sample(sample, &all, findings);
    }
    let chosen = chosen
        .or_else(|| all.first().cloned())
        .or_else(|| sample.map(|(name, _)| name.to_owned()));
    Ok(SizeChoice { all, chosen })
}

/// Warns of a sample size that the file does not state, or that none of its pieces has.
fn warn_of_sample(sample: Option<(&str, usize)>, all: &[String], findings: &mut DxfFindings) {
    let (sizes, taken) = (all.join(", "), &all[0]);
    let (line, detail) = match sample {
        Some((name, line)) => (
            line,
            format!(
                "the sample size of the file is {:?}, which is not among its sizes ({sizes}); {taken} was taken (size= chooses)",
                excerpt(name)
            ),
        ),
        None => (
            1,
            format!(
                "the file does not say which of its sizes ({sizes}) is the sample; {taken} was taken (size= chooses)"
            ),
        ),
    };
    findings.warn(PatternCode::SampleSize, line, detail);
}

fn unknown_size(wanted: &str, all: &[String]) -> Fault {
    let fix = if all.is_empty() {
        "leave size out: the file has no sizes".to_owned()
    } else {
        format!("choose one of {}", all.join(", "))
    };
    let detail = format!("the file has no size {wanted:?}");
    Fault::new(PatternCode::UnknownSize, "line 1", detail).fix(fix)
}

/// Returns piece by piece true if it is imported: those of the chosen size, those without a size,
/// and those that exist in one size only. `pieces`: their names and sizes.
pub(crate) fn is_imported(choice: &SizeChoice, pieces: &[(&str, Option<&str>)]) -> Vec<bool> {
    let Some(chosen) = choice.chosen.as_deref() else {
        return vec![true; pieces.len()];
    };
    let mut by_name: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (name, size) in pieces {
        by_name.entry(name).or_default().extend(size);
    }
    let is_of_one_size = |name: &str| by_name.get(name).is_some_and(|found| found.len() == 1);
    pieces
        .iter()
        .map(|(name, size)| size.is_none_or(|size| size == chosen || is_of_one_size(name)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_of_the_chosen_size_and_of_one_size_are_kept() {
        let sizes = SizeChoice {
            all: vec!["S".into(), "M".into()],
            chosen: Some("M".into()),
        };
        let pieces = [
            ("front", Some("S")),
            ("front", Some("M")),
            ("patch", Some("ONE")),
            ("label", None),
        ];
        assert_eq!(is_imported(&sizes, &pieces), [false, true, true, true]);
    }
}
