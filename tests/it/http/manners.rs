//! What well-behaved clients rely on in the small.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use seamster_fixtures::server::{Server, config};
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::TcpStream;

/// Sends bytes as they are, and returns what comes until the service ends the connection.
fn raw(server: &Server, request: &str) -> String {
    let mut stream = TcpStream::connect(server.address).unwrap();
    stream.write_all(request.as_bytes()).unwrap();
    let mut answer = vec![];
    // What was not read of a request may reset the connection after the answer.
    let _ = stream.read_to_end(&mut answer);
    String::from_utf8(answer).unwrap()
}

#[test]
fn two_hosts_are_refused() {
    let server = Server::with(config(), 0);
    let answer = raw(
        &server,
        "GET /health/live HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\nConnection: close\r\n\r\n",
    );
    assert!(answer.starts_with("HTTP/1.1 400"), "{answer}");
    assert!(answer.contains("request/host"), "{answer}");
}

#[test]
fn a_request_id_is_bounded() {
    let server = Server::with(config(), 0);
    let answered = |id: &str| {
        let answer = server.request("GET", "/health/live", &[("x-request-id", id)]);
        answer.header("x-request-id").to_owned()
    };
    assert_eq!(answered("mine-7"), "mine-7");
    assert_eq!(answered(&"x".repeat(128)).len(), 128);
    for wrong in ["x".repeat(129), "two words".to_owned()] {
        let id = answered(&wrong);
        assert!(id.len() == 36 && id != wrong, "{id}");
    }
}

#[test]
fn a_file_that_the_api_page_lacks_is_a_problem() {
    let server = Server::with(config(), 0);
    server.get("/docs/nothing.js").problem(404);
    assert_eq!(server.get("/docs/").status, 200);
}

#[test]
fn an_answer_before_the_end_of_the_body_closes_the_connection() {
    let server = Server::with(config(), 0);
    let upload = "POST /v1/nothing HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5000000\r\n\r\n";
    let answer = raw(&server, upload).to_lowercase();
    assert!(answer.starts_with("http/1.1 404"), "{answer}");
    assert!(answer.contains("connection: close"), "{answer}");
    let read = server.post_json("/v1/fabrics", &json!({}));
    assert_eq!((read.status, read.header("connection")), (422, ""));
}

fn small_fit(server: &Server, prefer: Option<&str>) -> seamster_fixtures::server::Answer {
    let dxf = include_bytes!("../../../static/samples/skirt.dxf");
    let pattern = server.send("POST", "/v1/patterns", &[], dxf).json()["id"].clone();
    let garment = include_str!("../../../static/samples/skirt.garment.json");
    let mut garment: Value = serde_json::from_str(garment).unwrap();
    garment["pattern"] = pattern;
    let mut headers = vec![("content-type", "application/json")];
    headers.extend(prefer.map(|prefer| ("prefer", prefer)));
    server.send("POST", "/v1/fits", &headers, garment.to_string().as_bytes())
}

#[test]
fn who_resumes_after_the_last_event_is_told_to_stop() {
    let server = Server::with(config(), 0);
    let id = small_fit(&server, None).json()["id"].clone();
    let at = format!("/v1/fits/{}", id.as_str().unwrap());
    assert!(server.request("DELETE", &at, &[]).status < 300);
    let events = format!("{at}/events");
    let text = server.get(&events).text();
    let last = text
        .lines()
        .filter_map(|line| line.strip_prefix("id: "))
        .next_back();
    let late = server.request("GET", &events, &[("last-event-id", last.unwrap())]);
    assert_eq!((late.status, late.bytes.len()), (204, 0));
}

#[test]
fn a_preference_is_applied_only_where_there_was_a_wait() {
    let server = Server::with(config(), 0);
    let plain = small_fit(&server, None);
    assert_eq!(plain.header("preference-applied"), "");
    let waited = small_fit(&server, Some("wait=1"));
    assert_eq!(waited.header("preference-applied"), "wait=1");
    let at = format!("/v1/fits/{}", waited.json()["id"].as_str().unwrap());
    assert!(server.request("DELETE", &at, &[]).status < 300);
}

#[test]
fn followers_are_bounded_and_who_would_wait_does_not() {
    let mut config = config();
    config.limits.streams = 1;
    let server = Server::with(config, 0);
    let id = small_fit(&server, None).json()["id"].clone();
    let events = format!("/v1/fits/{}/events", id.as_str().unwrap());
    let mut follower = TcpStream::connect(server.address).unwrap();
    let request = format!("GET {events} HTTP/1.1\r\nHost: localhost\r\n\r\n");
    follower.write_all(request.as_bytes()).unwrap();
    let mut begun = [0; 12];
    follower.read_exact(&mut begun).unwrap();
    assert_eq!(&begun, b"HTTP/1.1 200");
    server.get(&events).problem(503);
    let waits = small_fit(&server, Some("wait=60"));
    assert_eq!(waits.status, 202, "{}", waits.text());
    assert_eq!(waits.header("preference-applied"), "");
}

#[test]
fn a_refused_submission_leaves_no_garment_behind() {
    let mut config = config();
    config.limits.queued_jobs = 0;
    let server = Server::with(config, 0);
    small_fit(&server, None).problem(503);
    let garments = server.data().join("blobs/garments");
    let left = std::fs::read_dir(garments).map_or(0, Iterator::count);
    assert_eq!(left, 0);
}
