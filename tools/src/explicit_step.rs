//! Cost of one explicit step against the memory's bandwidth:
//! `cargo run --release -p seamster-tools explicit-step`.
//!
//! One JSON line a run: nanoseconds a vertex and step (CPU of this thread: what a motion twice as
//! long takes more, so that setting up is left out and all else is in), the bytes of the kernel's
//! arrays a vertex, each counted once, and what share of the bandwidth of a triad a = b + s c that
//! is. The triad runs in this program on arrays far larger than any cache, and on arrays of the
//! size of the kernel's own.

use nalgebra::Vector3;
use rustix::time::{ClockId, clock_gettime};
use seamster::config::Limits;
use seamster::mesh::{ClothMesh, PanelRange};
use seamster::progress::CancelToken;
use seamster::scene::{Cut, Membrane, NetSpring, Scene, library};
use seamster::solver::{
    Analysis, Context, MembraneModel, Method, SolverOptions, Start, trajectory,
};
use serde_json::json;
use std::hint::black_box;

/// Bytes of the triad's three arrays: far above any cache.
const LARGE: usize = 1 << 28;
/// Vertices times steps that are timed.
const WORK: usize = 30_000_000;

/// Prints a line for each scene and method.
pub(crate) fn main() {
    let large = triad(LARGE);
    for rows in [33, 129, 317] {
        for (name, scene, membrane) in [
            ("S1P", planar_hang(rows), MembraneModel::Springs),
            ("sheet_springs", sheet(rows), MembraneModel::Springs),
            ("sheet_continuum", sheet(rows), MembraneModel::Continuum),
        ] {
            for method in [Method::SymplecticEuler, Method::Verlet] {
                println!("{}", line(name, &scene, membrane, method, large));
            }
        }
    }
}

fn line(
    name: &str,
    scene: &Scene,
    membrane: MembraneModel,
    method: Method,
    large: f64,
) -> serde_json::Value {
    let vertices = scene.start.len();
    let steps = WORK / vertices;
    let best = |steps: usize| {
        (0..3)
            .map(|_| time(scene, membrane, method, steps))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .expect("three runs")
    };
    let (short, (long, report)) = (best(steps).0, best(2 * steps));
    let cost = (long - short) * 1e9 / (steps * vertices) as f64;
    let bytes = report.step_bytes as f64 / vertices as f64;
    let like = triad(usize::try_from(report.step_bytes).unwrap_or(LARGE));
    json!({
        "scene": name,
        "vertices": vertices,
        "method": report.method,
        "steps": report.steps,
        "ns_per_vertex_step": cost,
        "bytes_per_vertex": bytes,
        "gb_s": bytes / cost,
        "triad_gb_s": large,
        "share_of_triad": bytes / cost / large,
        "triad_same_size_gb_s": like,
        "share_of_triad_same_size": bytes / cost / like,
    })
}

/// CPU time of a motion of so many steps \[s\].
fn time(
    scene: &Scene,
    membrane: MembraneModel,
    method: Method,
    steps: usize,
) -> (f64, seamster::solver::MotionReport) {
    let step = 2e-6;
    let duration = step * steps as f64;
    let options = SolverOptions {
        analysis: Analysis::Transient,
        method,
        membrane,
        step_s: Some(step),
        duration_s: Some(duration),
        frame_rate_hz: Some(1.0 / duration),
        ..SolverOptions::default()
    };
    let (limits, cancel) = (Limits::default(), CancelToken::new());
    let mut context = Context {
        cpu_s: &cpu_s,
        cancel: &cancel,
        progress: &mut |_| {},
        limits: &limits,
    };
    let began = cpu_s();
    let motion = trajectory(scene, &options, Start::default(), &mut context);
    assert!(motion.report.complete, "{}", motion.report.why);
    let spent = cpu_s() - began;
    (spent, motion.report)
}

fn cpu_s() -> f64 {
    let now = clock_gettime(ClockId::ThreadCPUTime);
    now.tv_sec as f64 + now.tv_nsec as f64 * 1e-9
}

/// Bandwidth of a = b + s c on three arrays of `bytes` together \[GB/s\], the best of several
/// passes.
fn triad(bytes: usize) -> f64 {
    let n = bytes / 24;
    let (mut a, b, c) = (vec![0.0; n], vec![1.0; n], vec![2.0; n]);
    let passes = (LARGE / bytes.max(1)).clamp(8, 4000);
    let mut best = f64::INFINITY;
    for _ in 0..8 {
        let began = cpu_s();
        for pass in 0..passes / 8 {
            let s = 1.0 + pass as f64;
            for ((a, b), c) in a.iter_mut().zip(&b).zip(&c) {
                *a = b + s * c;
            }
            black_box(&mut a);
        }
        best = best.min((cpu_s() - began) / (passes / 8) as f64);
    }
    (24 * n) as f64 / best * 1e-9
}

/// A square of `rows` x `rows` vertices, 1 m wide, in the x-z plane, hung by two corners.
fn square(rows: usize) -> Scene {
    let last = rows - 1;
    let cell = 1.0 / last as f64;
    let uv: Vec<[f64; 2]> = (0..rows * rows)
        .map(|v| [(v % rows) as f64 * cell, (v / rows) as f64 * cell])
        .collect();
    let mut triangles = vec![];
    for v in (0..last * rows).filter(|v| v % rows < last) {
        let [a, b, c, d] = [v, v + 1, v + rows + 1, v + rows];
        triangles.extend(if (v % rows + v / rows).is_multiple_of(2) {
            [[a, b, c], [a, c, d]]
        } else {
            [[a, b, d], [b, c, d]]
        });
    }
    let mut mass = vec![0.0; uv.len()];
    for &v in triangles.iter().flatten() {
        mass[v] += 0.2 * 0.5 * cell * cell / 3.0;
    }
    let fabric = library().remove("linen").expect("a shipped fabric");
    Scene {
        start: uv.iter().map(|[u, v]| Vector3::new(*u, 0.0, -v)).collect(),
        mass,
        mesh: ClothMesh {
            panels: vec![PanelRange {
                vertices: 0..uv.len(),
                triangles: 0..triangles.len(),
                corners: vec![],
            }],
            uv,
            triangles,
            stitches: vec![],
        },
        fabrics: vec![fabric],
        cut: vec![Cut {
            fabric: 0,
            warp_angle: 0.0,
            face_down: false,
        }],
        membrane: Membrane::Fabric,
        least_bending_n_m: 0.0,
        body: None,
        body_hardness: 1.0,
        fixed_cloth: None,
        friction: 0.0,
        gravity: Vector3::new(0.0, 0.0, -9.81),
        drag: Some(20.0),
        pins: vec![0, last],
        fixed_axis: None,
        wind: None,
        layers: vec![],
        carriers: vec![],
        self_contact: false,
    }
}

/// Cloth of triangles: springs or continuum, with hinges.
fn sheet(rows: usize) -> Scene {
    square(rows)
}

/// The net S1P of the benchmark scenes: structural, shear and bend springs.
fn planar_hang(rows: usize) -> Scene {
    let mut scene = square(rows);
    let cell = 1.0 / (rows - 1) as f64;
    let mut net = vec![];
    for v in 0..rows * rows {
        let (i, j) = (v % rows, v / rows);
        let mut add = |a: usize, b: usize, length: f64, stiffness_n_m: f64| {
            net.push(NetSpring {
                a,
                b,
                rest_length_m: length * cell,
                stiffness_n_m,
            });
        };
        let carried = |k: usize| if k == 0 || k == rows - 1 { 1e3 } else { 2e3 };
        if i + 1 < rows {
            add(v, v + 1, 1.0, carried(j));
        }
        if j + 1 < rows {
            add(v, v + rows, 1.0, carried(i));
        }
        if i + 1 < rows && j + 1 < rows {
            add(v, v + rows + 1, 2.0_f64.sqrt(), 500.0);
            add(v + 1, v + rows, 2.0_f64.sqrt(), 500.0);
        }
        if i + 2 < rows {
            add(v, v + 2, 2.0, 40.0);
        }
        if j + 2 < rows {
            add(v, v + 2 * rows, 2.0, 40.0);
        }
    }
    scene.membrane = Membrane::Springs(net);
    for fabric in &mut scene.fabrics {
        (fabric.bending_warp_n_m, fabric.bending_weft_n_m) = (0.0, 0.0);
    }
    scene.fixed_axis = Some(1);
    scene
}
