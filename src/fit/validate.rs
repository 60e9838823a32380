//! The checks of what a garment states: its numbers, and the panels and corners of its pattern that
//! it names.

use super::garment::{Garment, PanelSpec, Pin, SCHEMA, WindSpec};
use super::unsupported::{self, escape};
use crate::config::Limits;
use crate::fault::{Fault, GarmentCode};
use crate::json::MOST_LISTED;
use crate::pattern::Pattern;
use crate::solver::SolverOptions;
use std::collections::BTreeSet;

/// Largest offset \[m\] or angle \[degrees\] that a garment may state.
const LARGEST: f64 = 1e4;

/// Panels that a fault names at most.
const MOST_NAMED: usize = 20;

/// A corner that does not move, by the index of its panel and its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct PinnedCorner {
    pub(super) panel: usize,
    pub(super) corner: usize,
}

/// Returns the faults of a garment that show without its pattern: its format, what this version
/// cannot do, numbers.
pub(super) fn own_faults(garment: &Garment, limits: &Limits) -> Vec<Fault> {
    let mut faults = unsupported::faults(garment);
    faults.extend(schema_fault(&garment.schema));
    faults.extend(options_faults(&garment.simulate, limits));
    faults.extend(friction_fault(garment.friction));
    faults.extend(wind_faults(garment.wind, limits));
    faults
}

fn schema_fault(schema: &str) -> Option<Fault> {
    (schema != SCHEMA).then(|| {
        let detail = format!("{schema} is not a format this service reads");
        Fault::new(GarmentCode::Schema, "/schema", detail).fix(format!("give \"{SCHEMA}\""))
    })
}

fn friction_fault(friction: Option<f64>) -> Option<Fault> {
    let is_wrong = friction.is_some_and(|f| !(0.0..=2.0).contains(&f));
    is_wrong.then(|| {
        let detail = "a coefficient of friction lies between 0 and 2";
        Fault::new(GarmentCode::Number, "/friction", detail).fix("cloth on skin: about 0.3")
    })
}

fn wind_faults(wind: Option<WindSpec>, limits: &Limits) -> Vec<Fault> {
    let Some(wind) = wind else {
        return Vec::new();
    };
    let [x, y, z] = wind.velocity_m_s;
    let speed = x.hypot(y).hypot(z);
    let mut faults = Vec::new();
    // `contains` is false of NaN, which so is a fault.
    if !(0.0..=limits.wind_m_s).contains(&speed) {
        let detail = format!("a wind of {speed} m/s is not one to wear a garment in");
        let fix = format!("metres per second, {} at most", limits.wind_m_s);
        faults.push(Fault::new(GarmentCode::Number, "/wind/velocity_m_s", detail).fix(fix));
    }
    if !(0.0..=1.0).contains(&wind.gust) {
        let detail = format!("gust is {}", wind.gust);
        let fix = "give a share of the mean speed, from 0 to 1";
        faults.push(Fault::new(GarmentCode::Number, "/wind/gust", detail).fix(fix));
    }
    faults
}

fn options_faults(options: &SolverOptions, limits: &Limits) -> Vec<Fault> {
    let numbers = [
        (
            "edge_length_m",
            Some(options.edge_length_m),
            limits.edge_length_m,
        ),
        ("tolerance", Some(options.tolerance), [1e-12, 1.0]),
        ("tolerance_m", options.tolerance_m, [1e-9, 0.1]),
        ("seam_eps_m", Some(options.seam_eps_m), [1e-6, 0.05]),
        ("seam_stiffness_n_m", options.seam_stiffness_n_m, [1.0, 1e8]),
        (
            "time_limit_s",
            options.time_limit_s,
            [0.0, limits.fit_cpu_s],
        ),
        ("step_s", options.step_s, [1e-9, 1.0]),
    ];
    let faults = numbers.into_iter();
    let faults = faults.filter_map(|(field, value, range)| range_fault(field, value?, range));
    let faults = faults.chain(step_fault(options));
    faults.chain(distance_fault(options)).collect()
}

fn range_fault(field: &str, value: f64, [low, high]: [f64; 2]) -> Option<Fault> {
    (!(low..=high).contains(&value)).then(|| {
        let (pointer, detail) = (format!("/simulate/{field}"), format!("{field} is {value}"));
        let fix = format!("give a number from {low} to {high}");
        Fault::new(GarmentCode::Number, pointer, detail).fix(fix)
    })
}

fn distance_fault(options: &SolverOptions) -> Option<Fault> {
    (options.tolerance_m.is_some() && options.method.is_time_stepping()).then(|| {
        let method = options.method.name();
        let detail = format!("tolerance_m is given, and {method} cannot tell that distance");
        let fault = Fault::new(GarmentCode::Number, "/simulate/tolerance_m", detail);
        fault.fix("give tolerance in its place, or the method newton")
    })
}

fn step_fault(options: &SolverOptions) -> Option<Fault> {
    (options.step_s.is_some() && !options.method.is_time_stepping()).then(|| {
        let detail = "a drape by this method takes no steps of time";
        Fault::new(GarmentCode::Field, "/simulate/step_s", detail)
            .fix("leave it out, or give a method that steps")
    })
}

/// Returns the faults of what the garment states of single panels.
pub(super) fn panel_faults(garment: &Garment, pattern: &Pattern) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (id, spec) in &garment.panels {
        let pointer = format!("/panels/{}", escape(id));
        if pattern.panel_index(id).is_none() {
            let known = (pattern, faults.len());
            faults.push(unknown_panel(pointer.clone(), id, known));
        }
        if !has_plausible_numbers(spec) {
            let detail = "an offset, a rotation or a grain angle is not a plausible number";
            faults.push(Fault::new(GarmentCode::Number, pointer, detail).fix("metres and degrees"));
        }
    }
    faults
}

fn has_plausible_numbers(spec: &PanelSpec) -> bool {
    let placement = spec.placement.iter();
    let numbers = placement.flat_map(|p| p.offset_m.iter().chain(&p.rotate_deg).chain(&p.up_deg));
    let mut numbers = numbers.chain(&spec.grain_deg);
    numbers.all(|n| n.is_finite() && n.abs() <= LARGEST)
}

/// Finds the pinned corners, and adds a fault for each pin that names none.
pub(super) fn find_pins(
    pins: &[Pin],
    pattern: &Pattern,
    faults: &mut Vec<Fault>,
) -> Vec<PinnedCorner> {
    let mut found = Vec::new();
    for (i, pin) in pins.iter().enumerate() {
        let Some(panel) = pattern.panel_index(&pin.panel) else {
            let (pointer, known) = (format!("/pins/{i}/panel"), (pattern, faults.len()));
            faults.push(unknown_panel(pointer, &pin.panel, known));
            continue;
        };
        let count = pattern.panels[panel].corners.len();
        if pin.corner < count {
            let corner = pin.corner;
            found.push(PinnedCorner { panel, corner });
        } else {
            let detail = format!("panel {} has no corner {}", pin.panel, pin.corner);
            let fault = Fault::new(
                GarmentCode::CornerUnknown,
                format!("/pins/{i}/corner"),
                detail,
            );
            faults.push(fault.fix(format!("its corners are 0 to {}", count - 1)));
        }
    }
    found
}

/// Returns the fault of a panel that the pattern does not have; `earlier` faults were found before.
fn unknown_panel(pointer: String, id: &str, (pattern, earlier): (&Pattern, usize)) -> Fault {
    let detail = format!("the pattern has no panel {id}");
    let fault = Fault::new(GarmentCode::PanelUnknown, pointer, detail);
    if earlier >= MOST_LISTED {
        // It is counted, not listed.
        return fault;
    }
    let known: BTreeSet<&str> = pattern.panels.iter().map(|p| p.id.as_str()).collect();
    let names: Vec<&str> = known.iter().copied().take(MOST_NAMED).collect();
    let more = if known.len() > MOST_NAMED {
        ", ..."
    } else {
        ""
    };
    fault.fix(format!("its panels are {}{more}", names.join(", ")))
}
