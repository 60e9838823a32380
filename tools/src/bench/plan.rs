//! Plan of the runs: every scene with every method that makes sense on it, over tolerances or
//! times.

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// One run to be made.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct BenchRun {
    pub(crate) scene: String,
    /// Fields of `SolverOptions` that differ from its defaults.
    pub(crate) setting: Value,
    /// CPU time allowed \[s\].
    pub(crate) limit_s: f64,
    /// True if a second method is to confirm the reference.
    pub(crate) confirm: bool,
}

/// A scene of the benchmark.
struct Bench {
    name: &'static str,
    /// CPU time allowed to one run \[s\].
    limit_s: f64,
    /// Residuals that Newton's method is to reach.
    newton: &'static [f64],
    /// Residuals that a motion is followed to.
    motion: &'static [f64],
}

/// A row of residuals for a curve of error against work.
const ROW: &[f64] = &[1e-2, 1e-3, 1e-5, 1e-8];
const PAIR: &[f64] = &[1e-3, 1e-5];
/// Options of the solver for a run.
const LAST: &[f64] = &[1e-5];
/// As near to rest as a slow motion comes in the time.
const ONE: &[f64] = &[1e-3];
const NONE: &[f64] = &[];

const fn bench(
    name: &'static str,
    limit_s: f64,
    newton: &'static [f64],
    motion: &'static [f64],
) -> Bench {
    Bench {
        name,
        limit_s,
        newton,
        motion,
    }
}

/// In the order of running: the sizes that others have run and the tubes first, should the time not
/// do for all.
const BENCHES: [Bench; 32] = [
    bench("S1P", 10.0, ROW, ROW),
    bench("S1P_x100", 10.0, ROW, ROW),
    bench("S1T", 10.0, ROW, ONE),
    bench("S1T_x100", 10.0, PAIR, NONE),
    bench("S2", 10.0, ROW, ROW),
    bench("S2_smooth", 10.0, ROW, ONE),
    bench("S2_x100", 10.0, LAST, NONE),
    bench("S2_x100_smooth", 10.0, LAST, NONE),
    bench("S3", 10.0, ROW, ONE),
    bench("S3_smooth", 10.0, ROW, ONE),
    bench("S3_x100", 10.0, LAST, NONE),
    bench("S3_x100_smooth", 10.0, LAST, NONE),
    bench("tube2k", 10.0, ROW, ONE),
    bench("tube2k_x100", 10.0, LAST, NONE),
    bench("tube10k", 20.0, PAIR, NONE),
    bench("tube10k_x100", 20.0, LAST, NONE),
    bench("tube30k", 40.0, LAST, NONE),
    bench("tube100k", 60.0, LAST, NONE),
    bench("S1P_65", 10.0, PAIR, ONE),
    bench("S1P_129", 10.0, LAST, NONE),
    bench("S1P_65_x100", 10.0, LAST, NONE),
    bench("S1P_129_x100", 10.0, LAST, NONE),
    bench("S1T_65", 10.0, LAST, NONE),
    bench("S1T_129", 10.0, LAST, NONE),
    bench("S2_65", 10.0, LAST, NONE),
    bench("S2_65_smooth", 10.0, LAST, NONE),
    bench("S2_129", 20.0, LAST, NONE),
    bench("S2_129_smooth", 20.0, LAST, NONE),
    bench("S3_81", 20.0, LAST, NONE),
    bench("S3_81_smooth", 20.0, LAST, NONE),
    bench("S3_161", 20.0, LAST, NONE),
    bench("S3_161_smooth", 20.0, LAST, NONE),
];

/// Methods that follow the motion until it has died.
const TRAJECTORIES: [&str; 4] = ["symplectic_euler", "verlet", "implicit_euler", "bdf2"];
/// CPU times at which the error of S1P is asked for \[s\].
const TIMES: [f64; 3] = [0.02, 0.05, 0.1];

/// The names of all scenes.
pub(crate) fn names() -> Vec<&'static str> {
    BENCHES.iter().map(|bench| bench.name).collect()
}

/// The runs on the scenes that are asked for, all if none is, by one method or all.
pub(crate) fn runs(scenes: &[String], method: Option<&str>) -> Vec<BenchRun> {
    let asked = |name: &str| {
        let named = |pattern: &String| match pattern.strip_suffix('*') {
            Some(start) => name.starts_with(start),
            None => pattern == name,
        };
        scenes.is_empty() || scenes.iter().any(named)
    };
    BENCHES
        .iter()
        .filter(|bench| asked(bench.name))
        .flat_map(Bench::runs)
        .filter(|run| method.is_none_or(|method| run.setting["method"] == method))
        .collect()
}

impl Bench {
    fn runs(&self) -> Vec<BenchRun> {
        let setting =
            |method: &str, tolerance: f64| json!({"method": method, "tolerance": tolerance});
        let newton = self.newton.iter().map(|&t| setting("newton", t));
        let mut settings: Vec<Value> = newton.collect();
        if self.name == "S1P" {
            let timed =
                |s: &f64| json!({"method": "newton", "tolerance": 1e-12, "time_limit_s": s});
            settings.extend(TIMES.iter().map(timed));
        }
        if matches!(self.name, "S3" | "S3_smooth") {
            settings.push(json!({
                "method": "newton", "tolerance": 1e-5, "seam_close": "spring",
                "seam_stiffness_n_m": seamster_fixtures::scenes::net::SEAM_STIFFNESS,
            }));
        }
        if self.name == "tube2k" {
            settings.push(json!({"method": "newton", "tolerance": 1e-5, "membrane": "springs"}));
        }
        for method in TRAJECTORIES {
            settings.extend(self.motion.iter().map(|&t| setting(method, t)));
        }
        settings
            .into_iter()
            .map(|setting| self.run(setting))
            .collect()
    }

    fn run(&self, setting: Value) -> BenchRun {
        let confirm =
            !self.motion.is_empty() && setting == json!({"method": "newton", "tolerance": 1e-2});
        BenchRun {
            scene: self.name.to_owned(),
            limit_s: self.limit_s,
            confirm,
            setting,
        }
    }
}
