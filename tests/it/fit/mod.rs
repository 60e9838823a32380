//! Tests of `fit`: garments sewn from pattern to report.

mod carriers;
mod format_page;
mod garmentcode;
mod laid;
mod layers;
mod maps;
mod over;
mod samples;
mod seams;
mod sizes;
mod suggested;
mod true_garments;
mod verdict;

use seamster::config::Limits;
use seamster::fit::{self, FitOutcome, Garment, ShippedAssets};
use seamster::job::thread_cpu_s;
use seamster::progress::CancelToken;
use seamster::solver::Context;

/// Sews a garment that is sound.
fn sewn(garment: Garment) -> FitOutcome {
    let limits = Limits::default();
    let prepared = fit::resolve(garment, &ShippedAssets, &limits).expect("it can be sewn");
    let mut context = Context {
        cpu_s: &thread_cpu_s,
        cancel: &CancelToken::new(),
        progress: &mut |_| {},
        limits: &limits,
    };
    fit::run(&prepared, &mut context).expect("the mesh is within the limits")
}
