//! The pattern as a garment sews it: with the mirrored copies that it names, less the seam allowances that it states.

use super::availability::escape;
use super::garment::{Garment, PanelAsked, SeamsAsked};
use crate::fault::{Fault, Faults};
use crate::pattern::{Face, Panel, Pattern};
use crate::seam::FaceRequest;
use std::collections::BTreeMap;

/// The widest seam allowance that can be asked for \[m\].
const WIDEST_ALLOWANCE: f64 = 0.1;

/// The pattern with the mirrored copies that the garment names in seams, panels and pins.
pub(crate) fn with_copies(garment: &Garment, pattern: &Pattern) -> Pattern {
    let panels = garment.panels.keys().map(String::as_str);
    let pins = garment.pins.iter().map(|pin| pin.panel.as_str());
    let pairs = match &garment.seams {
        SeamsAsked::Pairs(pairs) => pairs.as_slice(),
        SeamsAsked::Word(_) => &[],
    };
    let runs = pairs
        .iter()
        .flat_map(|pair| pair.a.runs().iter().chain(pair.b.runs()));
    let named = runs.map(|run| run.panel.as_str());
    let names = panels.chain(pins).chain(named);
    pattern.with_copies(names).into_owned()
}

/// What is asked of a panel: of a mirrored copy, what its source is asked, reflected, where nothing is said of itself.
pub(crate) fn asked(garment: &Garment, panel: &Panel) -> PanelAsked {
    let own = garment.panels.get(&panel.id).cloned().unwrap_or_default();
    let source = panel.copy_of.as_ref().and_then(|id| garment.panels.get(id));
    let Some(source) = source.cloned() else {
        return own;
    };
    let or = |own: f64, source: f64| if own == 0.0 { source } else { own };
    let mirrored_grain = source
        .grain_deg
        .map(|angle| (180.0 - angle).rem_euclid(180.0));
    PanelAsked {
        fabric: own.fabric.or(source.fabric),
        texture: own.texture.or(source.texture),
        face: if own.face == FaceRequest::Auto {
            source.face
        } else {
            own.face
        },
        layer: if own.layer == 0 {
            source.layer
        } else {
            own.layer
        },
        grain_deg: own.grain_deg.or(mirrored_grain),
        seam_allowance_m: or(own.seam_allowance_m, source.seam_allowance_m),
        elastic: if own.elastic.is_empty() {
            source.elastic
        } else {
            own.elastic
        },
        placement: own
            .placement
            .or_else(|| source.placement.map(|p| p.mirrored())),
    }
}

/// Writes into the garment what is asked of each mirrored copy, so that it can be looked up by its id.
pub(super) fn spell_out_copies(garment: &mut Garment, pattern: &Pattern) {
    for copy in pattern.panels.iter().filter(|p| p.copy_of.is_some()) {
        let asked = asked(garment, copy);
        if asked != PanelAsked::default() {
            garment.panels.insert(copy.id.clone(), asked);
        }
    }
}

/// The pattern with the seam allowances that the garment states cut away.
///
/// # Errors
/// `garment/number` for a width that is none, `pattern/allowance` where a panel cannot spare it, at
/// `/panels/<id>/seam_allowance_m`.
pub(crate) fn without_allowances(garment: &Garment, pattern: Pattern) -> Result<Pattern, Faults> {
    let mut faults = Faults(Vec::new());
    let mut pattern = pattern;
    for panel in &mut pattern.panels {
        let width = asked(garment, panel).seam_allowance_m;
        let stated = garment.panels.contains_key(&panel.id);
        let of = panel.copy_of.as_ref().filter(|_| !stated);
        let pointer = |id| format!("/panels/{}/seam_allowance_m", escape(id));
        let pointer = pointer(of.unwrap_or(&panel.id));
        if of.is_some() && faults.0.iter().any(|fault| fault.pointer == pointer) {
            continue;
        }
        if !(0.0..=WIDEST_ALLOWANCE).contains(&width) {
            let detail = format!("the seam allowance is {width} m");
            let fix = format!("give a width from 0 to {WIDEST_ALLOWANCE}");
            faults
                .0
                .push(Fault::new("garment/number", pointer, detail).fix(fix));
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

/// The faces that are stated: by the garment, else by the pattern's file.
pub(crate) fn faces(garment: &Garment, pattern: &Pattern) -> BTreeMap<String, FaceRequest> {
    let face = |panel: &Panel| match (asked(garment, panel).face, panel.face) {
        (FaceRequest::Auto, Some(Face::Up)) => FaceRequest::Up,
        (FaceRequest::Auto, Some(Face::Down)) => FaceRequest::Down,
        (stated, _) => stated,
    };
    let panels = pattern.panels.iter();
    panels
        .map(|panel| (panel.id.clone(), face(panel)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    /// A square sleeve of 0.4 m with its face up.
    fn pattern() -> Pattern {
        let corners = [[0.0, 0.0], [0.0, 0.4], [0.4, 0.4], [0.4, 0.0]];
        let edges = (0..4).map(|i| {
            json!({"index": i, "from": i, "to": (i + 1) % 4, "length_m": 0.4, "points": [corners[i], corners[(i + 1) % 4]]})
        });
        let corner = |(i, p): (usize, &[f64; 2])| json!({"index": i, "x": p[0], "y": p[1]});
        serde_json::from_value(json!({
            "name": "test",
            "source": {"format": "dxf", "units": "m", "scale_to_m": 1.0, "allowance": "unknown"},
            "panels": [{"id": "sleeve", "name": "SLEEVE", "face": "up", "area_m2": 0.16, "perimeter_m": 1.6,
                "drawn_area_m2": 0.16, "edges": edges.collect::<Vec<_>>(),
                "corners": corners.iter().enumerate().map(corner).collect::<Vec<_>>()}],
        }))
        .expect("a pattern")
    }

    fn garment(panels: Value) -> Garment {
        let run = |panel, from, to| json!({"panel": panel, "from": from, "to": to});
        let seams = json!([{"id": "s", "a": run("sleeve", 0, 1), "b": run("sleeve~mirror", 0, 1)}]);
        serde_json::from_value(json!({"seams": seams, "panels": panels})).expect("a garment")
    }

    #[test]
    fn copies_named_anywhere_are_there_once() {
        let named = with_copies(&garment(json!({})), &pattern());
        assert_eq!(named.panels.len(), 2);
        let mut other = garment(json!({"sleeve~mirror": {}}));
        other.seams = SeamsAsked::Pairs(vec![]);
        assert_eq!(with_copies(&other, &pattern()), named);
    }

    #[test]
    fn a_copy_is_asked_what_its_source_is_unless_it_is_asked_itself() {
        let mut garment = garment(json!({"sleeve": {
            "fabric": "denim", "grain_deg": 60.0, "face": "down", "seam_allowance_m": 0.01,
            "placement": {"at": "origin", "offset_m": [0.5, 1.0, 0.1], "rotate_deg": [0.0, 10.0, 20.0]}}}));
        let pattern = with_copies(&garment, &pattern());
        let copy = asked(&garment, &pattern.panels[1]);
        assert_eq!(copy.fabric.as_deref(), Some("denim"));
        assert_eq!(
            (copy.grain_deg, copy.face),
            (Some(120.0), FaceRequest::Down)
        );
        let placement = copy.placement.expect("the image of its source's");
        assert_eq!(placement.offset_m, [-0.5, 1.0, 0.1]);
        assert_eq!(placement.rotate_deg, [0.0, -10.0, -20.0]);
        let own = PanelAsked {
            fabric: Some("voile".into()),
            ..PanelAsked::default()
        };
        garment.panels.insert("sleeve~mirror".into(), own);
        spell_out_copies(&mut garment, &pattern);
        let copy = &garment.panels["sleeve~mirror"];
        assert_eq!(copy.fabric.as_deref(), Some("voile"));
        assert!((copy.seam_allowance_m - 0.01).abs() < f64::EPSILON);
    }

    #[test]
    fn allowances_are_cut_from_sources_and_copies_and_faults_name_their_place() {
        let asked = |width: f64| garment(json!({"sleeve": {"seam_allowance_m": width}}));
        let cut = |width| {
            let garment = asked(width);
            without_allowances(&garment, with_copies(&garment, &pattern()))
        };
        let net = cut(0.01).expect("wide enough");
        for panel in &net.panels {
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
        let faults = without_allowances(&asked(0.06), small)
            .expect_err("0.1 m wide")
            .0;
        assert_eq!(
            (faults.len(), faults[0].code.as_str()),
            (1, "pattern/allowance")
        );
        assert_eq!(faults[0].pointer, "/panels/sleeve/seam_allowance_m");
    }

    #[test]
    fn faces_are_those_of_the_file_unless_the_garment_states_others() {
        let plain = garment(json!({}));
        let pattern = with_copies(&plain, &pattern());
        let all = |face| {
            pattern
                .panels
                .iter()
                .map(|p| (p.id.clone(), face))
                .collect::<BTreeMap<_, _>>()
        };
        assert_eq!(faces(&plain, &pattern), all(FaceRequest::Up));
        let turned = garment(json!({"sleeve": {"face": "down"}}));
        assert_eq!(faces(&turned, &pattern), all(FaceRequest::Down));
    }
}
