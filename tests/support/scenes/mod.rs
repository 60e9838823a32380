//! Scenes of the benchmark by name, shared by the bench and the tests.
//!
//! A name is a family with what is special about it: `S1P`, `S3_81`, `S2_smooth`, `S1T_x100`, `tube10k_x100`.
//! `S1P`, `S1T`, `S2` and `S3` are spring nets that other simulators have run too (see `net`), `tubeNk` a tube of cloth of about N
//! thousand vertices (see `tube`). A number is that of rows of vertices in a panel, `x100` makes cloth 100 times stiffer in
//! stretch and shear, `smooth` takes friction away (and pins S2 on top).
#![allow(
    dead_code,
    reason = "each test program takes this in as its own and uses some of it"
)]

pub(crate) mod net;
#[path = "../panels.rs"]
pub(crate) mod panels;
pub(crate) mod tube;

use net::{Family, Net};
use seamster::config::Limits;
use seamster::scene::Scene;

/// How much stiffer the stiff scenes are.
const STIFFER: f64 = 100.0;

/// The scene of this name, if it is one.
pub(crate) fn scene(name: &str) -> Option<Scene> {
    let mut parts = name.split('_');
    let family = parts.next()?;
    let (mut rows, mut stiffer, mut smooth) = (None, 1.0, false);
    for part in parts {
        match part {
            "x100" => stiffer = STIFFER,
            "smooth" => smooth = true,
            rows_asked => rows = Some(rows_asked.parse().ok()?),
        }
    }
    if let Some(thousands) = family.strip_prefix("tube") {
        let thousands: usize = thousands.strip_suffix('k')?.parse().ok()?;
        return Some(tube::tube(1000 * thousands, stiffer));
    }
    let family = Family::named(family)?;
    let mut raw = Net {
        family,
        rows: rows.unwrap_or(family.rows()),
        stiffer,
    }
    .scene();
    if smooth {
        raw.friction = 0.0;
        if family == Family::Sphere {
            // A sheet on a smooth ball slides off, as a rope off a pulley: two vertices on top hold it. One would let it turn.
            let columns = rows.unwrap_or(family.rows());
            let middle = columns / 2 * columns + columns / 2;
            raw.pins = vec![middle, middle + 1];
        }
    }
    Some(
        raw.into_scene(&Limits::default())
            .expect("the rules make scenes that are right"),
    )
}
