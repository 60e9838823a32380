//! Studies over HTTP: submitted, followed, fetched, drawn, canceled, refused, and kept apart from
//! fits.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use seamster_fixtures::server::{Answer, Server, config};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

const JSON: (&str, &str) = ("content-type", "application/json");
const NO_ID: &str = "019a0000-0000-7000-8000-000000000000";
const PATIENCE: Duration = Duration::from_secs(60);

/// A hanging square of cloth, held by two corners: a study of it takes a moment.
fn cloth() -> Value {
    let corners = [[0.0, 0.0], [0.0, 0.3], [0.3, 0.3], [0.3, 0.0]];
    let edge = |i: usize| {
        let points = [corners[i], corners[(i + 1) % 4]];
        json!({"index": i, "from": i, "to": (i + 1) % 4, "length_m": 0.3, "points": points})
    };
    let corner = |i: usize| json!({"index": i, "x": corners[i][0], "y": corners[i][1]});
    let panel = json!({
        "id": "cloth", "name": "CLOTH", "area_m2": 0.09, "drawn_area_m2": 0.09, "perimeter_m": 1.2,
        "corners": [corner(0), corner(1), corner(2), corner(3)],
        "edges": [edge(0), edge(1), edge(2), edge(3)],
    });
    json!({
        "pattern": {
            "name": "cloth", "panels": [panel],
            "source": {"format": "dxf", "units": "m", "scale_to_m": 1.0, "allowance": "none"},
        },
        "seams": [], "avatar": null, "panels": {"cloth": {"placement": {"at": "origin"}}},
        "pins": [{"panel": "cloth", "corner": 1}, {"panel": "cloth", "corner": 2}],
    })
}

/// Two runs on one coarse mesh.
fn small() -> Value {
    json!({"garment": cloth(), "methods": ["newton"], "tolerances": [1e-1, 1e-2], "edge_lengths_m": [0.1]})
}

fn submit(server: &Server, study: &Value, headers: &[(&str, &str)]) -> Answer {
    let headers = [&[JSON], headers].concat();
    server.send(
        "POST",
        "/v1/studies",
        &headers,
        study.to_string().as_bytes(),
    )
}

fn until(server: &Server, at: &str, is_there: impl Fn(&Value) -> bool) -> Value {
    let deadline = Instant::now() + PATIENCE;
    loop {
        let study = server.get(at).json();
        if is_there(&study) {
            return study;
        }
        assert!(Instant::now() < deadline, "{study}");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_study_is_followed_to_its_end_and_comes_with_its_report() {
    let server = Server::start();
    let queued = submit(&server, &small(), &[]);
    assert_eq!(queued.status, 202, "{}", queued.text());
    let at = queued.header("location").to_owned();
    let id = queued.json()["id"].as_str().unwrap().to_owned();
    assert_eq!(at, format!("/v1/studies/{id}"));

    let events = server.get(&format!("{at}/events"));
    assert_eq!(events.header("content-type"), "text/event-stream");
    let events = events.text();
    let ids = events.lines().filter_map(|line| line.strip_prefix("id: "));
    let ids: Vec<u64> = ids.map(|id| id.parse().unwrap()).collect();
    assert!(ids.is_sorted() && ids.len() > 2, "{events}");
    assert!(events.contains("event: progress"), "{events}");
    assert!(events.contains("\"status\":\"succeeded\""), "{events}");

    let study = server.get(&at).json();
    assert_eq!(study["status"], "succeeded", "{study}");
    assert_eq!(study["error"], Value::Null);
    let report = &study["report"];
    assert_eq!(report["schema"], "seamster/study/1");
    let runs = report["runs"].as_array().unwrap();
    let made: Vec<_> = runs
        .iter()
        .map(|run| {
            (
                run["method"].as_str().unwrap(),
                run["tolerance"].as_f64().unwrap(),
            )
        })
        .collect();
    assert_eq!(made, [("newton", 1e-1), ("newton", 1e-2)]);

    the_plot_is_drawn(&server, &at);
    the_study_is_listed_alone(&server, &id);
    what_was_asked_is_whole(&server, &at);
}

fn the_plot_is_drawn(server: &Server, at: &str) {
    let path = format!("{at}/plot.svg");
    let plot = server.get(&path);
    assert_eq!(plot.status, 200, "{}", plot.text());
    assert_eq!(plot.header("content-type"), "image/svg+xml");
    assert!(plot.text().starts_with("<svg "), "{}", plot.text());
    let again = server.request("GET", &path, &[("if-none-match", plot.header("etag"))]);
    assert_eq!((again.status, again.bytes.len()), (304, 0));
}

fn the_study_is_listed_alone(server: &Server, id: &str) {
    let list = server.get("/v1/studies?status=succeeded").json();
    assert_eq!(list["studies"].as_array().unwrap().len(), 1);
    assert_eq!(list["studies"][0]["id"], id);
    // A list of reports would be long.
    assert_eq!(list["studies"][0].get("report"), None);
    let failed = server.get("/v1/studies?status=failed").json();
    assert_eq!(failed["studies"], json!([]));
    assert_eq!(server.get("/v1/fits").json()["fits"], json!([]));
    for part in ["", "/mesh", "/report", "/garment", "/scene", "/events"] {
        server.get(&format!("/v1/fits/{id}{part}")).problem(404);
    }
    let path = format!("/v1/fits/{id}");
    server.request("DELETE", &path, &[]).problem(404);
}

/// As the garment of a fit (P6): complete in itself, nothing left open.
fn what_was_asked_is_whole(server: &Server, at: &str) {
    let asked = server.get(&format!("{at}/asked")).json();
    assert_eq!(asked["methods"], json!(["newton"]));
    let fabric = asked["garment"]["default_fabric"].as_str().unwrap();
    assert!(asked["garment"]["fabrics"][fabric].is_object(), "{asked}");
    let empty = Server::with(config(), 0);
    assert_eq!(submit(&empty, &asked, &[]).status, 202);
}

#[test]
fn who_waits_gets_the_report_at_once() {
    let server = Server::start();
    let answer = submit(&server, &small(), &[("prefer", "wait=60")]);
    assert_eq!(answer.status, 200, "{}", answer.text());
    assert_eq!(answer.header("preference-applied"), "wait=60");
    let study = answer.json();
    assert_eq!(study["status"], "succeeded", "{study}");
    assert_eq!(study, server.get(answer.header("location")).json());
    assert!(study["report"]["runs"].is_array(), "{study}");
}

#[test]
fn a_waiting_study_has_no_report_and_is_canceled_at_once() {
    let server = Server::with(config(), 0);
    let queued = submit(&server, &small(), &[]);
    let at = queued.header("location").to_owned();
    let study = queued.json();
    assert_eq!(
        (&study["status"], &study["report"]),
        (&json!("queued"), &Value::Null)
    );
    for (name, path) in [
        ("plot", "/plot.svg"),
        ("events", "/events"),
        ("asked", "/asked"),
        ("cancel", ""),
    ] {
        assert_eq!(study["links"][name], format!("{at}{path}"));
    }
    server.get(&format!("{at}/plot.svg")).problem(409);
    let canceled = server.request("DELETE", &at, &[]);
    assert_eq!(
        (canceled.status, &canceled.json()["status"]),
        (200, &json!("canceled"))
    );
    assert_eq!(server.get(&at).json(), canceled.json());
    server.get(&format!("{at}/plot.svg")).problem(404);
    let events = server.get(&format!("{at}/events")).text();
    assert!(events.contains("\"status\":\"canceled\""), "{events}");
}

/// The paper's method on a mesh of some thousand vertices needs far longer than this test waits.
#[test]
fn a_running_study_stops_within_a_second() {
    let server = Server::start();
    let study =
        json!({"garment": cloth(), "methods": ["symplectic_euler"], "edge_lengths_m": [0.005]});
    let at = submit(&server, &study, &[]).header("location").to_owned();
    until(&server, &at, |study| {
        study["status"] == "running" && study["progress"]["cpu_s"].as_f64() > Some(0.0)
    });
    let asked = Instant::now();
    assert_eq!(server.request("DELETE", &at, &[]).status, 202);
    let study = until(&server, &at, |study| study["status"] != "running");
    // A worker whose notice was lost finds the cancellation with the next renewal of its lease,
    // after 6 s.
    assert!(
        asked.elapsed() < Duration::from_secs(5),
        "{:?}",
        asked.elapsed()
    );
    assert_eq!(
        (&study["status"], &study["report"]),
        (&json!("canceled"), &Value::Null)
    );
}

#[test]
fn all_faults_of_a_study_come_at_once() {
    let server = Server::with(config(), 0);
    let study = json!({
        "garment": {"seams": [], "simulate": {"edge_lenght_m": 0.01}}, "methods": ["newtin"],
        "tolerance": [1e-3], "edge_lengths_m": 0.02,
    });
    assert_eq!(
        submit(&server, &study, &[]).faults(422),
        [
            "request/not_a_choice /methods/0",
            "request/unknown_field /garment/simulate/edge_lenght_m",
            "request/unknown_field /tolerance",
            "request/wrong_type /edge_lengths_m",
        ]
    );
    let mut study = small();
    study["garment"]["default_fabric"] = json!("chain-mail");
    study["garment"]["pins"][1]["corner"] = json!(9);
    study["tolerances"] = json!([1e-2, -1.0]);
    study["edge_lengths_m"] = json!([0.1, 1e-9]);
    let faults = submit(&server, &study, &[]).faults(422);
    let mut places: Vec<_> = faults
        .iter()
        .map(|fault| fault.split(' ').nth(1).unwrap())
        .collect();
    places.sort_unstable();
    assert_eq!(
        places,
        [
            "/edge_lengths_m/1",
            "/garment/default_fabric",
            "/garment/pins/1/corner",
            "/tolerances/1"
        ]
    );
    assert_eq!(server.get("/v1/studies").json()["studies"], json!([]));
    let text = [("content-type", "text/plain")];
    server
        .send("POST", "/v1/studies", &text, b"{}")
        .problem(415);
    let broken = server.send("POST", "/v1/studies", &[JSON], b"{\n]");
    assert_eq!(broken.faults(400), ["request/syntax line 2 column 1"]);
}

#[test]
fn a_key_makes_a_repeated_request_the_same_study() {
    let server = Server::with(config(), 0);
    let key = [("idempotency-key", "monday")];
    let first = submit(&server, &small(), &key);
    let again = submit(&server, &small(), &key);
    assert_eq!(
        (again.status, again.header("location")),
        (202, first.header("location"))
    );
    let mut other = small();
    other["tolerances"] = json!([1e-3]);
    let reused = submit(&server, &other, &key).faults(422);
    assert_eq!(reused, ["study/key_reused /Idempotency-Key"]);
    // A fit is another request too.
    let fit = cloth().to_string();
    let fit = server.send("POST", "/v1/fits", &[JSON, key[0]], fit.as_bytes());
    assert_eq!(fit.faults(422), ["fit/key_reused /Idempotency-Key"]);
    let list = server.get("/v1/studies").json();
    assert_eq!(list["studies"].as_array().unwrap().len(), 1);
}

#[test]
fn what_is_no_study_is_not_found() {
    let server = Server::with(config(), 0);
    let fit = server.post_json("/v1/fits", &cloth());
    assert_eq!(fit.status, 202, "{}", fit.text());
    let fit = fit.json()["id"].as_str().unwrap().to_owned();
    for id in [NO_ID, "not-an-id", &fit] {
        for part in ["", "/plot.svg", "/events", "/asked"] {
            server.get(&format!("/v1/studies/{id}{part}")).problem(404);
        }
        let path = format!("/v1/studies/{id}");
        server.request("DELETE", &path, &[]).problem(404);
    }
    assert_eq!(server.get("/v1/studies").json()["studies"], json!([]));
    let fits = server.get("/v1/fits").json();
    assert_eq!(fits["fits"][0]["id"], fit);
    assert_eq!(fits["fits"][0]["status"], "queued");
    let counted = server.get("/metrics").text();
    assert!(
        counted.contains("seamster_fits{status=\"queued\"} 1"),
        "{counted}"
    );
    assert!(
        counted.contains("seamster_studies{status=\"queued\"} 0"),
        "{counted}"
    );
}

/// A server with no workers, and its database.
fn server_and_database() -> (Server, rusqlite::Connection) {
    let server = Server::with(config(), 0);
    // It has opened its store once it answers.
    assert_eq!(server.get("/v1/studies").status, 200);
    let database = rusqlite::Connection::open(server.data().join("seamster.db")).unwrap();
    (server, database)
}

/// Submits a job whose record nobody can read, waits for its end as `prefer` says, and returns the
/// time that this took.
fn submit_unreadable(server: &Server, path: &str, prefer: &str) -> Duration {
    let body = if path == "/v1/fits" { cloth() } else { small() };
    let headers = [JSON, ("prefer", prefer)];
    let start = Instant::now();
    let answer = server.send("POST", path, &headers, body.to_string().as_bytes());
    assert_eq!(answer.status, 202, "{path}: {}", answer.text());
    assert_eq!(answer.json()["status"], "queued");
    assert_eq!(answer.header("preference-applied"), "");
    start.elapsed()
}

#[test]
fn what_was_kept_and_cannot_be_followed_is_never_answered_by_an_error() {
    for path in ["/v1/studies", "/v1/fits"] {
        let (server, database) = server_and_database();
        let spoil = "CREATE TRIGGER spoil AFTER INSERT ON jobs
            BEGIN UPDATE jobs SET record = '{}' WHERE id = NEW.id; END";
        database.execute_batch(spoil).unwrap();
        assert!(submit_unreadable(&server, path, "wait=60") < Duration::from_secs(30));
    }
}

/// Makes the one record of a store one that cannot be read, once its client waits.
fn spoil_while_waiting(database: &rusqlite::Connection) {
    let deadline = Instant::now() + PATIENCE;
    let count = "SELECT count(*) FROM jobs";
    while database.query_row(count, [], |row| row.get(0)) != Ok(1) {
        assert!(Instant::now() < deadline, "nothing was kept");
        std::thread::sleep(Duration::from_millis(5));
    }
    std::thread::sleep(Duration::from_millis(500));
    assert_eq!(database.execute("UPDATE jobs SET record = '{}'", []), Ok(1));
}

#[test]
fn what_was_kept_and_is_lost_meanwhile_is_never_answered_by_an_error() {
    for path in ["/v1/studies", "/v1/fits"] {
        let (server, database) = server_and_database();
        let spoiled = std::thread::spawn(move || spoil_while_waiting(&database));
        let waited = submit_unreadable(&server, path, "wait=3");
        spoiled.join().unwrap();
        assert!(waited >= Duration::from_secs(3), "{waited:?}");
    }
}
