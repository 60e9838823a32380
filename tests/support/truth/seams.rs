//! The seams that drafts state: accepted as they are, refused or reported when reversed.

use super::seam_truth::{garments, row};
use super::{Cell, Row, Table};
use std::path::Path;

/// Every draft.
pub(crate) fn table(data: &Path) -> Table {
    let garments = garments(data);
    let rows = garments.iter().map(row).map(|found| {
        let n = found.stitches;
        let counted = |got: usize, of: usize| {
            let text = format!("{got}/{of}");
            if got == of {
                Cell::Right(text)
            } else {
                Cell::Wrong(text)
            }
        };
        Row {
            cells: vec![
                counted(found.accepted[0], n),
                counted(found.accepted[1], n),
                counted(found.refused, n),
                counted(found.refused_on_cycle, found.on_cycle),
                counted(found.likely_reversed, n - found.on_cycle),
                counted(found.bridges_found, found.bridges),
                counted(found.auto_right, n),
                counted(found.false_warnings, 0),
            ],
            name: found.garment,
        }
    });
    Table {
        columns: &[
            "accepted, true faces",
            "accepted, faces found",
            "reversed, refused",
            "reversed on a cycle, refused",
            "reversed else, likely",
            "bridge reversed, likely",
            "auto, put right",
            "false warnings",
        ],
        rows: rows.collect(),
        notes: vec!["bridges: each seam left as the only link of two parts; those under 2 cm are not judged".into()],
    }
}
