//! The service over HTTP: guards, problems, patterns, fabrics, fits, events, results, the page.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use seamster_fixtures::dxf::DxfBuilder;
use seamster_fixtures::server::{Answer, Server, config};
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

const NO_ID: &str = "019a0000-0000-7000-8000-000000000000";

/// Sends bytes as they are and returns the answer as it is: for what an HTTP client would not send.
fn raw(server: &Server, request: &str) -> String {
    let mut stream = TcpStream::connect(server.address).unwrap();
    stream.write_all(request.as_bytes()).unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    answer
}

/// A form with these parts: name, file name, bytes.
fn form(parts: &[(&str, &str, &[u8])]) -> Vec<u8> {
    let mut body = vec![];
    for (name, file, bytes) in parts {
        let head = format!(
            "--edge\r\nContent-Disposition: form-data; name=\"{name}\"; filename=\"{file}\"\r\n\r\n"
        );
        body.extend_from_slice(head.as_bytes());
        body.extend_from_slice(bytes);
        body.extend_from_slice(b"\r\n");
    }
    body.extend_from_slice(b"--edge--\r\n");
    body
}

const FORM: (&str, &str) = ("content-type", "multipart/form-data; boundary=edge");
const JSON: (&str, &str) = ("content-type", "application/json");

#[test]
fn probes_answer() {
    let server = Server::start();
    for path in ["/health/live", "/health/ready"] {
        let answer = server.get(path);
        assert_eq!(answer.status, 200);
        assert_eq!(answer.json()["status"], "ok");
    }
}

#[test]
fn what_is_not_there_is_a_problem_that_names_what_is() {
    let server = Server::start();
    for path in [
        "/nothing",
        "/v1/textiles",
        "/v1/fits/x/y/z",
        "/../Cargo.toml",
        "/node_modules/three/package.json",
    ] {
        let problem = server.get(path).problem(404);
        assert!(
            problem["detail"]
                .as_str()
                .unwrap()
                .contains("/openapi.json"),
            "{problem}"
        );
    }
    for path in [
        "/v1/patterns/",
        "/v1/fits/",
        "/v1/studies/",
        "/v1/avatars/",
        "/v1/fabrics/",
    ] {
        server.get(&format!("{path}{NO_ID}")).problem(404);
    }
    server.get("/v1/fits/not-an-id").problem(404);
    server
        .request("DELETE", &format!("/v1/fits/{NO_ID}"), &[])
        .problem(404);
    for part in [
        "mesh",
        "mesh.glb",
        "mesh.obj",
        "mesh.json",
        "picture.png",
        "report",
        "garment",
        "scene",
        "events",
    ] {
        server.get(&format!("/v1/fits/{NO_ID}/{part}")).problem(404);
    }
}

#[test]
fn a_method_that_is_not_there_is_a_problem_with_allow() {
    let server = Server::start();
    let answer = server.request("DELETE", "/v1/fits", &[]);
    answer.problem(405);
    assert!(answer.header("allow").contains("POST"), "{answer:?}");
    server.request("POST", "/index.html", &[]).problem(405);
}

#[test]
fn every_answer_has_an_id_and_forbids_sniffing() {
    let server = Server::start();
    for path in ["/", "/v1/fabrics", "/nothing", "/health/live"] {
        let answer = server.get(path);
        assert!(!answer.header("x-request-id").is_empty(), "{path}");
        assert_eq!(answer.header("x-content-type-options"), "nosniff", "{path}");
        assert!(
            answer
                .header("content-security-policy")
                .starts_with("default-src 'none'"),
            "{path}"
        );
    }
    let answer = server.request("GET", "/health/live", &[("x-request-id", "mine")]);
    assert_eq!(answer.header("x-request-id"), "mine");
}

#[test]
fn a_foreign_host_is_misdirected() {
    let mut config = config();
    config.hosts = vec!["sew.example".to_owned()];
    let server = Server::with(config, 0);
    for (host, status) in [
        ("localhost", 200),
        ("sew.example", 200),
        ("evil.example", 421),
        ("", 421),
    ] {
        let request =
            format!("GET /health/live HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
        let answer = raw(&server, &request);
        assert!(
            answer.starts_with(&format!("HTTP/1.1 {status} ")),
            "{host}: {answer}"
        );
    }
}

#[test]
fn a_writing_call_from_a_foreign_page_is_refused() {
    let server = Server::with(config(), 0);
    let own = format!("http://{}", server.address);
    for (origin, status) in [
        ("https://evil.example", 403),
        ("null", 403),
        (own.as_str(), 422),
    ] {
        let headers = [JSON, ("origin", origin)];
        let answer = server.send("POST", "/v1/fabrics", &headers, b"{}");
        answer.problem(status);
    }
    let reading = server.request("GET", "/v1/fabrics", &[("origin", "https://evil.example")]);
    assert_eq!(reading.status, 200);
    assert_eq!(reading.header("access-control-allow-origin"), "");
}

#[test]
fn with_tokens_only_they_may_call() {
    let mut config = config();
    config.tokens = vec!["secret".to_owned()];
    let server = Server::with(config, 0);
    for path in [
        "/v1/fabrics",
        "/v1/patterns",
        "/v1/fits",
        "/v1/studies",
        "/metrics",
    ] {
        let refused = server.get(path);
        refused.problem(401);
        assert!(
            refused.header("www-authenticate").starts_with("Bearer"),
            "{path}"
        );
        server
            .request("GET", path, &[("authorization", "Bearer wrong")])
            .problem(401);
        let let_in = server.request("GET", path, &[("authorization", "Bearer secret")]);
        assert_eq!(let_in.status, 200, "{path}");
    }
    for path in [
        "/",
        "/health/live",
        "/health/ready",
        "/openapi.json",
        "/docs/",
    ] {
        assert_eq!(server.get(path).status, 200, "{path}");
    }
}

#[test]
fn the_page_is_whole_and_runs_under_its_policy() {
    let server = Server::start();
    let page = server.get("/");
    assert_eq!(page.header("content-type"), "text/html; charset=utf-8");
    let policy = page.header("content-security-policy");
    assert!(!policy.contains("unsafe"), "{policy}");
    let html = page.text();
    assert_eq!(
        html.contains("type=\"importmap\""),
        policy.contains("'sha256-"),
        "{policy}"
    );
    let three = "/node_modules/three";
    for (path, kind) in [
        (
            format!("{three}/build/three.module.min.js"),
            "text/javascript; charset=utf-8",
        ),
        (
            format!("{three}/build/three.core.min.js"),
            "text/javascript; charset=utf-8",
        ),
        (
            format!("{three}/examples/jsm/controls/OrbitControls.js"),
            "text/javascript; charset=utf-8",
        ),
        (
            format!("{three}/examples/jsm/loaders/GLTFLoader.js"),
            "text/javascript; charset=utf-8",
        ),
    ] {
        let file = server.get(&path);
        assert_eq!(
            (file.status, file.header("content-type")),
            (200, kind),
            "{path}"
        );
        let etag = file.header("etag");
        assert!(etag.starts_with('"'), "{path}");
        let again = server.request("GET", &path, &[("if-none-match", etag)]);
        assert_eq!((again.status, again.bytes.len()), (304, 0), "{path}");
    }
}

#[test]
fn the_api_page_needs_no_other_host() {
    let server = Server::start();
    let page = server.get("/docs/");
    assert_eq!(page.status, 200);
    assert!(
        !page.text().contains("//"),
        "a link to somewhere else: {}",
        page.text()
    );
    assert_eq!(server.get("/docs/swagger-ui-bundle.js").status, 200);
    assert!(
        server
            .get("/docs/swagger-initializer.js")
            .text()
            .contains("/openapi.json")
    );
}

#[test]
fn metrics_count_requests_by_route() {
    let server = Server::start();
    server.get(&format!("/v1/fits/{NO_ID}"));
    server.get("/nothing/like/this");
    let answer = server.get("/metrics");
    assert!(answer.header("content-type").starts_with("text/plain"));
    let text = answer.text();
    let line = "seamster_http_request_seconds_count{method=\"GET\",route=\"/v1/fits/{id}\",status=\"404\"} 1";
    assert!(text.contains(line), "{text}");
    assert!(
        text.contains("seamster_fits{status=\"queued\"} 0"),
        "{text}"
    );
    assert!(!text.contains("like/this"), "{text}");
}

#[test]
fn syntax_is_told_by_line_and_column() {
    let server = Server::start();
    let answer = server.send("POST", "/v1/fits", &[JSON], b"{\n  \"seams\": ]\n}");
    assert_eq!(answer.faults(400), ["request/syntax line 2 column 12"]);
}

#[test]
fn a_body_of_another_type_is_refused() {
    let server = Server::start();
    for path in ["/v1/fits", "/v1/studies", "/v1/fabrics", "/v1/avatars"] {
        server
            .send("POST", path, &[("content-type", "text/plain")], b"{}")
            .problem(415);
    }
}

#[test]
fn a_specification_is_sent_as_json_or_in_a_form() {
    let server = Server::start();
    let answer = server.send("POST", "/v1/patterns", &[JSON], b"{}");
    assert_eq!(answer.faults(422), ["pattern/not_garmentcode "]);
    let spec = br#"{"pattern": {"panels": {"patch": {
        "translation": [0, 100, 20], "rotation": [0, 0, 0],
        "vertices": [[0, 0], [10, 0], [10, 10], [0, 10]],
        "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]
    }}}, "properties": {"units_in_meter": 100}}"#;
    let sent = [
        server.send("POST", "/v1/patterns", &[JSON], spec),
        server.send(
            "POST",
            "/v1/patterns?rotation_order=zyx",
            &[FORM],
            &form(&[("file", "patch_specification.json", spec)]),
        ),
    ];
    for answer in sent {
        assert_eq!(answer.status, 201);
        let pattern = answer.json();
        assert_eq!(pattern["source"]["format"], "garmentcode");
        assert_eq!(pattern["placements"]["patch"]["at"], "origin");
    }
}

#[test]
fn a_body_above_its_limit_is_refused() {
    let mut config = config();
    config.limits.dxf_bytes = 1000;
    config.limits.json_bytes = 1000;
    let server = Server::with(config, 0);
    server
        .send("POST", "/v1/patterns", &[], &[b'0'; 1001])
        .problem(413);
    server
        .send(
            "POST",
            "/v1/patterns",
            &[FORM],
            &form(&[("file", "a.dxf", &[b'0'; 1001])]),
        )
        .problem(413);
    server
        .send("POST", "/v1/patterns", &[], &[b'0'; 1 << 20])
        .problem(413);
    server
        .send(
            "POST",
            "/v1/fits",
            &[FORM],
            &form(&[("pattern", "a.dxf", b"0"), ("garment", "g", &[b' '; 1001])]),
        )
        .problem(413);
    server
        .send("POST", "/v1/fabrics", &[JSON], &[b' '; 1 << 20])
        .problem(413);
}

#[test]
fn all_faults_of_a_garment_come_at_once() {
    let server = Server::start();
    let garment = json!({
        "seams": [{"id": "side", "a": {"panel": "front", "frm": 0, "to": 1}, "b": 7}],
        "simulate": {"edge_lenght_m": 0.01},
        "wind": {"velocity_m_s": "much"},
    });
    let expected = [
        "request/missing_field /seams/0/a/from",
        "request/unknown_field /seams/0/a/frm",
        "request/unknown_field /simulate/edge_lenght_m",
        "request/wrong_type /seams/0/b",
        "request/wrong_type /wind/velocity_m_s",
    ];
    assert_eq!(server.post_json("/v1/fits", &garment).faults(422), expected);
    let problem = server.post_json("/v1/fits", &garment).json();
    assert!(
        problem
            .to_string()
            .contains("did you mean \\\"edge_length_m\\\"?"),
        "{problem}"
    );
}

#[test]
fn faults_of_the_file_and_of_the_garment_come_together() {
    let server = Server::start();
    let garment = br#"{"seams": [], "colour": "red"}"#;
    let body = form(&[
        ("pattern", "a.dxf", b"this is no DXF"),
        ("garment", "g.json", garment),
    ]);
    let faults = server.send("POST", "/v1/fits", &[FORM], &body).faults(422);
    assert!(
        faults.contains(&"request/unknown_field /colour".to_owned()),
        "{faults:?}"
    );
    assert!(
        faults.iter().any(|fault| fault.starts_with("pattern/")),
        "{faults:?}"
    );
}

#[test]
fn a_form_with_other_parts_is_refused() {
    let server = Server::start();
    let body = form(&[("flie", "a.dxf", b"")]);
    assert_eq!(
        server
            .send("POST", "/v1/patterns", &[FORM], &body)
            .faults(422),
        ["request/unexpected_part /flie"]
    );
    assert_eq!(
        server
            .send("POST", "/v1/patterns", &[FORM], &form(&[]))
            .faults(422),
        ["request/missing_part /file"]
    );
    let body = form(&[("garment", "g.json", b"{}")]);
    assert_eq!(
        server.send("POST", "/v1/fits", &[FORM], &body).faults(422),
        ["request/missing_part /pattern"]
    );
    server
        .send("POST", "/v1/patterns", &[FORM], b"no form at all")
        .problem(400);
}

#[test]
fn a_misspelt_query_is_refused() {
    let server = Server::start();
    for path in [
        "/v1/fits?limt=3",
        "/v1/fits?limit=0",
        "/v1/fits?limit=201",
        "/v1/fits?status=done",
        "/v1/patterns?cursor=x",
    ] {
        server.get(path).problem(422);
    }
    for query in ["units=furlong", "encoding=furlong"] {
        let path = format!("/v1/patterns?{query}");
        server.send("POST", &path, &[], b"0").problem(422);
    }
}

#[test]
fn an_own_fabric_is_kept_and_listed() {
    let server = Server::start();
    let mut fabric = json!({
        "name": "Tent canvas", "density_kg_m2": 0.4, "thickness_m": 0.0008, "stretch_warp_n_m": 9000,
        "stretch_weft_n_m": 7000.0, "shear_n_m": 800, "bending_warp_n_m": 1e-4, "bending_weft_n_m": 8e-5,
        "friction": 0.4, "damping_ratio": 0.1, "source": "measured",
    });
    let kept = server.post_json("/v1/fabrics", &fabric);
    assert_eq!(kept.status, 201, "{}", kept.text());
    let item = kept.json();
    assert_eq!(server.get(kept.header("location")).json(), item);
    let list = server.get("/v1/fabrics").json();
    assert!(
        list["fabrics"].as_array().unwrap().contains(&item),
        "{list}"
    );

    fabric["density_kg_m2"] = json!(0);
    fabric["friction"] = json!(-0.1);
    let faults = server.post_json("/v1/fabrics", &fabric).faults(422);
    assert_eq!(
        faults,
        [
            "fabric/coefficient /density_kg_m2",
            "fabric/coefficient /friction"
        ]
    );
}

fn sample(name: &str) -> Vec<u8> {
    let path = format!("{}/static/samples/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read(path).unwrap()
}

/// The skirt's garment, coarse enough for a test to sew it in a moment.
fn skirt() -> Value {
    let mut garment: Value = serde_json::from_slice(&sample("skirt.garment.json")).unwrap();
    garment["simulate"] = json!({"edge_length_m": 0.04, "tolerance": 1e-3});
    garment
}

fn skirt_form(garment: &Value) -> Vec<u8> {
    let garment = garment.to_string();
    form(&[
        ("pattern", "skirt.dxf", &sample("skirt.dxf")),
        ("garment", "g.json", garment.as_bytes()),
    ])
}

fn submit(server: &Server, headers: &[(&str, &str)]) -> Answer {
    server.send(
        "POST",
        "/v1/fits",
        &[&[FORM], headers].concat(),
        &skirt_form(&skirt()),
    )
}

#[test]
fn a_pattern_is_kept_until_it_is_removed() {
    let server = Server::with(config(), 0);
    let kept = server.send(
        "POST",
        "/v1/patterns",
        &[FORM],
        &form(&[("file", "skirt.dxf", &sample("skirt.dxf"))]),
    );
    assert_eq!(kept.status, 201, "{}", kept.text());
    let at = kept.header("location");
    let pattern = server.get(at).json();
    assert_eq!(pattern, kept.json());
    assert_eq!(
        at,
        format!("/v1/patterns/{}", pattern["id"].as_str().unwrap())
    );
    let plain = server.send("POST", "/v1/patterns?units=mm", &[], &sample("top.dxf"));
    assert_eq!(plain.status, 201, "{}", plain.text());

    let first = server.get("/v1/patterns?limit=1").json();
    assert_eq!(first["patterns"][0]["id"], plain.json()["id"]);
    let cursor = first["next_cursor"].as_str().unwrap();
    let second = server
        .get(&format!("/v1/patterns?limit=1&cursor={cursor}"))
        .json();
    assert_eq!(second["patterns"][0]["id"], pattern["id"]);
    assert_eq!(second["patterns"][0]["panel_count"], 3);

    assert_eq!(server.request("DELETE", at, &[]).status, 204);
    server.request("DELETE", at, &[]).problem(404);
    server.get(at).problem(404);
}

#[test]
fn a_pattern_is_drawn() {
    let server = Server::with(config(), 0);
    let kept = server.send("POST", "/v1/patterns", &[], &sample("skirt.dxf"));
    let at = format!("{}/drawing.svg", kept.header("location"));
    let drawing = server.get(&at);
    assert_eq!(drawing.status, 200);
    assert_eq!(drawing.header("content-type"), "image/svg+xml");
    assert_eq!(drawing.header("x-content-type-options"), "nosniff");
    let policy = drawing.header("content-security-policy");
    assert!(policy.contains("default-src 'none'"), "{policy}");
    let svg = drawing.text();
    assert!(svg.starts_with("<svg "), "{svg}");
    for panel in kept.json()["panels"].as_array().unwrap() {
        let name = panel["name"].as_str().unwrap();
        assert!(svg.contains(&format!("<title>{name}</title>")), "{name}");
    }
    let etag = drawing.header("etag");
    let again = server.request("GET", &at, &[("if-none-match", etag)]);
    assert_eq!((again.status, again.bytes.len()), (304, 0));
    server.request("POST", &at, &[]).problem(405);
    server
        .get(&format!("/v1/patterns/{NO_ID}/drawing.svg"))
        .problem(404);
}

#[test]
fn a_pattern_is_given_out_as_the_files_of_other_programs() {
    let server = Server::with(config(), 0);
    let kept = server.send("POST", "/v1/patterns", &[], &sample("skirt.dxf"));
    let at = kept.header("location");
    let panels = kept.json()["panels"].clone();
    for (file, kind) in [
        ("pattern.dxf", "image/vnd.dxf"),
        ("specification.json", JSON.1),
    ] {
        let given = server.get(&format!("{at}/{file}"));
        assert_eq!((given.status, given.header("content-type")), (200, kind));
        let again = server.send(
            "POST",
            "/v1/patterns",
            &[("content-type", kind)],
            &given.bytes,
        );
        let ids = |panels: &Value| -> Vec<Value> {
            let panels = panels.as_array().unwrap().iter();
            panels.map(|panel| panel["name"].clone()).collect()
        };
        assert_eq!(again.status, 201, "{}", again.text());
        assert_eq!(ids(&again.json()["panels"]), ids(&panels));
        let etag = given.header("etag");
        let unchanged = server.request("GET", &format!("{at}/{file}"), &[("if-none-match", etag)]);
        assert_eq!((unchanged.status, unchanged.bytes.len()), (304, 0));
        server
            .get(&format!("/v1/patterns/{NO_ID}/{file}"))
            .problem(404);
    }
    let specification = server.get(&format!("{at}/specification.json"));
    assert!(
        specification
            .header("seamster-left-out")
            .contains("notches")
    );
}

#[test]
fn seams_are_checked_on_what_is_left_of_panels_given_as_cut() {
    let server = Server::with(config(), 0);
    let kept = server.send("POST", "/v1/patterns", &[], &sample("skirt.dxf"));
    let pattern = kept.json();
    let panel = pattern["panels"][0]["id"].as_str().unwrap();
    let path = format!("{}/seams/check", kept.header("location"));
    let seam = json!({"id": "s", "a": {"panel": panel, "from": 0, "to": 1}, "b": {"panel": panel, "from": 2, "to": 3}});
    let length = |width: f64| {
        let asked = json!({"seams": [seam], "panels": {panel: {"seam_allowance_m": width}}});
        let answer = server.post_json(&path, &asked);
        assert_eq!(answer.status, 200, "{}", answer.text());
        answer.json()["seams"][0]["length_a_m"].as_f64().unwrap()
    };
    assert!(length(0.01) < length(0.0) - 0.01);
    let asked = json!({"seams": [seam], "panels": {panel: {"seam_allowance_m": -0.01}}});
    let pointer = format!("/panels/{panel}/seam_allowance_m");
    assert_eq!(
        server.post_json(&path, &asked).faults(422),
        [format!("garment/number {pointer}")]
    );
}

#[test]
fn stated_encoding_overrides_that_of_the_file() {
    let server = Server::with(config(), 0);
    let corners = [[0.0, 0.0], [300.0, 0.0], [300.0, 400.0]];
    let file = DxfBuilder::metric()
        .header("$DWGCODEPAGE", 3, "ANSI_1251")
        .block("ПЕРЕД")
        .run("1", true, &corners)
        .text_of_file();
    let (file, ..) = encoding_rs::WINDOWS_1251.encode(&file);
    let name = |query: &str| {
        let answer = server.send("POST", &format!("/v1/patterns{query}"), &[], &file);
        answer.json()["panels"][0]["name"].clone()
    };
    assert_eq!(name(""), "ПЕРЕД");
    assert_eq!(name("?encoding=windows-1252"), "ÏÅÐÅÄ");
}

#[test]
fn stated_units_override_those_of_the_file() {
    let server = Server::with(config(), 0);
    let area = |units: &str| {
        let answer = server.send(
            "POST",
            &format!("/v1/patterns{units}"),
            &[],
            &sample("skirt.dxf"),
        );
        answer.json()["panels"][0]["area_m2"].as_f64().unwrap()
    };
    let ratio = area("?units=cm") / area("");
    assert!((ratio - 100.0).abs() < 1e-6, "{ratio}");
}

#[test]
fn seams_are_checked_with_all_their_faults() {
    let server = Server::with(config(), 0);
    let kept = server.send("POST", "/v1/patterns", &[], &sample("skirt.dxf"));
    let check = format!("{}/seams/check", kept.header("location"));
    let right = server.post_json(&check, &skirt()).json();
    assert_eq!(right["ok"], true, "{right}");
    assert_eq!(
        right["seams"].as_array().unwrap().len(),
        skirt()["seams"].as_array().unwrap().len()
    );

    let mut wrong = json!({"seams": skirt()["seams"]});
    wrong["seams"][0]["a"]["panel"] = json!("sleeve");
    wrong["seams"][1]["b"]["to"] = json!(99);
    let found = server.post_json(&check, &wrong).json();
    assert_eq!(found["ok"], false);
    assert_eq!(
        found["seams"][0]["errors"][0]["pointer"], "/seams/0/a/panel",
        "{found}"
    );
    assert_eq!(
        found["seams"][1]["errors"][0]["pointer"], "/seams/1/b/to",
        "{found}"
    );

    let fine = json!({"seams": [], "simulate": {"edge_length_m": 0.0}});
    assert_eq!(
        server.post_json(&check, &fine).faults(422),
        ["request/out_of_range /simulate/edge_length_m"]
    );
    assert_eq!(
        server
            .post_json(&check, &json!({"seams": "suggest"}))
            .faults(422),
        ["seam/nothing_to_check /seams"]
    );
    server
        .post_json(&format!("/v1/patterns/{NO_ID}/seams/check"), &skirt())
        .problem(404);
}

/// The seams of a suggestion as a garment takes them.
fn as_garment_takes(suggestion: &Value) -> Vec<Value> {
    let seams = suggestion["seams"].as_array().unwrap().iter();
    let told = seams.map(|seam| {
        let confidence = seam["confidence"].as_f64().unwrap();
        assert!((0.0..=1.0).contains(&confidence), "{confidence}");
        assert!(!seam["because"].as_str().unwrap().is_empty());
        seam.clone()
    });
    told.collect()
}

/// Panels that seams run along, sorted.
fn sewn_panels(seams: &[Value]) -> Vec<String> {
    let sides = seams.iter().flat_map(|seam| [&seam["a"], &seam["b"]]);
    let runs = sides.flat_map(|side| match side {
        Value::Array(runs) => runs.iter().collect(),
        run => vec![run],
    });
    let mut panels: Vec<_> = runs
        .map(|run| run["panel"].as_str().unwrap().to_owned())
        .collect();
    panels.sort();
    panels.dedup();
    panels
}

#[test]
fn suggested_seams_can_be_sewn_as_they_are() {
    let server = Server::with(config(), 0);
    for name in ["skirt", "top"] {
        let kept = server.send("POST", "/v1/patterns", &[], &sample(&format!("{name}.dxf")));
        let at = kept.header("location");
        let found = server.post_json(&format!("{at}/seams/suggest"), &json!({}));
        assert_eq!(found.status, 200, "{}", found.text());
        let found = found.json();
        assert_eq!(found["warnings"], json!([]), "{name}");
        let seams = as_garment_takes(&found);
        let pattern = kept.json();
        let panels = pattern["panels"].as_array().unwrap().iter();
        let mut panels: Vec<_> = panels.map(|panel| panel["id"].as_str().unwrap()).collect();
        panels.sort_unstable();
        assert_eq!(sewn_panels(&seams), panels);
        for panel in panels {
            assert!(found["panels"][panel]["placement"].is_object(), "{found}");
        }
        let garment = json!({"seams": seams, "panels": found["panels"]});
        let check = server
            .post_json(&format!("{at}/seams/check"), &garment)
            .json();
        assert_eq!(check["ok"], true, "{check}");
        let mut garment = garment;
        garment["pattern"] = pattern["id"].clone();
        let fit = server.post_json("/v1/fits", &garment);
        assert_eq!(fit.status, 202, "{}", fit.text());
    }
}

#[test]
fn suggestions_are_asked_for_with_nothing_or_an_empty_object() {
    let server = Server::with(config(), 0);
    let kept = server.send("POST", "/v1/patterns", &[], &sample("skirt.dxf"));
    let path = format!("{}/seams/suggest", kept.header("location"));
    let plain = server.request("POST", &path, &[]);
    assert_eq!(plain.status, 200, "{}", plain.text());
    assert_eq!(plain.bytes, server.post_json(&path, &json!({})).bytes);
    assert_eq!(
        server.post_json(&path, &json!({"sleeves": 2})).faults(422),
        ["request/unknown_field /sleeves"]
    );
    assert_eq!(
        server.post_json(&path, &json!([])).faults(422),
        ["request/wrong_type "]
    );
    server
        .send("POST", &path, &[("content-type", "text/plain")], b"{}")
        .problem(415);
    server
        .post_json(&format!("/v1/patterns/{NO_ID}/seams/suggest"), &json!({}))
        .problem(404);
}

/// The pattern of the skirt with a square patch beside it that goes nowhere.
fn skirt_and_patch(server: &Server) -> Value {
    let kept = server.send("POST", "/v1/patterns", &[], &sample("skirt.dxf"));
    let mut pattern = kept.json();
    let corners = [[0.0, 0.0], [0.0, 0.03], [0.03, 0.03], [0.03, 0.0]];
    let edge = |i: usize| json!({"index": i, "from": i, "to": (i + 1) % 4, "length_m": 0.03, "points": [corners[i], corners[(i + 1) % 4]]});
    let corner = |i: usize| json!({"index": i, "x": corners[i][0], "y": corners[i][1]});
    let patch = json!({"id": "patch", "name": "PATCH", "area_m2": 9e-4, "drawn_area_m2": 9e-4, "perimeter_m": 0.12,
        "corners": [corner(0), corner(1), corner(2), corner(3)], "edges": [edge(0), edge(1), edge(2), edge(3)]});
    pattern["panels"].as_array_mut().unwrap().push(patch);
    pattern
}

#[test]
fn a_garment_may_leave_its_seams_to_the_service() {
    let server = Server::start();
    let mut garment = skirt();
    garment["seams"] = json!("suggest");
    garment["panels"] = json!({});
    garment["pattern"] = skirt_and_patch(&server);
    let headers = [JSON, ("prefer", "wait=60")];
    let fit = server.send("POST", "/v1/fits", &headers, garment.to_string().as_bytes());
    assert_eq!(fit.status, 200, "{}", fit.text());
    assert_eq!(fit.json()["status"], "succeeded", "{}", fit.text());
    let at = fit.header("location");

    let pattern = server.get("/v1/patterns").json()["patterns"][0]["id"].clone();
    let path = format!("/v1/patterns/{}/seams/suggest", pattern.as_str().unwrap());
    let found = server.post_json(&path, &json!({})).json();
    let saved = server.get(&format!("{at}/garment")).json();
    assert_eq!(saved["seams"], json!(as_garment_takes(&found)));
    for (id, panel) in found["panels"].as_object().unwrap() {
        assert_eq!(saved["panels"][id]["placement"], panel["placement"], "{id}");
    }
    assert_eq!(saved["pattern"]["panels"].as_array().unwrap().len(), 3);

    let report = server.get(&format!("{at}/report")).json();
    assert_eq!(report["converged"], true, "{report}");
    let left_out = |report: &Value| {
        let warnings = report["warnings"].as_array().unwrap().iter();
        let mut found = warnings.filter(|warning| warning["code"] == "seam/left_out");
        found.next().map(|warning| warning["detail"].to_string())
    };
    assert!(left_out(&report).unwrap().contains("patch"), "{report}");
    the_saved_garment_gives_the_same_mesh(&server, at);
    let again = server.send("POST", "/v1/fits", &headers, saved.to_string().as_bytes());
    let again = server.get(&format!("{}/report", again.header("location")));
    assert_eq!(left_out(&again.json()), left_out(&report));
}

#[test]
fn seams_of_what_is_no_garment_are_not_suggested() {
    let server = Server::with(config(), 0);
    let mut pattern = skirt_and_patch(&server);
    let mut patch = pattern["panels"].as_array_mut().unwrap().pop().unwrap();
    // A triangle is no part of anything.
    patch["corners"].as_array_mut().unwrap().pop();
    let corners = patch["corners"].clone();
    let edges = patch["edges"].as_array_mut().unwrap();
    edges.pop();
    edges[2]["to"] = json!(0);
    edges[2]["points"][1] = json!([corners[0]["x"], corners[0]["y"]]);
    pattern["panels"] = json!([patch]);
    let faults = server
        .post_json("/v1/fits", &json!({"pattern": pattern, "seams": "suggest"}))
        .faults(422);
    assert_eq!(faults, ["seam/none_suggested /seams"]);
}

#[test]
fn an_avatar_is_made_from_measurements() {
    let server = Server::with(config(), 0);
    let form = json!({"form": {"height_m": 1.7, "bust_m": 0.9, "waist_m": 0.7, "hip_m": 0.95}});
    let kept = server.post_json("/v1/avatars", &form);
    assert_eq!(kept.status, 201, "{}", kept.text());
    let at = kept.header("location");
    assert_eq!(server.get(at).json(), kept.json());
    let mesh = server.get(&format!("{at}/mesh"));
    assert_eq!(
        (mesh.header("content-type"), &mesh.bytes[..4]),
        ("model/gltf-binary", &b"glTF"[..])
    );
    assert_eq!(
        server.get("/v1/avatars").json()["avatars"]
            .as_array()
            .unwrap()
            .len(),
        1
    );
    assert_eq!(server.request("DELETE", at, &[]).status, 204);
    server.get(&format!("{at}/mesh")).problem(404);

    let faults = server
        .post_json(
            "/v1/avatars",
            &json!({"form": {"height_m": 17, "bust_m": 0.9, "waist_m": 0.7, "hip_m": -1}}),
        )
        .faults(422);
    let places: Vec<_> = faults
        .iter()
        .filter_map(|fault| fault.split(' ').nth(1))
        .collect();
    assert!(
        places.contains(&"/form/height_m") && places.contains(&"/form/hip_m"),
        "{faults:?}"
    );
}

#[test]
fn what_a_garment_means_is_checked_before_it_is_queued() {
    let server = Server::with(config(), 0);
    let mut garment = skirt();
    garment["default_fabric"] = json!("chain-mail");
    garment["pins"] = json!([{"panel": "hood", "corner": 0}]);
    let faults = server
        .send("POST", "/v1/fits", &[FORM], &skirt_form(&garment))
        .faults(422);
    let places: Vec<_> = faults
        .iter()
        .filter_map(|fault| fault.split(' ').nth(1))
        .collect();
    assert!(places.contains(&"/default_fabric"), "{faults:?}");
    assert!(
        places.iter().any(|place| place.starts_with("/pins/0")),
        "{faults:?}"
    );

    garment = skirt();
    garment["pattern"] = json!(NO_ID);
    assert_eq!(
        server
            .send("POST", "/v1/fits", &[FORM], &skirt_form(&garment))
            .faults(422),
        ["fit/two_patterns /pattern"]
    );
    let faults = server.post_json("/v1/fits", &garment).faults(422);
    assert!(
        faults.iter().any(|fault| fault.ends_with(" /pattern")),
        "{faults:?}"
    );
    assert_eq!(server.get("/v1/fits").json()["fits"], json!([]));
}

#[test]
fn a_key_makes_a_repeated_request_the_same_fit() {
    let server = Server::with(config(), 0);
    let key = [("idempotency-key", "monday")];
    let first = submit(&server, &key);
    assert_eq!(first.status, 202, "{}", first.text());
    let again = submit(&server, &key);
    assert_eq!(
        (again.status, again.header("location")),
        (202, first.header("location"))
    );
    let mut other = skirt();
    other["friction"] = json!(0.5);
    let reused = server.send("POST", "/v1/fits", &[FORM, key[0]], &skirt_form(&other));
    assert_eq!(reused.faults(422), ["fit/key_reused /Idempotency-Key"]);
    assert_ne!(
        submit(&server, &[]).header("location"),
        first.header("location")
    );
    assert_eq!(
        server.get("/v1/fits").json()["fits"]
            .as_array()
            .unwrap()
            .len(),
        2
    );
}

#[test]
fn a_full_queue_says_when_to_try_again() {
    let mut config = config();
    config.limits.queued_jobs = 1;
    let server = Server::with(config, 0);
    assert_eq!(submit(&server, &[]).status, 202);
    let full = submit(&server, &[]);
    full.problem(503);
    assert!(full.header("retry-after").parse::<u32>().unwrap() > 0);
}

#[test]
fn a_wait_ends_when_its_time_is_over() {
    let server = Server::with(config(), 0);
    let begun = Instant::now();
    let answer = submit(&server, &[("prefer", "wait=1")]);
    assert_eq!(answer.status, 202);
    assert_eq!(answer.header("preference-applied"), "wait=1");
    assert!(begun.elapsed() >= Duration::from_secs(1));
}

#[test]
fn a_waiting_fit_is_listed_and_canceled_at_once() {
    let server = Server::with(config(), 0);
    let queued = submit(&server, &[]);
    let fit = queued.json();
    let at = queued.header("location").to_owned();
    assert_eq!(fit["status"], "queued");
    for (name, path) in [
        ("mesh", "/mesh"),
        ("report", "/report"),
        ("events", "/events"),
        ("garment", "/garment"),
        ("scene", "/scene"),
        ("cancel", ""),
    ] {
        assert_eq!(fit["links"][name], format!("{at}{path}"));
    }
    assert_eq!(
        server.get("/v1/fits?status=queued").json()["fits"][0]["id"],
        fit["id"]
    );
    assert_eq!(
        server.get("/v1/fits?status=failed").json()["fits"],
        json!([])
    );
    for part in ["mesh", "report"] {
        server.get(&format!("{at}/{part}")).problem(409);
    }
    let scene = server.get(&format!("{at}/scene"));
    assert_eq!(scene.json()["schema"], "seamster/scene/1");

    let canceled = server.request("DELETE", &at, &[]);
    assert_eq!(
        (canceled.status, &canceled.json()["status"]),
        (200, &json!("canceled"))
    );
    assert_eq!(server.request("DELETE", &at, &[]).json(), canceled.json());
    assert_eq!(server.get(&at).json(), canceled.json());
    server.get(&format!("{at}/mesh")).problem(404);
    let events = server.get(&format!("{at}/events"));
    assert_eq!(events.header("content-type"), "text/event-stream");
    assert!(events.text().contains("event: status"), "{}", events.text());
    assert!(
        events.text().contains("\"status\":\"canceled\""),
        "{}",
        events.text()
    );
}

#[test]
fn a_fit_is_sewn_followed_and_fetched() {
    let server = Server::start();
    let queued = submit(&server, &[]);
    let at = queued.header("location").to_owned();
    let events = server.get(&format!("{at}/events")).text();
    let ids: Vec<u64> = events
        .lines()
        .filter_map(|line| line.strip_prefix("id: "))
        .map(|id| id.parse().unwrap())
        .collect();
    assert!(ids.is_sorted() && ids.len() > 2, "{events}");
    assert!(events.contains("event: progress"), "{events}");
    let fit = server.get(&at).json();
    assert_eq!(fit["status"], "succeeded", "{fit}");
    assert_eq!(fit["error"], Value::Null);

    let last = ids.last().unwrap().to_string();
    let resumed = server
        .request("GET", &format!("{at}/events"), &[("last-event-id", "0")])
        .text();
    assert!(resumed.contains("\"succeeded\""), "{resumed}");
    assert!(
        !server
            .request(
                "GET",
                &format!("{at}/events"),
                &[("last-event-id", "9007199254740991")]
            )
            .text()
            .contains("data:")
    );
    assert!(!last.is_empty());
    server
        .request("GET", &format!("{at}/events"), &[("last-event-id", "x")])
        .problem(422);

    results_are_whole(&server, &at);
    the_saved_garment_gives_the_same_mesh(&server, &at);
}

fn results_are_whole(server: &Server, at: &str) {
    let glb = server.get(&format!("{at}/mesh.glb"));
    assert_eq!(
        (glb.header("content-type"), &glb.bytes[..4]),
        ("model/gltf-binary", &b"glTF"[..])
    );
    assert_eq!(server.get(&format!("{at}/mesh")).bytes, glb.bytes);
    for (accept, part) in [
        ("model/obj", "mesh.obj"),
        ("model/ply", "mesh.ply"),
        ("application/json", "mesh.json"),
    ] {
        let chosen = server.request("GET", &format!("{at}/mesh"), &[("accept", accept)]);
        assert_eq!(chosen.header("content-type"), accept);
        assert_eq!(chosen.bytes, server.get(&format!("{at}/{part}")).bytes);
    }
    server
        .request("GET", &format!("{at}/mesh"), &[("accept", "text/html")])
        .problem(406);

    let picture = format!("{at}/picture.png");
    // Width and height follow the signature and the head of the first chunk.
    for (query, width) in [("", 2000), ("?view=back&width=300", 300)] {
        let png = server.get(&format!("{picture}{query}"));
        assert_eq!(png.header("content-type"), "image/png");
        assert_eq!(&png.bytes[1..4], b"PNG");
        assert_eq!(png.bytes[16..20], u32::to_be_bytes(width), "{query}");
    }
    for query in ["?view=above", "?width=1", "?size=3"] {
        server.get(&format!("{picture}{query}")).problem(422);
    }

    let path = format!("{at}/mesh.glb");
    let etag = glb.header("etag");
    let part = server.request("GET", &path, &[("range", "bytes=4-11")]);
    assert_eq!(
        (part.status, part.bytes.as_slice()),
        (206, &glb.bytes[4..12])
    );
    assert_eq!(
        part.header("content-range"),
        format!("bytes 4-11/{}", glb.bytes.len())
    );
    let outside = server.request("GET", &path, &[("range", "bytes=999999999-")]);
    outside.problem(416);
    assert_eq!(
        outside.header("content-range"),
        format!("bytes */{}", glb.bytes.len())
    );
    assert_eq!(
        server
            .request("GET", &path, &[("if-none-match", etag)])
            .status,
        304
    );
    assert_eq!(
        server
            .request(
                "GET",
                &path,
                &[("range", "bytes=0-3"), ("if-range", "\"old\"")]
            )
            .status,
        200
    );
    let head = server.request("HEAD", &path, &[]);
    assert_eq!(
        (head.status, head.bytes.len(), head.header("etag")),
        (200, 0, etag)
    );

    let report = server.get(&format!("{at}/report")).json();
    assert_eq!(report["converged"], true, "{report}");
    let vertices = server.get(&format!("{at}/scene")).json()["vertices"]
        .as_array()
        .map(Vec::len);
    assert_eq!(vertices.map(Value::from), Some(report["vertices"].clone()));
}

/// P6: the saved file is complete in itself.
fn the_saved_garment_gives_the_same_mesh(server: &Server, at: &str) {
    let garment = server.get(&format!("{at}/garment")).json();
    let empty = Server::start();
    let headers = [JSON, ("prefer", "wait=60")];
    let fit = empty.send("POST", "/v1/fits", &headers, garment.to_string().as_bytes());
    assert_eq!(fit.status, 200, "{}", fit.text());
    assert_eq!(fit.json()["status"], "succeeded");
    let again = empty.get(&format!("{}/mesh.glb", fit.header("location")));
    assert!(
        again.bytes == server.get(&format!("{at}/mesh.glb")).bytes,
        "the meshes differ"
    );
}

#[test]
fn lists_begin_empty() {
    let server = Server::start();
    for (path, name) in [
        ("/v1/patterns", "patterns"),
        ("/v1/avatars", "avatars"),
        ("/v1/fits", "fits"),
        ("/v1/studies", "studies"),
    ] {
        let list = server.get(path).json();
        assert_eq!(list, json!({name: [], "next_cursor": null}));
    }
}

#[test]
fn the_documents_of_the_interface_are_current() {
    let root = env!("CARGO_MANIFEST_DIR");
    let documents = [
        ("api/openapi.json", seamster::http::openapi_json()),
        (
            "api/garment.schema.json",
            seamster::fit::garment_schema_json(),
        ),
        ("docs/faults.md", seamster::fault::codes_markdown()),
    ];
    for (name, made) in documents {
        let path = format!("{root}/{name}");
        if std::env::var_os("SEAMSTER_BLESS").is_some() {
            std::fs::write(&path, &made).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(
            kept == made,
            "{name} is not what the code says: run with SEAMSTER_BLESS=1 and look at the difference"
        );
    }
}

#[test]
fn every_call_of_the_document_is_answered() {
    let server = Server::start();
    let document = server.get("/openapi.json").json();
    assert!(document["openapi"].as_str().unwrap().starts_with("3.1"));
    let paths = document["paths"].as_object().unwrap();
    for (path, calls) in paths {
        for method in calls.as_object().unwrap().keys() {
            let path = path.replace("{id}", NO_ID);
            let answer = server.request(&method.to_uppercase(), &path, &[]);
            let is_unknown = answer.status == 404 && answer.text().contains("/openapi.json");
            assert!(
                answer.status != 405 && !is_unknown,
                "{method} {path}: {}",
                answer.text()
            );
        }
    }
}

#[test]
fn every_call_of_the_document_has_a_name_of_its_own() {
    let document: Value = serde_json::from_str(&seamster::http::openapi_json()).unwrap();
    let paths = document["paths"].as_object().unwrap().values();
    let calls = paths.flat_map(|calls| calls.as_object().unwrap().values());
    let mut names: Vec<_> = calls
        .map(|call| call["operationId"].as_str().unwrap())
        .collect();
    names.sort_unstable();
    let all = names.len();
    names.dedup();
    assert_eq!((names.len(), all > 20), (all, true), "{names:?}");
}

#[test]
fn the_document_refers_only_to_what_it_has() {
    let document: Value = serde_json::from_str(&seamster::http::openapi_json()).unwrap();
    let mut open = vec![&document];
    while let Some(value) = open.pop() {
        match value {
            Value::Object(fields) => {
                if let Some(Value::String(reference)) = fields.get("$ref") {
                    let pointer = reference.trim_start_matches('#');
                    assert!(document.pointer(pointer).is_some(), "{reference}");
                }
                open.extend(fields.values());
            }
            Value::Array(items) => open.extend(items),
            _ => {}
        }
    }
}
