//! The lines as a table for people, in Markdown or one by one.

use seamster_fixtures::stability::line::StabilityLine;
use std::fmt::Write;

const HEAD: &str = "| case | vertices | expected | came to | CPU s | allowed | iterations, steps | r | ladder | energy J | at most | estimate mm | error mm |
|---|---:|---|---|---:|---:|---:|---:|---|---:|---:|---:|---:|
";

/// A summary, the faults, and all lines.
pub(crate) fn markdown(lines: &[StabilityLine]) -> String {
    let count = |came_to: &str| lines.iter().filter(|l| l.came_to == came_to).count();
    let wrong: Vec<&StabilityLine> = lines.iter().filter(|l| !l.faults.is_empty()).collect();
    let mut out = format!(
        "\n{} cases: {} converged or completed, {} not (expected, named below), {} refused; {} are not as they must be.\n",
        lines.len(),
        count("converged"),
        count("not converged"),
        count("refused"),
        wrong.len()
    );
    list(
        &mut out,
        "Not as they must be",
        wrong.iter().map(|l| (&l.case, l.faults.join("; "))),
    );
    let known = lines.iter().filter(|l| !l.known.is_empty());
    list(
        &mut out,
        "Known failures",
        known.map(|l| (&l.case, l.known.join("; "))),
    );
    let unfinished = lines.iter().filter(|l| l.came_to == "not converged");
    list(
        &mut out,
        "Not converged",
        unfinished.map(|l| (&l.case, l.why.clone())),
    );
    let refused = lines.iter().filter(|l| l.came_to == "refused");
    list(
        &mut out,
        "Refused",
        refused.map(|l| (&l.case, l.why.clone())),
    );
    let _ = write!(out, "\n### Every case\n\n{HEAD}");
    for line in lines {
        let _ = writeln!(out, "| {} |", cells(line).join(" | "));
    }
    out.push('\n');
    out
}

fn list<'l>(out: &mut String, title: &str, entries: impl Iterator<Item = (&'l String, String)>) {
    let mut entries = entries.peekable();
    if entries.peek().is_some() {
        let _ = write!(out, "\n{title}:\n\n");
    }
    for (case, why) in entries {
        let _ = writeln!(out, "- **{case}**: {}", why.trim().replace('\n', "; "));
    }
}

fn cells(line: &StabilityLine) -> [String; 13] {
    let valid = line.estimate_m.filter(|_| line.estimate_valid);
    [
        line.case.clone(),
        line.vertices.to_string(),
        line.expected.clone(),
        if line.faults.is_empty() {
            line.came_to.clone()
        } else {
            format!("**{}**", line.faults.join("; "))
        },
        format!("{:.2}", line.cpu_s),
        format!("{:.0}", line.within_s),
        work(line),
        line.residual.map_or("–".to_owned(), |r| format!("{r:.0e}")),
        line.ladder.join(", "),
        format!("{:.4e}", line.energy_j),
        match (line.energy_most_j, &line.energy_unbounded) {
            (Some(most), _) => format!("{most:.4e}"),
            (None, Some(why)) => why.clone(),
            (None, None) => "–".to_owned(),
        },
        millimeters(valid),
        millimeters(line.error_m),
    ]
}

fn work(line: &StabilityLine) -> String {
    match line.steps {
        0 => line.newton_iterations.to_string(),
        steps => format!("{}, {steps}", line.newton_iterations),
    }
}

fn millimeters(meters: Option<f64>) -> String {
    meters.map_or("–".to_owned(), |m| format!("{:.1e}", 1e3 * m))
}

/// One line of plain text.
pub(crate) fn short(line: &StabilityLine) -> String {
    let cells = cells(line);
    let good = if line.faults.is_empty() {
        "ok"
    } else {
        "WRONG"
    };
    format!(
        "{good:5} {:52} {:>6} {:>8} s {:>12} it, r {:>6}, [{}] E {} <= {}, est {} err {}: {}",
        line.case,
        cells[1],
        cells[4],
        cells[6],
        cells[7],
        cells[8],
        cells[9],
        cells[10],
        cells[11],
        cells[12],
        if line.faults.is_empty() {
            line.why.trim()
        } else {
            cells[3].as_str()
        },
    )
}
