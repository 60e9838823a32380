//! Checks what is asked of a study whole, and prepares the garment for every mesh.

use super::asked::StudyAsked;
use crate::config::Limits;
use crate::fault::{Fault, Faults, Warning};
use crate::fit::{self, Garment, Library, Prepared};
use crate::seam::suggest::SuggestedSeam;
use crate::solver::{Analysis, Method, SolverOptions};

/// What an empty list stands for.
const METHODS_OF_A_DRAPE: [Method; 3] = [
    Method::Newton,
    Method::ImplicitEuler,
    Method::SymplecticEuler,
];
const METHODS_OF_A_MOTION: [Method; 4] = [
    Method::SymplecticEuler,
    Method::Verlet,
    Method::ImplicitEuler,
    Method::Bdf2,
];
/// CPU time where none is given \[s\]: a worker is not to be kept for hours unasked.
const TIME: f64 = 600.0;
const TOLERANCES_OF_A_DRAPE: [f64; 4] = [1e-1, 1e-2, 1e-3, 1e-4];

/// A study that was checked whole. Built only by [`prepare`].
#[derive(Clone, Debug)]
pub struct PreparedStudy {
    asked: StudyAsked,
    /// The garment for each of the edge lengths.
    pub(super) fits: Vec<Prepared>,
}

impl PreparedStudy {
    /// What is asked with nothing left open: the garment complete in itself, empty lists filled in (but for steps, which depend
    /// on the scene). To be stored.
    pub fn asked(&self) -> &StudyAsked {
        &self.asked
    }

    /// The seams with their reasons, where the garment left them to the service; else none.
    pub fn suggested(&self) -> &[SuggestedSeam] {
        self.fits[0].suggested()
    }

    /// What a user should know about the garment's seams.
    pub fn warnings(&self) -> &[Warning] {
        self.fits[0].warnings()
    }
}

/// Checks what is asked of a study, and finds everything that its garment refers to.
///
/// # Errors
/// All its faults at once, with JSON Pointers into what is asked.
pub fn prepare(
    mut asked: StudyAsked,
    library: &dyn Library,
    limits: &Limits,
) -> Result<PreparedStudy, Faults> {
    fill_in(&mut asked, limits);
    let mut faults = list_faults(&asked, limits);
    faults.extend(motion_faults(&asked));
    let own = std::mem::take(&mut asked.garment.simulate);
    let mut fits: Vec<Prepared> = Vec::new();
    let [least, most] = limits.edge_length_m;
    let mut lengths = asked.edge_lengths_m.clone();
    lengths.retain(|length| (least..=most).contains(length));
    lengths.truncate(limits.study_list);
    if lengths.is_empty() {
        // The garment's other faults are to be found all the same.
        lengths.push(SolverOptions::default().edge_length_m);
    }
    for (i, &edge_length_m) in lengths.iter().enumerate() {
        // A mesh of its own may divide edges in another way, so each is checked.
        let from = fits.first().map_or(&asked.garment, Prepared::garment);
        match fit::prepare(on_mesh(from, &own, edge_length_m), library, limits) {
            Ok(fit) => fits.push(fit),
            Err(found) => {
                faults.extend(found.under("/garment").0);
                if i == 0 {
                    break;
                }
            }
        }
    }
    Faults(faults).or(())?;
    asked.garment = fits[0].garment().clone();
    asked.garment.simulate = own;
    Ok(PreparedStudy { asked, fits })
}

/// The garment for one mesh. What belongs to the motion alone is the study's and not the fit's.
fn on_mesh(garment: &Garment, own: &SolverOptions, edge_length_m: f64) -> Garment {
    let simulate = SolverOptions {
        analysis: Analysis::Static,
        method: Method::Auto,
        step_s: None,
        duration_s: None,
        frame_rate_hz: None,
        edge_length_m,
        ..own.clone()
    };
    Garment {
        simulate,
        ..garment.clone()
    }
}

fn fill_in(asked: &mut StudyAsked, limits: &Limits) {
    let time = asked.time_limit_s.unwrap_or(TIME.min(limits.study_cpu_s));
    asked.time_limit_s = Some(time);
    let motion = asked.garment.simulate.analysis == Analysis::Transient;
    if asked.methods.is_empty() {
        asked.methods = if motion {
            METHODS_OF_A_MOTION.to_vec()
        } else {
            METHODS_OF_A_DRAPE.to_vec()
        };
    }
    if asked.tolerances.is_empty() && !motion {
        asked.tolerances = TOLERANCES_OF_A_DRAPE.to_vec();
    }
    if asked.edge_lengths_m.is_empty() {
        asked.edge_lengths_m = vec![asked.garment.simulate.edge_length_m];
    }
}

fn list_faults(asked: &StudyAsked, limits: &Limits) -> Vec<Fault> {
    let mut faults = Vec::new();
    let lists = [
        ("tolerances", &asked.tolerances, [1e-12, 1.0]),
        ("steps_s", &asked.steps_s, [1e-9, 1.0]),
        (
            "edge_lengths_m",
            &asked.edge_lengths_m,
            limits.edge_length_m,
        ),
    ];
    for (name, list, bounds) in lists {
        faults.extend(numbers_out_of_range(name, list, bounds));
        faults.extend(too_long(name, list.len(), limits));
        faults.extend(repeated(name, list));
    }
    faults.extend(too_long("methods", asked.methods.len(), limits));
    faults.extend(repeated("methods", &asked.methods));
    let settings = (asked.tolerances.len() + asked.steps_s.len()).max(1);
    let runs = asked.methods.len() * settings * asked.edge_lengths_m.len();
    if runs > limits.study_runs {
        let detail = format!("it asks for {runs} runs");
        let fix = format!("ask for {} at most", limits.study_runs);
        faults.push(Fault::new("study/too_many_runs", "", detail).fix(fix));
    }
    let time = [0.0, limits.study_cpu_s];
    let given = asked
        .time_limit_s
        .filter(|t| !(time[0]..=time[1]).contains(t));
    faults.extend(given.map(|t| {
        Fault::new(
            "study/number",
            "/time_limit_s",
            format!("time_limit_s is {t}"),
        )
        .fix(format!("give a number from {} to {}", time[0], time[1]))
    }));
    faults
}

fn numbers_out_of_range(name: &str, list: &[f64], [low, high]: [f64; 2]) -> Vec<Fault> {
    let wrong = list
        .iter()
        .enumerate()
        .filter(|(_, v)| !(low..=high).contains(*v));
    wrong
        .map(|(i, v)| {
            Fault::new("study/number", format!("/{name}/{i}"), format!("it is {v}"))
                .fix(format!("give a number from {low} to {high}"))
        })
        .collect()
}

fn too_long(name: &str, length: usize, limits: &Limits) -> Option<Fault> {
    (length > limits.study_list).then(|| {
        let detail = format!("the list has {length} items");
        Fault::new("study/too_long", format!("/{name}"), detail)
            .fix(format!("give {} at most", limits.study_list))
    })
}

fn repeated<T: PartialEq>(name: &str, list: &[T]) -> Vec<Fault> {
    let again = (1..list.len()).filter(|&i| list[..i].contains(&list[i]));
    again
        .map(|i| {
            let at = format!("/{name}/{i}");
            Fault::new("study/repeated", at, "it is in the list already").fix("leave it out")
        })
        .collect()
}

/// What only a motion has, or only a drape.
fn motion_faults(asked: &StudyAsked) -> Vec<Fault> {
    let simulate = &asked.garment.simulate;
    let mut faults = Vec::new();
    let mut refuse = |wrong: bool, pointer: String, detail: String, fix: &str| {
        if wrong {
            faults.push(Fault::new("study/field", pointer, detail).fix(fix));
        }
    };
    if simulate.analysis == Analysis::Transient {
        for (i, method) in asked.methods.iter().enumerate() {
            let at = format!("/methods/{i}");
            let detail = "newton finds the shape at rest, not the motion".to_owned();
            refuse(*method == Method::Newton, at, detail, "leave it out");
        }
        for (name, value) in [
            ("duration_s", simulate.duration_s),
            ("frame_rate_hz", simulate.frame_rate_hz),
        ] {
            let wrong = value.is_some_and(|v| !(1e-3..=1e3).contains(&v));
            let at = format!("/garment/simulate/{name}");
            let detail = format!("{name} is {}", value.unwrap_or_default());
            refuse(wrong, at, detail, "give a number from 0.001 to 1000");
        }
    } else {
        let both = "steps belong to a motion".to_owned();
        let fix = "leave them out, or ask for a motion";
        refuse(!asked.steps_s.is_empty(), "/steps_s".to_owned(), both, fix);
        let given = simulate.duration_s.is_some() || simulate.frame_rate_hz.is_some();
        let at = "/garment/simulate".to_owned();
        let detail = "a duration and a frame rate belong to a motion".to_owned();
        refuse(given, at, detail, fix);
    }
    faults
}
