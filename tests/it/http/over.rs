//! Garments worn over those of other fits, over HTTP.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use super::{mesh, sewn};
use nalgebra::Vector3;
use seamster_fixtures::panels::{pattern, trapezoid};
use seamster_fixtures::server::{Server, config};
use serde_json::{Value, json};

/// A tube about the hips, so much wider than the tightest one \[m\], that hangs by its narrow top.
fn tube(wider: f64, over: Option<&str>) -> Value {
    let half = |id: &str| trapezoid(id, 0.6 + wider, 0.4 + wider, 0.35);
    let run = |panel: &str, from: usize, to: usize| json!({"panel": panel, "from": from, "to": to});
    let seam = |id: &str, from: usize, to: usize| json!({"id": id, "a": run("front", from, to), "b": run("back", 3 - from, 3 - to)});
    json!({
        "pattern": pattern(vec![half("front"), half("back")]),
        "seams": [seam("left", 0, 1), seam("right", 3, 2)],
        "panels": {"front": {"placement": {"at": "skirt_front"}}, "back": {"placement": {"at": "skirt_back"}}},
        "simulate": {"edge_length_m": 0.04, "tolerance": 1e-3},
        "over": over,
    })
}

type Triangles = Vec<[Vector3<f64>; 3]>;

/// The triangles of a mesh in JSON.
fn triangles(mesh: &Value) -> Triangles {
    let panel = |panel: &Value| -> Triangles {
        let positions: Vec<Vector3<f64>> =
            serde_json::from_value(panel["positions"].clone()).unwrap();
        let corners: Vec<[usize; 3]> = serde_json::from_value(panel["triangles"].clone()).unwrap();
        corners.iter().map(|t| t.map(|v| positions[v])).collect()
    };
    mesh["panels"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(panel)
        .collect()
}

/// True if the segment from `p` to `q` passes through a triangle: its ends are on both sides of the
/// plane, and it passes all three sides in one sense.
fn passes([p, q]: [&Vector3<f64>; 2], [a, b, c]: &[Vector3<f64>; 3]) -> bool {
    let is_left = |a: &Vector3<f64>, b: &Vector3<f64>, c: &Vector3<f64>, d: &Vector3<f64>| {
        (b - a).cross(&(c - a)).dot(&(d - a)) > 0.0
    };
    let side = is_left(p, q, a, b);
    is_left(a, b, c, p) != is_left(a, b, c, q)
        && side == is_left(p, q, b, c)
        && side == is_left(p, q, c, a)
}

/// Pairs of triangles one of which has an edge through the other.
fn crossings(one: &Triangles, other: &Triangles) -> usize {
    let pierces = |s: &[Vector3<f64>; 3], t: &[Vector3<f64>; 3]| {
        (0..3).any(|i| passes([&s[i], &s[(i + 1) % 3]], t))
    };
    let of = |s: &[Vector3<f64>; 3]| {
        let meeting = other.iter().filter(|t| pierces(s, t) || pierces(t, s));
        meeting.count()
    };
    one.iter().map(of).sum()
}

/// True if every corner of `inner` in the middle of the height of `outer` has that around it: a ray
/// away from the axis of the body meets it.
fn is_around(outer: &Triangles, inner: &Triangles) -> bool {
    let heights = outer.iter().flatten().map(|p| p.y);
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| {
        (low.min(y), high.max(y))
    });
    let third = (high - low) / 3.0;
    let corners = inner.iter().flatten();
    let beside: Vec<_> = corners
        .filter(|p| (low + third..high - third).contains(&p.y))
        .collect();
    assert!(beside.len() > 20);
    beside.iter().all(|p| {
        let away = *p + Vector3::new(p.x, 0.0, p.z).normalize();
        outer.iter().any(|t| passes([p, &away], t))
    })
}

#[test]
fn a_garment_is_sewn_over_another_and_one_over_both() {
    let server = Server::start();
    let first = sewn(&server, &tube(0.0, None));
    let beneath = mesh(&server, &first);
    let second = sewn(&server, &tube(0.005, Some(&first)));
    let third = sewn(&server, &tube(0.01, Some(&second)));
    let layers = [&first, &second, &third].map(|id| triangles(&mesh(&server, id)));
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        assert_eq!(crossings(&layers[i], &layers[j]), 0, "{i} {j}");
        assert!(is_around(&layers[j], &layers[i]), "{i} {j}");
    }
    let report = server.get(&format!("/v1/fits/{third}/report")).json();
    assert_eq!(report["self_intersections"], 0, "{report}");

    // The inner garment is what it was, and a copy of it is in the saved file.
    assert_eq!(mesh(&server, &first), beneath);
    let saved = server.get(&format!("/v1/fits/{third}/garment")).json();
    let inner = saved["over"]["panels"].as_array().unwrap();
    let names: Vec<_> = inner.iter().map(|panel| panel["panel"].clone()).collect();
    let expected = [
        "over:over:front",
        "over:over:back",
        "over:front",
        "over:back",
    ];
    assert_eq!(names, expected);
    assert_eq!(inner[0]["positions"], beneath["panels"][0]["positions"]);
    let scene = server.get(&format!("/v1/fits/{third}/scene")).json();
    let count = |mesh: &Value| mesh["panels"][0]["positions"].as_array().unwrap().len();
    let vertices = 2 * (count(&beneath) + count(&mesh(&server, &second)));
    assert_eq!(
        scene["over"]["vertices"].as_array().unwrap().len(),
        vertices
    );

    // Again where no other fit ever was: the saved file is complete in itself.
    let empty = Server::start();
    let saved = server.get(&format!("/v1/fits/{second}/garment")).json();
    let alone = sewn(&empty, &saved);
    let glb = |server: &Server, id: &str| server.get(&format!("/v1/fits/{id}/mesh.glb")).bytes;
    assert!(
        glb(&empty, &alone) == glb(&server, &second),
        "the meshes differ"
    );
}

#[test]
fn what_cannot_be_worn_over_is_refused() {
    let server = Server::start();
    let refused = |garment: &Value, code: &str| {
        let faults = server.post_json("/v1/fits", garment).faults(422);
        assert_eq!(faults, [format!("{code} /over")]);
    };
    let no_fit = "019a0000-0000-7000-8000-000000000000";
    refused(&tube(0.0, Some(no_fit)), "garment/over_unknown");

    let inner = sewn(&server, &tube(0.0, None));
    let mut other = tube(0.005, Some(&inner));
    other["avatar"] =
        json!({"form": {"height_m": 1.68, "bust_m": 0.92, "waist_m": 0.72, "hip_m": 0.98}});
    refused(&other, "garment/over_avatar");
    other["avatar"] = Value::Null;
    refused(&other, "garment/over_avatar");
    let mut through = tube(0.005, Some(&inner));
    through["self_contact"] = json!("off");
    refused(&through, "garment/not_available");
    let mut stepped = tube(0.005, Some(&inner));
    stepped["simulate"]["method"] = json!("implicit_euler");
    refused(&stepped, "garment/not_available");
    let study = json!({"garment": tube(0.005, Some(&inner)), "methods": ["newton"]});
    let faults = server.post_json("/v1/studies", &study).faults(422);
    assert_eq!(faults, ["garment/not_available /garment/over"]);
    let mut wrong = tube(0.005, None);
    wrong["over"] = json!({"avatar": null, "pannels": []});
    let faults = server.post_json("/v1/fits", &wrong).faults(422);
    let expected = [
        "request/missing_field /over/panels",
        "request/unknown_field /over/pannels",
    ];
    assert_eq!(faults, expected);
}

#[test]
fn a_fit_that_has_not_ended_is_worn_under_nothing() {
    let server = Server::with(config(), 0);
    let waiting = server.post_json("/v1/fits", &tube(0.0, None)).json();
    let over = tube(0.005, waiting["id"].as_str());
    let problem = server.post_json("/v1/fits", &over).problem(422);
    let fault = &problem["errors"][0];
    assert_eq!(fault["code"], "garment/over_unfinished");
    assert_eq!(fault["pointer"], "/over");
    assert!(
        fault["detail"].as_str().unwrap().ends_with("is queued"),
        "{fault}"
    );
}
