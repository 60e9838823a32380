//! The checks of the settings that a study is to vary.

use super::request::StudyRequest;
use crate::config::Limits;
use crate::fault::{Fault, GarmentCode, StudyCode};
use crate::solver::{Analysis, Method, SolverOptions};

/// Returns the faults of a request whose empty lists are filled in; its garment is not looked at,
/// but for `over`, `start_from` and the options of a motion.
pub(super) fn faults(request: &StudyRequest, limits: &Limits) -> Vec<Fault> {
    let mut faults = list_faults(request, limits);
    faults.extend(garment_faults(request));
    faults.extend(too_many_runs(request, limits));
    faults.extend(time_fault(request.time_limit_s, limits));
    if request.garment.simulate.analysis == Analysis::Transient {
        faults.extend(motion_faults(request));
    } else {
        faults.extend(drape_faults(request));
    }
    faults
}

/// Returns the faults of what a study cannot follow: a garment that is worn over another, since not
/// all methods have contact of cloth with cloth, without which the other one is not there, and a
/// shape to start from, which would be nearer to some of its ends than to others.
fn garment_faults(request: &StudyRequest) -> impl Iterator<Item = Fault> {
    let garment = &request.garment;
    let asked = [
        (garment.over.is_some(), "over", "worn over another one"),
        (
            garment.start_from.is_some(),
            "start_from",
            "that starts from another fit",
        ),
    ];
    asked.into_iter().filter_map(|(is_asked, field, what)| {
        let detail = format!("a study of a garment {what} is not available in this version");
        let fault = Fault::new(
            GarmentCode::NotAvailable,
            format!("/garment/{field}"),
            detail,
        );
        is_asked.then(|| fault.fix("leave it out, or sew it as a fit"))
    })
}

fn list_faults(request: &StudyRequest, limits: &Limits) -> Vec<Fault> {
    let lists = [
        ("tolerances", &request.tolerances, [1e-12, 1.0]),
        ("steps_s", &request.steps_s, [1e-9, 1.0]),
        (
            "edge_lengths_m",
            &request.edge_lengths_m,
            limits.edge_length_m,
        ),
    ];
    let mut faults = Vec::new();
    for (name, list, range) in lists {
        faults.extend(out_of_range(name, list, range));
        faults.extend(too_long(name, list.len(), limits));
        faults.extend(repeated(name, list));
    }
    faults.extend(too_long("methods", request.methods.len(), limits));
    faults.extend(repeated("methods", &request.methods));
    faults
}

fn out_of_range(name: &str, list: &[f64], [low, high]: [f64; 2]) -> Vec<Fault> {
    let mut faults = Vec::new();
    for (i, value) in list.iter().enumerate() {
        if !(low..=high).contains(value) {
            let (pointer, detail) = (format!("/{name}/{i}"), format!("it is {value}"));
            let fix = format!("give a number from {low} to {high}");
            faults.push(Fault::new(StudyCode::Number, pointer, detail).fix(fix));
        }
    }
    faults
}

fn too_long(name: &str, length: usize, limits: &Limits) -> Option<Fault> {
    (length > limits.study_list).then(|| {
        let detail = format!("the list has {length} items");
        Fault::new(StudyCode::TooLong, format!("/{name}"), detail)
            .fix(format!("give {} at most", limits.study_list))
    })
}

fn repeated<T: PartialEq>(name: &str, list: &[T]) -> Vec<Fault> {
    let again = (1..list.len()).filter(|&i| list[..i].contains(&list[i]));
    let faults = again.map(|i| {
        let pointer = format!("/{name}/{i}");
        Fault::new(StudyCode::Repeated, pointer, "it is in the list already").fix("leave it out")
    });
    faults.collect()
}

fn too_many_runs(request: &StudyRequest, limits: &Limits) -> Option<Fault> {
    let settings = (request.tolerances.len() + request.steps_s.len()).max(1);
    let runs = request.methods.len() * settings * request.edge_lengths_m.len();
    (runs > limits.study_runs).then(|| {
        let detail = format!("it asks for {runs} runs");
        let fix = format!("ask for {} at most", limits.study_runs);
        Fault::new(StudyCode::TooManyRuns, "", detail).fix(fix)
    })
}

fn time_fault(time_limit_s: Option<f64>, limits: &Limits) -> Option<Fault> {
    let most = limits.study_cpu_s;
    let wrong = time_limit_s.filter(|t| !(0.0..=most).contains(t))?;
    let detail = format!("time_limit_s is {wrong}");
    let fix = format!("give a number from 0 to {most}");
    Some(Fault::new(StudyCode::Number, "/time_limit_s", detail).fix(fix))
}

/// Returns the faults that only a motion can have.
fn motion_faults(request: &StudyRequest) -> Vec<Fault> {
    let SolverOptions {
        duration_s,
        frame_rate_hz,
        ..
    } = request.garment.simulate;
    let mut faults = Vec::new();
    for (i, method) in request.methods.iter().enumerate() {
        if *method == Method::Newton {
            let detail = "newton finds the shape at rest, not the motion";
            faults.push(field_fault(&format!("/methods/{i}"), detail).fix("leave it out"));
        }
    }
    for (name, value) in [("duration_s", duration_s), ("frame_rate_hz", frame_rate_hz)] {
        if let Some(wrong) = value.filter(|v| !(1e-3..=1e3).contains(v)) {
            let pointer = format!("/garment/simulate/{name}");
            let fault = field_fault(&pointer, &format!("{name} is {wrong}"));
            faults.push(fault.fix("give a number from 0.001 to 1000"));
        }
    }
    faults
}

/// Returns the faults that only a drape can have.
fn drape_faults(request: &StudyRequest) -> Vec<Fault> {
    let fix = "leave them out, or ask for a motion";
    let mut faults = Vec::new();
    if !request.steps_s.is_empty() {
        faults.push(field_fault("/steps_s", "steps belong to a motion").fix(fix));
    }
    let options = &request.garment.simulate;
    if options.duration_s.is_some() || options.frame_rate_hz.is_some() {
        let detail = "a duration and a frame rate belong to a motion";
        faults.push(field_fault("/garment/simulate", detail).fix(fix));
    }
    faults
}

fn field_fault(pointer: &str, detail: &str) -> Fault {
    Fault::new(StudyCode::Field, pointer, detail)
}
