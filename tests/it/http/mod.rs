//! Tests of `http`: the service over its own socket.

mod bounds;
mod manners;
mod next_try;
mod over;
mod own_bodies;
mod readiness;
mod service;
mod slow_clients;
mod studies;

use seamster_fixtures::server::Server;
use serde_json::Value;
use std::time::Duration;

/// Sews a garment, which must succeed, and returns the id of its fit.
fn sewn(server: &Server, garment: &Value) -> String {
    let queued = server.post_json("/v1/fits", garment);
    assert_eq!(queued.status, 202, "{}", queued.text());
    let at = queued.header("location");
    let is_under_way = |fit: &Value| fit["status"] == "queued" || fit["status"] == "running";
    let mut fit = queued.json();
    // However slow the machine is: one request that waited could time out.
    while is_under_way(&fit) {
        std::thread::sleep(Duration::from_millis(100));
        fit = server.get(at).json();
    }
    assert_eq!(fit["status"], "succeeded", "{fit}");
    fit["id"].as_str().expect("a fit has an id").to_owned()
}

fn mesh(server: &Server, id: &str) -> Value {
    server.get(&format!("/v1/fits/{id}/mesh.json")).json()
}
