//! The service against requests that are larger than anyone needs.

use seamster_fixtures::server::{Server, config};
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::TcpStream;

const JSON: (&str, &str) = ("content-type", "application/json");

/// The pattern of one square panel, kept by a server.
fn square(server: &Server) -> Value {
    let spec = br#"{"pattern": {"panels": {"patch": {
        "translation": [0, 100, 20], "rotation": [0, 0, 0],
        "vertices": [[0, 0], [10, 0], [10, 10], [0, 10]],
        "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]
    }}}, "properties": {"units_in_meter": 100}}"#;
    let answer = server.send("POST", "/v1/patterns", &[JSON], spec);
    assert_eq!(answer.status, 201, "{}", answer.text());
    answer.json()["id"].clone()
}

#[test]
fn a_head_above_64_kib_is_refused() {
    let server = Server::with(config(), 0);
    for (length, status) in [(60_000, 200), (70_000, 431)] {
        let long = "x".repeat(length);
        let head =
            format!("GET /health/live HTTP/1.1\r\nHost: localhost\r\nX-Long: {long}\r\n\r\n");
        let mut stream = TcpStream::connect(server.address).expect("it listens");
        // The service may end the connection before it has all.
        let _ = stream.write_all(head.as_bytes());
        let mut answer = [0; 12];
        stream.read_exact(&mut answer).expect("it answers");
        let answer = String::from_utf8_lossy(&answer);
        assert_eq!(answer, format!("HTTP/1.1 {status}"));
    }
}

#[test]
fn the_first_hundred_faults_are_listed_and_all_are_counted() {
    let server = Server::with(config(), 0);
    let pins = vec![json!({"panel": "nowhere", "corner": 0}); 1_500];
    let garment = json!({"pattern": square(&server), "seams": [], "avatar": null, "pins": pins});
    let problem = server.post_json("/v1/fits", &garment).problem(422);
    assert_eq!(problem["errors"].as_array().unwrap().len(), 100);
    assert!(
        problem["errors_total"].as_u64().unwrap() >= 1_500,
        "{problem:.300}"
    );
    let problem = server
        .post_json("/v1/fits", &json!({"seams": [7]}))
        .problem(422);
    assert_eq!(problem["errors_total"], 1);
}

#[test]
fn the_search_for_faults_of_shape_ends_at_the_hundredth() {
    let server = Server::with(config(), 0);
    let problem = server
        .post_json("/v1/fits", &json!({"seams": vec![json!({}); 1_000]}))
        .problem(422);
    assert_eq!(problem["errors"].as_array().unwrap().len(), 100);
    assert_eq!(problem.get("errors_total"), None);
}

#[test]
fn every_list_and_text_of_a_garment_has_a_limit() {
    let server = Server::with(config(), 0);
    let run = json!({"panel": "patch", "from": 0, "to": 1});
    let fabrics: serde_json::Map<_, _> = (0..2_000)
        .map(|i| (format!("own-{i}"), json!({})))
        .collect();
    let garment = json!({
        "schema": "x".repeat(10_000),
        "seams": [{"id": "s", "a": vec![run.clone(); 100], "b": run}],
        "pins": vec![json!({"panel": "patch", "corner": 0}); 3_000],
        "maps": vec!["strain"; 100],
        "fabrics": fabrics,
        "panels": {"patch": {"elastic": vec![json!({"from": 0, "to": 1, "factor": 0.5}); 2_000]}},
    });
    let expected = [
        "request/too_long /schema",
        "request/wrong_length /fabrics",
        "request/wrong_length /maps",
        "request/wrong_length /panels/patch/elastic",
        "request/wrong_length /pins",
        "request/wrong_length /seams/0/a",
    ];
    assert_eq!(server.post_json("/v1/fits", &garment).faults(422), expected);
    let study = json!({"garment": garment});
    let expected = expected.map(|fault| fault.replacen(" /", " /garment/", 1));
    assert_eq!(
        server.post_json("/v1/studies", &study).faults(422),
        expected
    );
}

#[test]
fn a_request_that_takes_too_much_memory_is_refused_before_it_is_read() {
    let mut config = config();
    config.limits.json_memory_bytes = 100_000;
    let server = Server::with(config, 0);
    let rows = vec![[0.0; 3]; 1_000];
    let body = json!({"vertices": rows, "triangles": [], "landmarks": {}});
    let garment = json!({"seams": [], "avatar": {"body": body}});
    let faults = server.post_json("/v1/fits", &garment).faults(422);
    assert_eq!(faults, ["request/too_large "]);
    assert_eq!(server.get("/health/live").status, 200);
}
