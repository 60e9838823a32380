//! Bodies of one's own over HTTP: kept, listed, worn and removed.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use seamster::scene::{DressForm, Limbs};
use seamster_fixtures::panels::{pattern, trapezoid};
use seamster_fixtures::server::{Server, config};
use serde_json::{Value, json};
use std::fmt::Write;
use std::time::Duration;

/// A body of known measures as OBJ [cm], z up.
fn body() -> Vec<u8> {
    let form = DressForm {
        limbs: Some(Limbs {
            arms: true,
            legs: true,
        }),
        ..DressForm::default()
    };
    let surface = form.build().unwrap().surface;
    let mut text = String::new();
    for p in &surface.vertices {
        let [x, y, z] = [p.x, -p.z, p.y].map(|x| x * 100.0);
        writeln!(text, "v {x:.6} {y:.6} {z:.6}").unwrap();
    }
    for [a, b, c] in &surface.triangles {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
    }
    text.into_bytes()
}

const OBJ: [(&str, &str); 1] = [("content-type", "model/obj")];

#[test]
fn a_body_of_ones_own_is_kept_once_and_a_garment_sewn_on_it() {
    let server = Server::start();
    let kept = server.send("POST", "/v1/avatars", &OBJ, &body());
    assert_eq!(kept.status, 201, "{}", kept.text());
    let at = kept.header("location").to_owned();
    let avatar = kept.json();
    assert_eq!(avatar["file"]["units"], "cm");
    let waist = avatar["girths"]["waist_m"].as_f64().unwrap();
    assert!((waist - 0.74).abs() < 0.005, "{waist}");
    assert_eq!(server.get(&at).json(), avatar);
    let mesh = server.get(&format!("{at}/mesh"));
    assert_eq!(&mesh.bytes[..4], b"glTF");

    let again = server.send("POST", "/v1/avatars", &OBJ, &body()).json();
    assert_eq!(again["file"]["surface"], avatar["file"]["surface"]);
    assert_ne!(again["id"], avatar["id"]);
    let other = format!("/v1/avatars/{}", again["id"].as_str().unwrap());
    assert_eq!(server.request("DELETE", &other, &[]).status, 204);
    assert_eq!(server.get(&at).status, 200);

    let fit = sewn(&server, &skirt(&avatar["id"]));
    let garment = server.get(&format!("/v1/fits/{fit}/garment")).json();
    let vertices = garment["avatar"]["body"]["vertices"].as_array().unwrap();
    assert_eq!(
        vertices.len(),
        usize::try_from(avatar["file"]["vertex_count"].as_u64().unwrap()).unwrap()
    );
    // the saved file is complete in itself
    assert_eq!(server.request("DELETE", &at, &[]).status, 204);
    let mesh = |fit: &str| server.get(&format!("/v1/fits/{fit}/mesh.json")).json();
    let from_file = sewn(&server, &garment);
    assert_eq!(mesh(&from_file), mesh(&fit));
}

/// A tube about the hips that hangs by its narrow top.
fn skirt(avatar: &Value) -> Value {
    let half = |id: &str| trapezoid(id, 0.6, 0.4, 0.35);
    let run = |panel: &str, from: usize, to: usize| json!({"panel": panel, "from": from, "to": to});
    let seam = |id: &str, from: usize, to: usize| json!({"id": id, "a": run("front", from, to), "b": run("back", 3 - from, 3 - to)});
    json!({
        "pattern": pattern(vec![half("front"), half("back")]),
        "seams": [seam("left", 0, 1), seam("right", 3, 2)],
        "panels": {"front": {"placement": {"at": "skirt_front"}}, "back": {"placement": {"at": "skirt_back"}}},
        "simulate": {"edge_length_m": 0.04, "tolerance": 1e-3},
        "avatar": avatar,
    })
}

fn sewn(server: &Server, garment: &Value) -> String {
    let queued = server.post_json("/v1/fits", garment);
    assert_eq!(queued.status, 202, "{}", queued.text());
    let at = queued.header("location");
    let is_under_way = |fit: &Value| fit["status"] == "queued" || fit["status"] == "running";
    let mut fit = queued.json();
    while is_under_way(&fit) {
        std::thread::sleep(Duration::from_millis(100));
        fit = server.get(at).json();
    }
    assert_eq!(fit["status"], "succeeded", "{fit}");
    fit["id"].as_str().unwrap().to_owned()
}

#[test]
fn files_that_are_no_bodies_are_refused_with_their_place() {
    let server = Server::with(config(), 0);
    let post = |query: &str, kind: &str, bytes: &[u8]| {
        let path = format!("/v1/avatars{query}");
        server.send("POST", &path, &[("content-type", kind)], bytes)
    };
    let faults = post("", "model/obj", b"v 0 0\n").faults(422);
    assert_eq!(faults, ["avatar/file line 1"]);
    let faults = post("", "model/gltf-binary", b"glTF").faults(422);
    assert_eq!(faults, ["avatar/file "]);
    post("", "text/plain", b"v 0 0 0").problem(415);
    post("?units=ell", "model/obj", b"v 0 0 0").problem(422);
}

#[test]
fn landmarks_come_beside_the_file() {
    let server = Server::with(config(), 0);
    let file = body();
    let form = |landmarks: &str| {
        let mut form =
            b"--x\r\ncontent-disposition: form-data; name=\"file\"; filename=\"mine.obj\"\r\n\r\n"
                .to_vec();
        form.extend(&file);
        let part = "\r\n--x\r\ncontent-disposition: form-data; name=\"landmarks\"\r\n\r\n";
        form.extend(part.bytes().chain(landmarks.bytes()));
        form.extend(b"\r\n--x--\r\n");
        form
    };
    let kind = [("content-type", "multipart/form-data; boundary=x")];
    let send = |landmarks: &str| server.send("POST", "/v1/avatars", &kind, &form(landmarks));
    let kept = send(r#"{"bust_back": [0, 10, 123.4]}"#);
    assert_eq!(kept.status, 201, "{}", kept.text());
    let avatar = kept.json();
    assert_eq!(avatar["name"], "mine");
    let at = avatar["landmarks"]["bust_back"].as_array().unwrap();
    let y = at[1].as_f64().unwrap();
    assert!((y - 1.234).abs() < 1e-3, "{y}");
    let faults = send(r#"{"bust_back": [0, 1000, 123.4]}"#).faults(422);
    assert_eq!(faults, ["avatar/landmark /landmarks/bust_back"]);
}
