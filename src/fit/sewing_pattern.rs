//! The pattern as a garment sews it: with the mirrored copies that it names, less the seam
//! allowances that it states.

use super::garment::{Garment, PanelSpec};
use super::unsupported::escape;
use crate::fault::{Fault, Faults, GarmentCode};
use crate::pattern::{Face, Panel, Pattern, SeamPair};
use crate::seam::FaceRequest;
use std::collections::BTreeMap;

/// The widest seam allowance that can be asked for \[m\].
const WIDEST_ALLOWANCE: f64 = 0.1;

/// Adds the mirrored copies that the garment names in panels, pins and its seams `pairs`.
pub(super) fn with_copies(garment: &Garment, pairs: &[SeamPair], pattern: &Pattern) -> Pattern {
    let panels = garment.panels.keys().map(String::as_str);
    let pins = garment.pins.iter().map(|pin| pin.panel.as_str());
    let runs = pairs
        .iter()
        .flat_map(|pair| pair.a.runs().iter().chain(pair.b.runs()));
    let sewn = runs.map(|run| run.panel.as_str());
    let names = panels.chain(pins).chain(sewn);
    pattern.with_copies(names).into_owned()
}

/// Cuts away the seam allowances that `specs`, the settings of each panel, state. Corners and edges
/// keep their numbers.
///
/// # Errors
/// `garment/number` for an impossible width, `pattern/allowance` where a panel cannot spare it, at
/// `/panels/<id>/seam_allowance_m`.
pub(super) fn without_allowances(
    garment: &Garment,
    specs: &[PanelSpec],
    mut pattern: Pattern,
) -> Result<Pattern, Faults> {
    let mut faults = Faults(Vec::new());
    for (panel, spec) in pattern.panels.iter_mut().zip(specs) {
        let width = spec.seam_allowance_m;
        let source = inherited_from(garment, panel);
        let id = escape(source.unwrap_or(&panel.id));
        let pointer = format!("/panels/{id}/seam_allowance_m");
        if source.is_some() && faults.0.iter().any(|fault| fault.pointer == pointer) {
            continue;
        }
        if !(0.0..=WIDEST_ALLOWANCE).contains(&width) {
            let detail = format!("the seam allowance is {width} m");
            let fix = format!("give a width from 0 to {WIDEST_ALLOWANCE}");
            let fault = Fault::new(GarmentCode::Number, pointer, detail).fix(fix);
            faults.0.push(fault);
            continue;
        }
        if width == 0.0 {
            continue;
        }
        match panel.without_allowance(width) {
            Ok(net) => *panel = net,
            Err(fault) => faults.0.extend(Faults(vec![fault]).under(&pointer).0),
        }
    }
    faults.or(pattern)
}

/// Returns the id of the panel that a copy takes all its settings from: the garment states nothing
/// of the copy itself.
fn inherited_from<'a>(garment: &Garment, panel: &'a Panel) -> Option<&'a String> {
    let is_stated = garment.panels.contains_key(&panel.id);
    panel.copy_of.as_ref().filter(|_| !is_stated)
}

/// Returns the face of each panel by id that the garment states.
pub(super) fn garment_faces(
    specs: &[PanelSpec],
    pattern: &Pattern,
) -> BTreeMap<String, FaceRequest> {
    let panels = pattern.panels.iter().zip(specs);
    panels
        .map(|(panel, spec)| (panel.id.clone(), spec.face))
        .collect()
}

/// Returns the stated face of each panel by id: the garment's, else that of the pattern's file.
pub(super) fn faces(specs: &[PanelSpec], pattern: &Pattern) -> BTreeMap<String, FaceRequest> {
    let face = |(panel, spec): (&Panel, &PanelSpec)| {
        let face = match (spec.face, panel.face) {
            (FaceRequest::Auto, Some(Face::Up)) => FaceRequest::Up,
            (FaceRequest::Auto, Some(Face::Down)) => FaceRequest::Down,
            (stated, _) => stated,
        };
        (panel.id.clone(), face)
    };
    pattern.panels.iter().zip(specs).map(face).collect()
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::fit::garment::SeamsSpec;
    use crate::fit::panel_spec::panel_specs;
    use crate::pattern::Point2;
    use serde_json::{Value, json};

    /// A square sleeve of 0.4 m with its face up.
    fn pattern() -> Pattern {
        let corners = [[0.0, 0.0], [0.0, 0.4], [0.4, 0.4], [0.4, 0.0]];
        let edges = (0..4).map(|i| {
            json!({"index": i, "from": i, "to": (i + 1) % 4, "length_m": 0.4, "points": [corners[i], corners[(i + 1) % 4]]})
        });
        let corner = |(i, p): (usize, &Point2)| json!({"index": i, "x": p[0], "y": p[1]});
        serde_json::from_value(json!({
            "name": "test",
            "source": {"format": "dxf", "units": "m", "scale_to_m": 1.0, "allowance": "unknown"},
            "panels": [{"id": "sleeve", "name": "SLEEVE", "face": "up", "area_m2": 0.16, "perimeter_m": 1.6,
                "drawn_area_m2": 0.16, "edges": edges.collect::<Vec<_>>(),
                "corners": corners.iter().enumerate().map(corner).collect::<Vec<_>>()}],
        }))
        .expect("a pattern")
    }

    pub(in crate::fit) fn garment(panels: Value) -> Garment {
        let run = |panel, from, to| json!({"panel": panel, "from": from, "to": to});
        let seams = json!([{"id": "s", "a": run("sleeve", 0, 1), "b": run("sleeve~mirror", 0, 1)}]);
        serde_json::from_value(json!({"seams": seams, "panels": panels})).expect("a garment")
    }

    pub(in crate::fit) fn pattern_with_copies(garment: &Garment) -> Pattern {
        let SeamsSpec::Pairs(pairs) = &garment.seams else {
            panic!("they are listed");
        };
        with_copies(garment, pairs, &pattern())
    }

    fn net(garment: &Garment, pattern: Pattern) -> Result<Pattern, Faults> {
        let specs = panel_specs(garment, &pattern);
        without_allowances(garment, &specs, pattern)
    }

    #[test]
    fn copies_named_anywhere_are_there_once() {
        let named = pattern_with_copies(&garment(json!({})));
        assert_eq!(named.panels.len(), 2);
        let other = garment(json!({"sleeve~mirror": {}}));
        assert_eq!(with_copies(&other, &[], &pattern()), named);
    }

    #[test]
    fn allowances_are_cut_from_sources_and_copies_and_faults_name_their_place() {
        let with_width = |width: f64| garment(json!({"sleeve": {"seam_allowance_m": width}}));
        let cut = |width| {
            let garment = with_width(width);
            net(&garment, pattern_with_copies(&garment))
        };
        for panel in &cut(0.01).expect("wide enough").panels {
            assert!((panel.area_m2 - 0.38 * 0.38).abs() < 1e-12);
            assert_eq!(panel.cut_line.len(), 4);
        }
        for (width, code) in [(-0.01, "garment/number"), (0.5, "garment/number")] {
            let faults = cut(width).expect_err("no width").0;
            assert_eq!((faults.len(), faults[0].code.as_str()), (1, code));
            assert_eq!(faults[0].pointer, "/panels/sleeve/seam_allowance_m");
        }
        let mut small = pattern();
        small.panels[0] = small.panels[0]
            .without_allowance(0.15)
            .expect("wide enough");
        small.panels[0].cut_line.clear();
        let faults = net(&with_width(0.06), small).expect_err("0.1 m wide").0;
        assert_eq!(
            (faults.len(), faults[0].code.as_str()),
            (1, "pattern/allowance")
        );
        assert_eq!(faults[0].pointer, "/panels/sleeve/seam_allowance_m");
    }

    #[test]
    fn faces_are_those_of_the_file_unless_the_garment_states_others() {
        let of = |garment: &Garment| {
            let pattern = pattern_with_copies(garment);
            faces(&panel_specs(garment, &pattern), &pattern)
        };
        let all = |face| {
            let ids = ["sleeve", "sleeve~mirror"];
            ids.map(|id| (id.to_owned(), face))
                .into_iter()
                .collect::<BTreeMap<_, _>>()
        };
        assert_eq!(of(&garment(json!({}))), all(FaceRequest::Up));
        let turned = garment(json!({"sleeve": {"face": "down"}}));
        assert_eq!(of(&turned), all(FaceRequest::Down));
    }
}
