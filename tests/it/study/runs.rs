//! Studies: what they measure agrees with theory, they say what they could not do, and tell the
//! same every time.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on has failed")]

use seamster::config::Limits;
use seamster::fit::ShippedAssets;
use seamster::progress::CancelToken;
use seamster::scene::Scene;
use seamster::solver::{Analysis, Context, Method, SolverOptions};
use seamster::study::{
    Study, StudyPlan, StudyRequest, StudyScene, plot_svg, read_study, resolve, run, run_scenes,
};
use seamster_fixtures::samples::{garment, with_context};
use serde_json::{Value, json};
use std::cell::Cell;

const STEPPING: [Method; 4] = seamster_fixtures::motions::METHODS;

fn quiet<T>(run: impl FnOnce(&mut Context<'_>) -> T) -> T {
    with_context(&Limits::default(), &CancelToken::new(), |_| {}, run)
}

fn on(scene: Scene) -> [StudyScene; 1] {
    [StudyScene {
        edge_length_m: 0.05,
        scene,
    }]
}

/// Drapes of a small net that hangs taut in its plane.
fn taut_plan() -> StudyPlan {
    StudyPlan {
        simulate: SolverOptions::default(),
        methods: vec![
            Method::Newton,
            Method::ImplicitEuler,
            Method::SymplecticEuler,
        ],
        tolerances: vec![1e-1, 1e-3],
        steps_s: vec![],
        time_limit_s: None,
    }
}

fn taut() -> [StudyScene; 1] {
    on(seamster_fixtures::scenes::scene("S1P_9").unwrap())
}

/// A study of a sample garment.
fn of_sample(name: &str, changes: Value, study: Value) -> Study {
    let mut asked = study;
    asked["garment"] = serde_json::to_value(garment(name, changes)).unwrap();
    let asked: StudyRequest = read_study(asked.to_string().as_bytes(), &Limits::default()).unwrap();
    let prepared = resolve(asked, &ShippedAssets, &Limits::default()).unwrap();
    quiet(|context| run(&prepared, context).unwrap())
}

/// All but what depends on the clock.
fn without_times(mut study: Study) -> Study {
    study.cpu_s = 0.0;
    study.runs.iter_mut().for_each(|run| run.cpu_s = 0.0);
    for mesh in &mut study.meshes {
        mesh.reference.cpu_s = 0.0;
    }
    study.recommendation.clear();
    study
}

#[test]
fn on_a_taut_net_two_methods_agree_and_tighter_runs_are_nearer() {
    let study = quiet(|context| run_scenes(&taut(), &taut_plan(), context));
    assert!(study.complete, "{:?}", study.left_out);
    let mesh = &study.meshes[0];
    let reference = &mesh.reference;
    assert!(reference.confirmed && !reference.several_rest_shapes);
    assert_eq!(mesh.minima.len(), 1, "a taut net has one rest shape");
    // At a minimum the energy is flat: shapes 1e-5 m apart differ by far less than a millionth of
    // it.
    let [a, b] = reference.energies_j[..] else {
        panic!("two methods");
    };
    assert!((a - b).abs() <= 1e-6 * a.abs(), "{a} {b}");
    assert_eq!(study.runs.len(), 6);
    for runs in study.runs.chunks(2) {
        let error = |i: usize| runs[i].error_m.unwrap();
        assert!(
            runs.iter()
                .all(|r| r.converged && r.same_as_reference == Some(true))
        );
        assert!(error(1) < error(0), "{runs:?}");
        // The solver says that its estimate holds: within three times.
        for run in runs.iter().filter(|r| r.estimate_valid && r.error_certain) {
            let ratio = run.estimate_m.unwrap() / run.error_m.unwrap();
            assert!((0.3..3.0).contains(&ratio), "{run:?}");
        }
    }
    assert!(study.recommendation.starts_with("For errors below "));
}

/// The errors of fixed steps h ω <= 0.05 fall by the method's order; the next term of the error is
/// a few per cent of the first.
#[test]
fn observed_orders_are_those_of_theory() {
    let points = [[0.0, 0.0, 0.0], [0.5, 0.1, 0.0], [1.0, 0.0, 0.3]];
    let springs = [(0, 1, 0.4, 3.0), (1, 2, 0.45, 2.0), (0, 2, 1.0, 1.0)];
    let scene = Scene {
        gravity: nalgebra::Vector3::new(0.0, -9.8, 0.0),
        drag: Some(0.6),
        pins: vec![0],
        ..seamster_fixtures::motions::net(
            points.map(nalgebra::Vector3::from).to_vec(),
            vec![0.1, 0.1, 0.15],
            &springs,
        )
    };
    let plan = StudyPlan {
        simulate: SolverOptions {
            analysis: Analysis::Transient,
            duration_s: Some(0.5),
            frame_rate_hz: Some(10.0),
            ..SolverOptions::default()
        },
        methods: STEPPING.to_vec(),
        tolerances: vec![],
        steps_s: vec![5e-3, 2.5e-3, 1.25e-3],
        time_limit_s: None,
    };
    let study = quiet(|context| run_scenes(&on(scene), &plan, context));
    assert!(study.meshes[0].reference.confirmed, "{:?}", study.meshes);
    assert_eq!(study.orders.len(), STEPPING.len());
    for (order, method) in study.orders.iter().zip(STEPPING) {
        let theory = match method {
            Method::SymplecticEuler | Method::ImplicitEuler => 1.0,
            _ => 2.0,
        };
        assert_eq!((order.method, order.theory), (method, theory));
        assert_eq!(order.steps_s.len(), 3, "every error is certain: {order:?}");
        let observed = order.observed.unwrap();
        assert!((observed - theory).abs() < 0.1, "{order:?}");
    }
}

/// Stability limits are within 20 % of theory, on a net and on a sewn garment that a body carries.
#[test]
fn stability_limits_are_near_those_of_theory() {
    let plan = StudyPlan {
        methods: STEPPING.to_vec(),
        tolerances: vec![1e-1],
        ..taut_plan()
    };
    let net = quiet(|context| run_scenes(&taut(), &plan, context));
    // Drapes by explicit steps would take long on cloth; the start of a fall does not.
    let simulate = json!({"want": "motion", "duration_s": 0.01, "frame_rate_hz": 100.0});
    let sewn = of_sample(
        "skirt",
        json!({"friction": 0, "simulate": simulate}),
        json!({"methods": ["symplectic_euler", "verlet"], "steps_s": [2e-5], "edge_lengths_m": [0.06]}),
    );
    for (study, count) in [(&net, 4), (&sewn, 2)] {
        assert_eq!(study.stability.len(), count, "{:?}", study.left_out);
        for limit in &study.stability {
            if matches!(limit.method, Method::SymplecticEuler | Method::Verlet) {
                let (found, theory) = (limit.found_s.unwrap(), limit.theory_s.unwrap());
                assert!((found / theory - 1.0).abs() < 0.2, "{limit:?}");
            } else {
                assert_eq!((limit.found_s, limit.theory_s), (None, None));
                assert!(limit.because.starts_with("none found up to"), "{limit:?}");
                assert!(limit.tried_s > 0.0);
            }
        }
    }
    // Without drag both have the same limit, 2 / ω; drag takes a little from symplectic Euler.
    let found = |i: usize| net.stability[i].theory_s.unwrap();
    assert!(found(0) < found(1) && found(0) > 0.9 * found(1));
}

#[test]
fn on_a_taut_garment_the_methods_agree_and_meshes_are_compared() {
    let broad = json!({"form": {"height_m": 1.68, "bust_m": 1.1, "waist_m": 1.02, "hip_m": 1.12}});
    let simulate = json!({"membrane": "springs", "seam_close": "spring"});
    let changes = json!({"friction": 0, "default_fabric": "ponte-knit", "avatar": broad, "simulate": simulate});
    let study = of_sample(
        "top",
        changes,
        json!({"methods": ["newton", "implicit_euler"], "tolerances": [1e-3], "edge_lengths_m": [0.04, 0.035]}),
    );
    let [coarse, fine] = &study.meshes[..] else {
        panic!("two meshes");
    };
    assert!(coarse.reference.confirmed, "{:?}", coarse.reference);
    assert!(coarse.vertices < fine.vertices);
    // Meshes of 40 and 35 mm cannot agree to a tenth of a millimeter round a body, nor differ by
    // more than an edge. (The middles of longer edges catch on the body: there are several shapes.)
    let error = coarse.mesh_error_m.unwrap();
    assert!((1e-4..0.05).contains(&error), "{error}");
    assert_eq!(fine.mesh_error_m, None);
}

#[test]
fn on_a_slack_garment_several_rest_shapes_are_said() {
    let study = of_sample(
        "skirt",
        json!({"friction": 0, "simulate": {"edge_length_m": 0.05}}),
        json!({"methods": ["newton", "implicit_euler"], "tolerances": [1e-3]}),
    );
    let mesh = &study.meshes[0];
    assert!(mesh.reference.several_rest_shapes && !mesh.reference.confirmed);
    assert!(mesh.minima.len() > 1 && mesh.reference.energies_j.len() == 2);
    assert!(mesh.reference.because.contains("several rest shapes"));
    assert!(study.notes.iter().any(|note| note.contains("energies")));
    // Each error is the distance to the rest shape of the run itself, far below that between the
    // shapes.
    for run in &study.runs {
        assert!(
            run.error_m.unwrap() < mesh.reference.apart_m.unwrap(),
            "{run:?}"
        );
    }
}

#[test]
fn the_same_study_gives_the_same_bytes_and_they_are_read_back() {
    let study = || quiet(|context| run_scenes(&taut(), &taut_plan(), context));
    let (a, b) = (without_times(study()), without_times(study()));
    let text = serde_json::to_string(&a).unwrap();
    assert_eq!(text, serde_json::to_string(&b).unwrap());
    // A number that is not finite would be null, and not be read back as one.
    assert_eq!(serde_json::from_str::<Study>(&text).unwrap(), a);
}

#[test]
fn a_raised_flag_ends_it_and_what_was_left_out_is_listed() {
    let cancel = CancelToken::new();
    let raised = cancel.clone();
    let told = Cell::new(0.0);
    let tell = |progress: seamster::progress::Progress| {
        assert!(progress.fraction >= told.get() && progress.fraction <= 1.0);
        told.set(progress.fraction);
        if progress.fraction > 0.3 {
            raised.cancel();
        }
    };
    let study = with_context(&Limits::default(), &cancel, tell, |context| {
        run_scenes(&taut(), &taut_plan(), context)
    });
    assert!(study.canceled && !study.complete);
    assert!(!study.runs.is_empty() && study.runs.len() < 6);
    assert!(
        study
            .left_out
            .iter()
            .any(|l| l.because.contains("canceled"))
    );
}

/// A clock that goes on by a millisecond at every look.
fn ticking() -> impl Fn() -> f64 {
    let now = Cell::new(0.0);
    move || {
        now.set(now.get() + 1e-3);
        now.get()
    }
}

#[test]
fn the_time_allowed_is_kept_to() {
    for limit in [0.0, 0.5] {
        let plan = StudyPlan {
            time_limit_s: Some(limit),
            ..taut_plan()
        };
        let (limits, cancel, clock) = (Limits::default(), CancelToken::new(), ticking());
        let mut context = Context {
            cpu_s: &clock,
            cancel: &cancel,
            progress: &mut |_| {},
            limits: &limits,
        };
        let study = run_scenes(&taut(), &plan, &mut context);
        assert!(!study.complete && !study.canceled);
        let late = study.left_out.iter().filter(|l| l.because.contains("time"));
        assert!(late.count() > 0, "{:?}", study.left_out);
        // An iteration or a block of steps that has begun is finished.
        assert!(study.cpu_s < limit + 0.5, "{} of {limit}", study.cpu_s);
        assert_eq!(study.runs.is_empty(), limit == 0.0);
        let text = serde_json::to_string(&study).unwrap();
        assert_eq!(serde_json::from_str::<Study>(&text).unwrap(), study);
    }
}

/// Tags that close in the order in which they opened, and no `<` or bare `&` in texts.
fn assert_well_formed(svg: &str) {
    let mut open: Vec<&str> = vec![];
    let mut rest = svg;
    while let Some(at) = rest.find('<') {
        let text = &rest[..at];
        let bare = |(i, _): (usize, &str)| {
            !text[i..].split(';').next().unwrap()[1..]
                .chars()
                .all(char::is_alphabetic)
        };
        assert!(!text.match_indices('&').any(bare), "{text}");
        let end = at + rest[at..].find('>').expect("a tag ends");
        let tag = &rest[at + 1..end];
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name));
        } else if !tag.ends_with('/') {
            open.push(tag.split_whitespace().next().unwrap());
        }
        rest = &rest[end + 1..];
    }
    assert!(open.is_empty() && rest.trim().is_empty());
}

#[test]
fn the_plot_is_xml_and_has_every_run() {
    let mut study = quiet(|context| run_scenes(&taut(), &taut_plan(), context));
    study.runs[0].why = "<b> & \"c\"".to_owned();
    study.runs[0].converged = false;
    study.runs[1].error_m = None;
    let svg = plot_svg(&study);
    assert_well_formed(&svg);
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    let drawn = svg.matches(" s, error ").count();
    let listed = svg.matches("not drawn: ").count();
    assert_eq!((drawn, listed), (study.runs.len() - 1, 1));
    for name in ["newton", "implicit_euler", "symplectic_euler"] {
        assert!(svg.contains(&format!(">{name}</text>")), "{name}");
    }
}

#[test]
fn all_faults_of_what_is_asked_come_at_once() {
    let mut asked = json!({
        "methods": ["newton", "newton"], "tolerances": [1e-3, -1.0], "steps_s": [1e-3],
        "edge_lengths_m": [0.03, 7.0], "time_limit_s": -2.0,
    });
    asked["garment"] = serde_json::to_value(garment("skirt", json!({"friction": 9}))).unwrap();
    let asked = read_study(asked.to_string().as_bytes(), &Limits::default()).unwrap();
    let faults = resolve(asked, &ShippedAssets, &Limits::default()).unwrap_err();
    let mut at: Vec<&str> = faults.0.iter().map(|f| f.pointer.as_str()).collect();
    at.sort_unstable();
    let expected = [
        "/edge_lengths_m/1",
        "/garment/friction",
        "/methods/1",
        "/steps_s",
        "/time_limit_s",
        "/tolerances/1",
    ];
    assert_eq!(at, expected);
}

/// A fit refuses a motion, a study takes it; what it gives back to be stored can be prepared again.
#[test]
fn a_motion_is_taken_and_kept_in_what_is_stored() {
    let mut asked = json!({"edge_lengths_m": [0.06]});
    let simulate = json!({"want": "motion", "duration_s": 0.1, "frame_rate_hz": 20.0});
    asked["garment"] =
        serde_json::to_value(garment("skirt", json!({"simulate": simulate}))).unwrap();
    let asked = read_study(asked.to_string().as_bytes(), &Limits::default()).unwrap();
    let prepared = resolve(asked, &ShippedAssets, &Limits::default()).unwrap();
    let stored = prepared.request().clone();
    assert_eq!(stored.garment.simulate.analysis, Analysis::Transient);
    assert_eq!(stored.garment.simulate.duration_s, Some(0.1));
    assert_eq!(stored.methods, STEPPING);
    let again = serde_json::to_vec(&stored).unwrap();
    let again = resolve(
        read_study(&again, &Limits::default()).unwrap(),
        &ShippedAssets,
        &Limits::default(),
    )
    .unwrap();
    assert_eq!(again.request(), &stored);
}
