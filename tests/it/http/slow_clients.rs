//! Clients that are slow on purpose hold nothing that others need.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use seamster::config::Config;
use seamster_fixtures::server::{Server, config};
use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// Far more than any of the timeouts below takes on a busy machine.
const TIMEOUT: Duration = Duration::from_secs(60);
/// The largest file of the service that is always there: some 1.4 MB.
const LARGE: &str = "/docs/swagger-ui-bundle.js";

/// Settings under which clients are given up soon.
fn impatient() -> Config {
    let mut config = config();
    config.limits.head_timeout_s = 1.0;
    config.limits.stall_timeout_s = 1.0;
    config
}

fn connect(server: &Server, request: &str) -> TcpStream {
    let mut stream = TcpStream::connect(server.address).unwrap();
    stream.set_read_timeout(Some(TIMEOUT)).unwrap();
    stream.write_all(request.as_bytes()).unwrap();
    stream
}

/// What comes until the service ends the connection.
fn rest(mut stream: TcpStream) -> Vec<u8> {
    let mut bytes = vec![];
    match stream.read_to_end(&mut bytes) {
        Ok(_) => {}
        Err(error) => assert_eq!(error.kind(), ErrorKind::ConnectionReset, "{error}"),
    }
    bytes
}

#[test]
fn a_connection_without_a_request_ends() {
    let server = Server::with(impatient(), 0);
    let idle = "GET /health/live HTTP/1.1\r\nHost: localhost\r\n\r\n";
    for (request, is_answered) in [("", false), ("GET / HTTP/1.1\r\nHo", false), (idle, true)] {
        let start = Instant::now();
        let answer = rest(connect(&server, request));
        assert!(start.elapsed() < TIMEOUT, "{request:?}");
        assert_eq!(
            answer.starts_with(b"HTTP/1.1 200"),
            is_answered,
            "{request:?}"
        );
    }
}

#[test]
fn uploads_that_stand_still_take_nothing_from_others_and_end() {
    let mut config = impatient();
    config.limits.stall_timeout_s = 5.0;
    config.limits.requests = 4;
    let server = Server::with(config, 0);
    let head = "POST /v1/patterns HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/dxf\r\n\
                Content-Length: 1000000\r\n\r\n0";
    let uploads: Vec<_> = (0..100).map(|_| connect(&server, head)).collect();
    for _ in 0..20 {
        assert_eq!(server.get("/v1/fabrics").status, 200);
        let body = serde_json::json!({});
        assert_eq!(server.post_json("/v1/fabrics", &body).status, 422);
    }
    for upload in uploads {
        let answer = String::from_utf8(rest(upload)).unwrap();
        assert!(answer.starts_with("HTTP/1.1 408"), "{answer}");
        assert!(
            answer.to_lowercase().contains("connection: close"),
            "{answer}"
        );
    }
}

#[test]
fn a_client_that_does_not_read_is_cut_off() {
    let server = Server::with(impatient(), 0);
    let length = server.get(LARGE).bytes.len();
    let request = format!("GET {LARGE} HTTP/1.1\r\nHost: localhost\r\n\r\n");
    let count = (64 << 20) / length;
    let stream = connect(&server, &request.repeat(count));
    // Longer than the patience, which the first bytes give back once.
    std::thread::sleep(Duration::from_secs(5));
    let bytes = rest(stream);
    assert!(
        bytes.len() < count * length,
        "all was sent: {}",
        bytes.len()
    );
}

#[test]
fn answers_that_wait_for_their_clients_are_bounded() {
    let mut config = impatient();
    config.limits.stall_timeout_s = 30.0;
    config.limits.answer_bytes_in_flight = 3 << 20;
    let server = Server::with(config, 0);
    let request = format!("GET {LARGE} HTTP/1.1\r\nHost: localhost\r\n\r\n");
    // More than the buffers of the system take, on each.
    let streams: Vec<_> = (0..3)
        .map(|_| connect(&server, &request.repeat(20)))
        .collect();
    let deadline = Instant::now() + TIMEOUT;
    while server.get(LARGE).status != 503 {
        assert!(Instant::now() < deadline, "never refused");
    }
    assert_eq!(server.get("/v1/fabrics").status, 200);
    drop(streams);
    while server.get(LARGE).status != 200 {
        assert!(Instant::now() < deadline, "never free again");
    }
}

#[test]
fn clients_without_a_token_have_a_share_of_their_own() {
    let mut config = impatient();
    config.tokens = vec!["secret".to_owned()];
    config.limits.stall_timeout_s = 30.0;
    config.limits.answer_bytes_in_flight = 10 << 20;
    let server = Server::with(config, 0);
    let request = format!("GET {LARGE} HTTP/1.1\r\nHost: localhost\r\n\r\n");
    let streams: Vec<_> = (0..8)
        .map(|_| connect(&server, &request.repeat(20)))
        .collect();
    let deadline = Instant::now() + TIMEOUT;
    while server.get(LARGE).status != 503 {
        assert!(Instant::now() < deadline, "never refused");
    }
    let token = [("authorization", "Bearer secret")];
    assert_eq!(server.send("GET", LARGE, &token, &[]).status, 200);
    drop(streams);
}

#[test]
fn bodies_in_flight_are_bounded() {
    let mut config = impatient();
    config.limits.stall_timeout_s = 5.0;
    config.limits.upload_bytes_in_flight = 3 << 20;
    let server = Server::with(config, 0);
    let head = format!(
        "POST /v1/patterns HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/dxf\r\n\
         Content-Length: 4000000\r\n\r\n{}",
        "0".repeat(1 << 20)
    );
    let uploads: Vec<_> = (0..5).map(|_| connect(&server, &head)).collect();
    let answers = uploads.into_iter().map(rest);
    let refused = answers.filter(|answer| answer.starts_with(b"HTTP/1.1 503"));
    assert!(refused.count() >= 2);
    let dxf = vec![b'0'; 1 << 20];
    assert_eq!(server.send("POST", "/v1/patterns", &[], &dxf).status, 422);
}
