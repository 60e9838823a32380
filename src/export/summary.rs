//! A pattern in words: a table of its panels, what the import decided, and its warnings, each with
//! the option of the command line that decides otherwise.

use super::counted::counted;
use crate::fault::{Warning, without_controls};
use crate::pattern::polyline::bounds;
use crate::pattern::{Allowance, Panel, Pattern, PatternFormat, Source};

/// Heads of the columns of the table.
const HEADS: [&str; 9] = [
    "panel",
    "box mm",
    "area cm2",
    "around mm",
    "edges",
    "notches",
    "grain",
    "cut",
    "",
];

/// Parameters of the service that warnings name, and what they are called on the command line.
const OPTIONS: [(&str, &str); 8] = [
    ("encoding=", "--encoding "),
    ("units=", "--units "),
    ("size=", "--size "),
    ("outlines=", "--outlines "),
    ("notches=", "--notches "),
    ("unfold=", "--unfold "),
    ("strict=true", "--strict"),
    ("rotation_order=", "--rotation-order "),
];

/// Returns a table of the panels of a pattern, what was decided while it was imported, and its
/// warnings, as text for a terminal.
pub fn pattern_summary(pattern: &Pattern) -> String {
    let panels = counted(pattern.panels.len(), "panel", "panels");
    let panels = panels.unwrap_or_else(|| "no panels".to_owned());
    let name = without_controls(&pattern.name);
    let mut out = format!("{name}: {panels}\n\n{}\n", table(&pattern.panels));
    for line in decisions(pattern) {
        out += &without_controls(&line);
        out.push('\n');
    }
    for warning in &pattern.warnings {
        out += &without_controls(&warning_line(warning));
        out.push('\n');
    }
    out
}

/// Returns the table, its columns as wide as their widest entry; the first and the last to the
/// left, the others to the right.
fn table(panels: &[Panel]) -> String {
    let mut rows = vec![HEADS.map(str::to_owned)];
    rows.extend(panels.iter().map(row));
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max();
    let widths: Vec<usize> = (0..HEADS.len()).map(|k| width(k).unwrap_or(0)).collect();
    let mut out = String::new();
    for row in &rows {
        let mut line = format!("{:<w$}", row[0], w = widths[0]);
        for k in 1..HEADS.len() - 1 {
            line += &format!("  {:>w$}", row[k], w = widths[k]);
        }
        line += &format!("  {}", row[HEADS.len() - 1]);
        out += line.trim_end();
        out.push('\n');
    }
    out
}

fn row(panel: &Panel) -> [String; 9] {
    let points = panel.edges.iter().flat_map(|edge| &edge.points);
    let [low, high] = bounds(&points.copied().collect::<Vec<_>>());
    let [width, height] = [0, 1].map(|k| 1e3 * (high[k] - low[k]));
    let dash = || "-".to_owned();
    let grain = panel.grain.map(|grain| format!("{:.1}", grain.angle_deg));
    let cut = panel.quantity.map(|cut| match (cut.left, cut.right) {
        (left, 0) => left.to_string(),
        (left, right) => format!("{left}+{right}"),
    });
    [
        without_controls(&panel.id),
        format!("{width:.1} x {height:.1}"),
        format!("{:.1}", 1e4 * panel.area_m2),
        format!("{:.1}", 1e3 * panel.perimeter_m),
        panel.edges.len().to_string(),
        panel.notches.len().to_string(),
        grain.unwrap_or_else(dash),
        cut.unwrap_or_else(dash),
        remarks(panel),
    ]
}

/// Returns what else there is to say of a panel.
fn remarks(panel: &Panel) -> String {
    let copy_of = panel.copy_of.as_ref();
    let is_named_otherwise = !panel.name.eq_ignore_ascii_case(&panel.id) && copy_of.is_none();
    let all = [
        is_named_otherwise.then(|| format!("named {:?}", panel.name)),
        copy_of.map(|source| format!("mirrored copy of {source}")),
        panel.unfolded.then(|| "unfolded about its fold".to_owned()),
        counted(panel.holes.len(), "hole", "holes"),
        counted(panel.internal_lines.len(), "line", "lines"),
        counted(panel.drill_holes.len(), "drill hole", "drill holes"),
        (!panel.cut_line.is_empty()).then(|| "cut line beside the sew line".to_owned()),
    ];
    let all: Vec<String> = all.into_iter().flatten().collect();
    all.join(", ")
}

/// Returns what the import decided, a line each, with the option that decides otherwise.
fn decisions(pattern: &Pattern) -> Vec<String> {
    let source = &pattern.source;
    let mut lines = vec![
        format!("format: {}", format_name(source.format)),
        format!(
            "units: {}, 1 is {} mm (--units mm|cm|m|inch reads it in others)",
            source.units,
            1e3 * source.scale_to_m
        ),
    ];
    lines.extend(size(source));
    let allowance = match source.allowance {
        Allowance::None => "none: the outlines are sew lines",
        Allowance::SewLine => "cut away: the sew lines of the file are the outlines",
        Allowance::Unknown => {
            "unknown: the file has no sew lines, or not of all panels; where the outlines are cut lines, \
             state seam_allowance_m of the panels in the garment"
        }
    };
    lines.push(format!("seam allowance: {allowance}"));
    let stated = |count| counted(count, "is stated by the file", "are stated by the file");
    let seams = stated(pattern.seams.len()).map(|stated| format!("seams: {stated}"));
    let placements = stated(pattern.placements.len()).map(|stated| format!("placements: {stated}"));
    lines.extend(seams.into_iter().chain(placements));
    lines
}

fn size(source: &Source) -> Option<String> {
    let chosen = source.sample_size.as_ref()?;
    Some(if source.sizes.len() > 1 {
        let all = source.sizes.join(", ");
        format!("size: {chosen} of {all} (--size NAME reads another)")
    } else {
        format!("size: {chosen}")
    })
}

fn format_name(format: PatternFormat) -> &'static str {
    match format {
        PatternFormat::DxfAama => "DXF after ANSI/AAMA-292",
        PatternFormat::DxfAstm => "DXF after ASTM D6673",
        PatternFormat::Dxf => "DXF of a general CAD",
        PatternFormat::GarmentCode => "GarmentCode specification",
    }
}

fn warning_line(warning: &Warning) -> String {
    let place = if warning.pointer.is_empty() {
        "/"
    } else {
        &warning.pointer
    };
    let detail = with_option_names(&warning.detail);
    format!("warning: {place}: {}: {detail}", warning.code)
}

/// Returns a sentence of the import with the parameters of the service that it names (`units=cm`)
/// as options of the command line (`--units cm`).
pub fn with_option_names(sentence: &str) -> String {
    OPTIONS
        .iter()
        .fold(sentence.to_owned(), |text, (parameter, option)| {
            let text = text.replace(&format!("{parameter} "), option);
            text.replace(parameter, option)
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fault::PatternCode;

    #[test]
    fn warnings_name_the_options_of_the_command_line() {
        let warning = |detail: &str| Warning::new(PatternCode::UnitsAssumed, "line 1", detail);
        assert_eq!(
            warning_line(&warning(
                "mm was taken (units= overrides); units=cm would do"
            )),
            "warning: line 1: pattern/units_assumed: mm was taken (--units overrides); --units cm would do"
        );
    }

    #[test]
    fn table_has_a_row_a_panel_and_its_columns_line_up() {
        let panels = [
            Panel::rectangle("front", [0.3, 0.4]),
            Panel::rectangle("a-long-name", [0.05, 0.4]),
        ];
        let lines: Vec<String> = table(&panels).lines().map(str::to_owned).collect();
        assert_eq!(lines.len(), 3);
        let row: Vec<&str> = lines[1].split_whitespace().collect();
        let wanted = [
            "front", "300.0", "x", "400.0", "1200.0", "1400.0", "4", "0", "-", "-",
        ];
        assert_eq!(row, wanted);
        let column = |line: &str, text: &str| line.find(text).map(|at| at + text.len());
        assert_eq!(column(&lines[1], "1400.0"), column(&lines[2], "900.0"));
    }
}
