//! Verdict on a garment: the figures of its report that are faults, in words.

use crate::solver::{DrapeReport, Intersection, IntersectionKind, Shortcoming, Verdict};

/// Strain that no cloth bears \[-\]: twice its length.
const TORN: f64 = 1.0;

/// Area of layers in the wrong order that is no fault \[m²\]: at edges that lie on each other, a
/// few triangles of a mesh of 15 mm may be counted as in the wrong one.
const LAYERS_WRONG: f64 = 5e-4;

/// Demands that a garment is judged by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Demands {
    /// True if cloth may not pass through cloth.
    pub(super) no_crossings: bool,
    /// True if there is a body that is to carry it.
    pub(super) has_avatar: bool,
    /// True if its panels have an order of layers.
    pub(super) has_layers: bool,
    /// Widest gap of a closed seam \[m\].
    pub(super) seam_gap_m: f64,
}

/// Judges a garment by its report.
pub(super) fn verdict(report: &DrapeReport, demands: Demands) -> Verdict {
    let checks = [
        (Shortcoming::Crossings, crossings(report, demands)),
        (Shortcoming::Body, through_body(report, demands)),
        (Shortcoming::Layers, layers_in_wrong_order(report, demands)),
        (Shortcoming::Gap, open_seams(report, demands)),
        (Shortcoming::Strain, torn(report)),
        (Shortcoming::Worn, not_worn(report, demands)),
    ];
    let faults = checks.into_iter();
    let faults = faults.filter_map(|(what, because)| because.map(|because| (what, because)));
    let (failed, because): (Vec<_>, Vec<_>) = faults.unzip();
    Verdict {
        ok: failed.is_empty(),
        failed,
        because,
    }
}

fn crossings(report: &DrapeReport, demands: Demands) -> Option<String> {
    if !demands.no_crossings {
        return None;
    }
    let Some(pairs) = report.self_intersections else {
        return Some("whether cloth passes through cloth could not be told".to_owned());
    };
    let flat = report.degenerate_triangles.unwrap_or(0);
    let most = |kind| place(&report.intersections, kind);
    if pairs > 0 {
        let where_most = most(IntersectionKind::Cloth);
        let pairs = counted(pairs, "pair", "pairs");
        return Some(format!(
            "cloth passes through cloth: {pairs} of triangles meet, {where_most}"
        ));
    }
    (flat > 0).then(|| {
        let where_most = most(IntersectionKind::Degenerate);
        let triangles = counted(flat, "triangle has", "triangles have");
        format!("{triangles} no area, {where_most}")
    })
}

fn through_body(report: &DrapeReport, demands: Demands) -> Option<String> {
    if demands.has_avatar && report.body_intersections.is_none() {
        return Some("whether cloth passes through the body could not be told".to_owned());
    }
    let pairs = report.body_intersections.unwrap_or(0);
    let inside = report.vertices_inside_body.unwrap_or(0);
    if pairs == 0 && inside == 0 {
        return None;
    }
    let kind = if pairs > 0 {
        IntersectionKind::Body
    } else {
        IntersectionKind::InsideBody
    };
    let where_most = place(&report.intersections, kind);
    let pairs = counted(pairs, "pair", "pairs");
    let inside = counted(inside, "vertex is", "vertices are");
    Some(format!(
        "cloth passes through the body: {pairs} of triangles meet and {inside} inside, {where_most}"
    ))
}

fn layers_in_wrong_order(report: &DrapeReport, demands: Demands) -> Option<String> {
    let is_judged = demands.has_layers && demands.has_avatar;
    let Some(area) = report.layers_wrong_area_m2 else {
        return is_judged.then(|| "the order of its layers could not be told".to_owned());
    };
    (area > LAYERS_WRONG).then(|| {
        format!(
            "layers lie in the wrong order: {:.0} cm² have one beyond them that belongs beneath, more than {:.0} cm²",
            area * 1e4,
            LAYERS_WRONG * 1e4
        )
    })
}

fn open_seams(report: &DrapeReport, demands: Demands) -> Option<String> {
    let (gap, most) = (report.seam_gap_max_m, demands.seam_gap_m);
    // Not even if it is no number.
    let is_closed = gap <= most;
    (!is_closed).then(|| {
        format!(
            "a seam is {:.1} mm open, more than {:.1} mm",
            gap * 1e3,
            most * 1e3
        )
    })
}

fn torn(report: &DrapeReport) -> Option<String> {
    let strain = report.strain_max;
    let bears = strain <= TORN;
    (!bears).then(|| {
        format!(
            "cloth is stretched by {:.0} %, which none bears: is a seam of very unlike sides, or the garment too small?",
            strain * 100.0
        )
    })
}

fn not_worn(report: &DrapeReport, demands: Demands) -> Option<String> {
    let is_fault = demands.has_avatar && report.converged && report.support.ok == Some(false);
    is_fault.then(|| format!("it is not worn: {}", report.support.because))
}

fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// Returns the place with most faults of a kind, in words.
fn place(places: &[Intersection], kind: IntersectionKind) -> String {
    let Some(place) = places.iter().find(|place| place.kind == kind) else {
        return "at places that are not listed".to_owned();
    };
    let [x, y, z] = place.at.map(|coordinate| coordinate * 1e3);
    let panels = match &place.panels[..] {
        [a, b] if a == b => format!("panel {a} through itself"),
        [a, b] => format!("panel {a} through panel {b}"),
        panels => format!("panel {}", panels.join(", ")),
    };
    format!(
        "{} of them {panels} at ({x:.0}, {y:.0}, {z:.0}) mm",
        place.count
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solver::Support;

    const DEMANDS: Demands = Demands {
        no_crossings: true,
        has_avatar: true,
        has_layers: false,
        seam_gap_m: 1e-3,
    };

    fn flawless() -> DrapeReport {
        DrapeReport {
            converged: true,
            self_intersections: Some(0),
            degenerate_triangles: Some(0),
            body_intersections: Some(0),
            vertices_inside_body: Some(0),
            support: Support {
                ok: Some(true),
                ..Support::default()
            },
            ..DrapeReport::default()
        }
    }

    fn failed(report: &DrapeReport) -> Vec<Shortcoming> {
        verdict(report, DEMANDS).failed
    }

    #[test]
    fn a_report_without_faults_is_good() {
        let good = verdict(&flawless(), DEMANDS);
        assert!(good.ok && good.failed.is_empty() && good.because.is_empty());
    }

    #[test]
    fn each_fault_is_named_with_its_place_the_gravest_first() {
        let mut report = flawless();
        report.self_intersections = Some(3);
        report.seam_gap_max_m = 2e-3;
        report.intersections = vec![Intersection {
            kind: IntersectionKind::Cloth,
            panels: vec!["sleeve".to_owned(), "front".to_owned()],
            at: [0.1, 1.2, 0.03],
            count: 3,
        }];
        let verdict = verdict(&report, DEMANDS);
        assert_eq!(verdict.failed, [Shortcoming::Crossings, Shortcoming::Gap]);
        assert!(!verdict.ok);
        let why = &verdict.because[0];
        assert!(why.contains("3 pairs of triangles"), "{why}");
        assert!(
            why.contains("panel sleeve through panel front at (100, 1200, 30) mm"),
            "{why}"
        );
        report = flawless();
        report.vertices_inside_body = Some(1);
        assert_eq!(failed(&report), [Shortcoming::Body]);
        report = flawless();
        report.degenerate_triangles = Some(1);
        assert_eq!(failed(&report), [Shortcoming::Crossings]);
        report = flawless();
        report.strain_max = 1.5;
        assert_eq!(failed(&report), [Shortcoming::Strain]);
        report = flawless();
        report.support.ok = Some(false);
        assert_eq!(failed(&report), [Shortcoming::Worn]);
    }

    #[test]
    fn what_could_not_be_measured_is_not_good() {
        let mut report = flawless();
        report.self_intersections = None;
        assert_eq!(failed(&report), [Shortcoming::Crossings]);
        report = flawless();
        report.body_intersections = None;
        assert_eq!(failed(&report), [Shortcoming::Body]);
        report = flawless();
        (report.seam_gap_max_m, report.strain_max) = (f64::NAN, f64::NAN);
        assert_eq!(failed(&report), [Shortcoming::Gap, Shortcoming::Strain]);
    }

    #[test]
    fn layers_are_judged_where_there_are_any() {
        let layered = Demands {
            has_layers: true,
            ..DEMANDS
        };
        let mut report = flawless();
        assert_eq!(verdict(&report, layered).failed, [Shortcoming::Layers]);
        for (area, ok) in [
            (0.0, true),
            (LAYERS_WRONG, true),
            (2.0 * LAYERS_WRONG, false),
        ] {
            report.layers_wrong_area_m2 = Some(area);
            assert_eq!(verdict(&report, layered).ok, ok, "{area}");
        }
    }

    #[test]
    fn crossings_are_no_fault_where_cloth_may_pass_through_cloth() {
        let mut report = flawless();
        report.self_intersections = Some(3);
        let lenient = Demands {
            no_crossings: false,
            ..DEMANDS
        };
        assert!(verdict(&report, lenient).ok);
        report.support.ok = Some(false);
        let no_body = Demands {
            has_avatar: false,
            ..lenient
        };
        assert!(verdict(&report, no_body).ok);
    }
}
