//! The service over HTTP: guards, problems, patterns, fabrics, fits, events, results, the page.

mod support;

use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::TcpStream;
use support::server::{Server, config};

const NO_ID: &str = "019a0000-0000-7000-8000-000000000000";

/// Sends bytes as they are and returns the answer as it is: for what an HTTP client would not send.
fn raw(server: &Server, request: &str) -> String {
    let mut stream = TcpStream::connect(server.address()).unwrap();
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
        "/v1/studies",
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
    for path in ["/v1/patterns/", "/v1/fits/", "/v1/avatars/", "/v1/fabrics/"] {
        server.get(&format!("{path}{NO_ID}")).problem(404);
    }
    server.get("/v1/fits/not-an-id").problem(404);
    server
        .ask("DELETE", &format!("/v1/fits/{NO_ID}"), &[])
        .problem(404);
    for part in [
        "mesh",
        "mesh.glb",
        "mesh.obj",
        "mesh.json",
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
    let answer = server.ask("DELETE", "/v1/fits", &[]);
    answer.problem(405);
    assert!(answer.header("allow").contains("POST"), "{answer:?}");
    server.ask("POST", "/index.html", &[]).problem(405);
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
    let answer = server.ask("GET", "/health/live", &[("x-request-id", "mine")]);
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
    let own = format!("http://{}", server.address());
    for (origin, status) in [
        ("https://evil.example", 403),
        ("null", 403),
        (own.as_str(), 422),
    ] {
        let headers = [JSON, ("origin", origin)];
        let answer = server.send("POST", "/v1/fabrics", &headers, b"{}");
        answer.problem(status);
    }
    let reading = server.ask("GET", "/v1/fabrics", &[("origin", "https://evil.example")]);
    assert_eq!(reading.status, 200);
    assert_eq!(reading.header("access-control-allow-origin"), "");
}

#[test]
fn with_tokens_only_they_may_call() {
    let mut config = config();
    config.tokens = vec!["secret".to_owned()];
    let server = Server::with(config, 0);
    for path in ["/v1/fabrics", "/v1/patterns", "/v1/fits", "/metrics"] {
        let refused = server.get(path);
        refused.problem(401);
        assert!(
            refused.header("www-authenticate").starts_with("Bearer"),
            "{path}"
        );
        server
            .ask("GET", path, &[("authorization", "Bearer wrong")])
            .problem(401);
        let let_in = server.ask("GET", path, &[("authorization", "Bearer secret")]);
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
        let again = server.ask("GET", &path, &[("if-none-match", etag)]);
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
    for path in ["/v1/fits", "/v1/fabrics", "/v1/avatars"] {
        server
            .send("POST", path, &[("content-type", "text/plain")], b"{}")
            .problem(415);
    }
    server
        .send("POST", "/v1/patterns", &[JSON], b"{}")
        .problem(415);
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
    server
        .send("POST", "/v1/patterns?units=furlong", &[], b"0")
        .problem(422);
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
            "fabric/out_of_range /density_kg_m2",
            "fabric/out_of_range /friction"
        ]
    );
}

#[test]
fn lists_begin_empty() {
    let server = Server::start();
    for (path, name) in [
        ("/v1/patterns", "patterns"),
        ("/v1/avatars", "avatars"),
        ("/v1/fits", "fits"),
    ] {
        let list = server.get(path).json();
        assert_eq!(list, json!({name: [], "next_cursor": null}));
    }
}

#[test]
fn the_documents_of_the_interface_are_current() {
    let root = env!("CARGO_MANIFEST_DIR");
    let documents = [
        ("openapi.json", seamster::http::openapi_json()),
        ("garment.schema.json", seamster::http::garment_schema_json()),
    ];
    for (name, made) in documents {
        let path = format!("{root}/api/{name}");
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
            let answer = server.ask(&method.to_uppercase(), &path, &[]);
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
