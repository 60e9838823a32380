//! The page of all codes: `docs/faults.md`.

use super::table::CodeEntry;
use super::{
    AvatarCode, FabricCode, FileCode, FitCode, GarmentCode, MeshCode, PatternCode, PlacementCode,
    RequestCode, SceneCode, SeamCode, StudyCode,
};
use std::fmt::Write;

/// The tables of all areas, in the order of the page.
const TABLES: &[&[CodeEntry]] = &[
    AvatarCode::TABLE,
    FabricCode::TABLE,
    FileCode::TABLE,
    FitCode::TABLE,
    GarmentCode::TABLE,
    MeshCode::TABLE,
    PatternCode::TABLE,
    PlacementCode::TABLE,
    RequestCode::TABLE,
    SceneCode::TABLE,
    SeamCode::TABLE,
    StudyCode::TABLE,
];

/// Writes the page of all codes, each with its meaning and the usual fix, as `docs/faults.md` has
/// it.
pub fn codes_markdown() -> String {
    let mut page = String::from(
        "# Faults and warnings\n\n\
         Each fault and each warning has a code, `area/kind`, for a client to act on, and a sentence for a person with \
         the figures. This page is made of `src/fault/codes`.\n",
    );
    for table in TABLES {
        write_area(&mut page, table).expect("a string takes all");
    }
    page
}

fn write_area(page: &mut String, table: &[CodeEntry]) -> std::fmt::Result {
    let area = table.first().map_or("", |entry| entry.area());
    write!(
        page,
        "\n## {area}\n\n| code | meaning | usual fix |\n|---|---|---|\n"
    )?;
    for entry in table {
        writeln!(
            page,
            "| `{}` | {} | {} |",
            entry.code, entry.meaning, entry.fix
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn no_code_is_listed_twice() {
        let codes: Vec<_> = TABLES
            .iter()
            .copied()
            .flatten()
            .map(|entry| entry.code)
            .collect();
        let distinct: BTreeSet<_> = codes.iter().collect();
        assert_eq!((codes.len(), codes.len() > 150), (distinct.len(), true));
    }
}
