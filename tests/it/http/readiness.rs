//! Readiness tells what the service can do, and nothing is taken that would be lost.

use seamster_fixtures::server::{Server, config};
use serde_json::json;
use std::fs;
use std::time::{Duration, Instant};

/// The greatest age of an answer.
const AGE: Duration = Duration::from_secs(5);

/// Waits until readiness is answered with this status.
fn expect_ready(server: &Server, status: u16) {
    let deadline = Instant::now() + AGE;
    while server.get("/health/ready").status != status {
        assert!(Instant::now() < deadline, "not {status} in {AGE:?}");
        std::thread::sleep(Duration::from_millis(50));
    }
    assert_eq!(server.get("/health/live").status, 200);
}

#[test]
fn a_folder_that_is_gone_is_not_ready_and_takes_nothing() {
    let server = Server::with(config(), 0);
    expect_ready(&server, 200);
    fs::remove_dir_all(server.data()).unwrap();
    let form = json!({"form": {"height_m": 1.7, "bust_m": 0.9, "waist_m": 0.7, "hip_m": 0.95}});
    server.post_json("/v1/avatars", &form).problem(503);
    let garment = json!({"seams": "suggest"});
    assert_ne!(server.post_json("/v1/fits", &garment).status, 202);
    expect_ready(&server, 503);
}

#[test]
fn a_folder_that_cannot_be_written_is_not_ready_until_it_can() {
    let server = Server::with(config(), 0);
    expect_ready(&server, 200);
    let disk = server.data().join("blobs/tmp");
    fs::remove_dir_all(&disk).unwrap();
    expect_ready(&server, 503);
    fs::create_dir(&disk).unwrap();
    expect_ready(&server, 200);
}

#[test]
fn a_damaged_database_is_not_ready() {
    let server = Server::with(config(), 0);
    expect_ready(&server, 200);
    let database = server.data().join("seamster.db");
    // Else the log beside the file still has all pages.
    let connection = rusqlite::Connection::open(&database).unwrap();
    let truncate = "PRAGMA wal_checkpoint(TRUNCATE)";
    connection.query_row(truncate, [], |_| Ok(())).unwrap();
    drop(connection);
    let length = fs::metadata(&database).unwrap().len();
    let garbage = vec![0x5a; usize::try_from(length).unwrap()];
    fs::write(&database, garbage).unwrap();
    expect_ready(&server, 503);
}

#[test]
fn a_full_queue_is_ready() {
    let mut config = config();
    config.limits.queued_jobs = 0;
    expect_ready(&Server::with(config, 0), 200);
}
