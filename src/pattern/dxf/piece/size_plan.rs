//! The size of a graded pattern: one that the file draws, or one that a grade rule table makes of
//! its sample size.

use super::dxf_piece::DxfPiece;
use super::grade;
use crate::config::Limits;
use crate::fault::{Fault, PatternCode};
use crate::pattern::dxf::drawing::sizes::SizeChoice;
use crate::pattern::dxf::findings::DxfFindings;
use crate::pattern::{GradeTable, ImportOptions};

/// A size that is made by a grade rule table.
pub(crate) struct SizePlan<'a> {
    table: &'a GradeTable,
    /// Position of the size in the table.
    size: usize,
}

/// Returns the plan for the size that is wanted; `None` where there is no table, or the file itself
/// draws that size.
///
/// # Errors
/// A size that neither the file nor the table has.
pub(crate) fn plan<'a>(
    pieces: &[DxfPiece],
    options: &'a ImportOptions,
) -> Result<Option<SizePlan<'a>>, Fault> {
    let Some(table) = &options.grading else {
        return Ok(None);
    };
    let Some(wanted) = options.size.as_deref() else {
        let size = table.sample;
        return Ok(Some(SizePlan { table, size }));
    };
    let is_wanted = |size: &str| size.eq_ignore_ascii_case(wanted.trim());
    let mut drawn = pieces.iter().filter_map(|piece| piece.labels.get("size"));
    if drawn.any(is_wanted) && table.size(wanted) != Some(table.sample) {
        return Ok(None);
    }
    let Some(size) = table.size(wanted) else {
        let detail = format!("neither the file nor its grade rule table has a size {wanted:?}");
        let fault = Fault::new(PatternCode::UnknownSize, "line 1", detail);
        return Err(fault.fix(format!("choose one of {}", table.sizes.join(", "))));
    };
    Ok(Some(SizePlan { table, size }))
}

impl SizePlan<'_> {
    /// Returns the sample size, if the file draws it as one of several.
    pub(crate) fn drawn_sample(&self, pieces: &[DxfPiece]) -> Option<&str> {
        let sample = &*self.table.sizes[self.table.sample];
        let mut drawn = pieces.iter().filter_map(|piece| piece.labels.get("size"));
        drawn
            .any(|size| size.eq_ignore_ascii_case(sample))
            .then_some(sample)
    }

    /// Makes the pieces of the sample size those of the size, and tells of the sizes of the table.
    ///
    /// # Errors
    /// A sample size of the file that is not the table's, and rules that the table does not have.
    pub(crate) fn grade(
        &self,
        pieces: &mut [DxfPiece],
        sizes: &mut SizeChoice,
        limits: &Limits,
        findings: &mut DxfFindings,
    ) -> Result<(), Fault> {
        let sample = &self.table.sizes[self.table.sample];
        if let Some(drawn) = sizes
            .chosen
            .as_ref()
            .filter(|s| !s.eq_ignore_ascii_case(sample))
        {
            let detail = format!(
                "the grade rule table is of the sample size {sample:?}, and the file draws {drawn:?}"
            );
            let fault = Fault::new(PatternCode::GradeTable, "line 1", detail);
            return Err(fault.fix("give the table that was exported with the file"));
        }
        for name in &self.table.sizes {
            if !sizes.all.iter().any(|size| size.eq_ignore_ascii_case(name)) {
                sizes.all.push(name.clone());
            }
        }
        sizes.chosen = Some(self.table.sizes[self.size].clone());
        if self.size != self.table.sample {
            grade::to_size(pieces, self.table, self.size, limits, findings)?;
        }
        Ok(())
    }
}
