//! The memory of a service whose clients send what nobody would.

use crate::program::{Service, sample};
use std::time::Duration;

/// Most memory of the service meanwhile \[bytes\].
const MOST_MEMORY: u64 = 512 << 20;
/// Most bytes of an answer that lists faults.
const MOST_ANSWER: usize = 1 << 20;

/// A list of `count` times `item` under `name`, in a garment.
fn garment(name: &str, item: &str, count: usize) -> String {
    let items = vec![item; count].join(",");
    let seams = if name == "seams" { "" } else { "\"seams\":[]," };
    format!("{{{seams}\"{name}\":[{items}]}}")
}

/// A body of one's own that has `rows` under `vertices`.
fn body(row: &str, count: usize) -> String {
    let rows = vec![row; count].join(",");
    format!(
        "{{\"seams\":[],\"avatar\":{{\"body\":{{\"vertices\":[{rows}],\"triangles\":[],\"landmarks\":{{}}}}}}}}"
    )
}

#[test]
fn a_body_of_many_items_is_refused_in_bounded_memory() {
    let data = tempfile::tempdir().unwrap();
    let service = Service::start(data.path());
    let dxf = std::fs::read(sample("skirt.dxf")).unwrap();
    let pattern = service.post("/v1/patterns", &dxf, "application/dxf");
    let check = format!(
        "/v1/patterns/{}/seams/check",
        pattern["id"].as_str().unwrap()
    );
    let agent: ureq::Agent = ureq::Agent::config_builder()
        .http_status_as_error(false)
        .timeout_global(Some(Duration::from_secs(120)))
        .build()
        .into();
    let run = r#"{"panel":"p"}"#;
    let seam = format!("{{\"id\":7,\"a\":[{}]}}", vec![run; 60].join(","));
    let garments = [
        garment("seams", "{}", 3_000_000),
        garment("seams", &seam, 2_000),
        garment("pins", "{}", 3_000_000),
        garment("pins", r#"{"panel":"nowhere","corner":0}"#, 2_000),
        garment("maps", "[[],[]]", 1_000_000),
        body("[0]", 1_000_000),
        body("\"\"", 1_000_000),
        body("[0,0,0,0]", 600_000),
        format!("{{\"seams\":[],\"schema\":\"{}\"}}", "x".repeat(10 << 20)),
        format!("{{\"{}\":0}}", "x".repeat(10 << 20)),
        format!("[{}", "[],".repeat(9_000_000)),
    ];
    for garment in &garments {
        let study = format!("{{\"garment\":{garment}}}");
        for (path, body) in [
            ("/v1/fits", garment),
            (&check, garment),
            ("/v1/studies", &study),
        ] {
            let start: String = body.chars().take(60).collect();
            let url = format!("http://{}{path}", service.address);
            let request = agent.post(&url).header("content-type", "application/json");
            let mut answer = request.send(body.as_bytes()).unwrap();
            let bytes = answer.body_mut().read_to_vec().unwrap();
            let text = String::from_utf8_lossy(&bytes);
            let status = answer.status().as_u16();
            assert!(
                matches!(status, 200 | 400 | 422),
                "{path} {start}: {status}: {text:.300}"
            );
            assert!(bytes.len() < MOST_ANSWER, "{path} {start}: {}", bytes.len());
        }
    }
    let peak = service.peak_memory();
    assert!(peak < MOST_MEMORY, "{} MB", peak >> 20);
}
