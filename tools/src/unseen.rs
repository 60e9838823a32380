//! Prints how well seams are suggested for drafted garments that the rules were not made with: F1,
//! precision, share of garments without an error, garments refused, and calibration. Offers (below
//! a confidence of one half) count as not suggested.

use clap::Args;
use seamster::seam::suggest::MIN_SEWN_CONFIDENCE;
use seamster_fixtures::truth::suggest_truth::{JudgedSeam, SuggestionScore, judge};
use seamster_fixtures::unseen::{UnseenGarment, developed, held_out};
use std::collections::BTreeMap;

/// Confidences between which the share of right seams is told.
const BINS: [f64; 7] = [0.0, 0.5, 0.7, 0.9, 0.95, 0.98, 1.0];

/// Options of the table.
#[derive(Args)]
pub(crate) struct UnseenOptions {
    /// Garments kept out of development.
    #[arg(long)]
    held_out: bool,
    /// Garments of each design.
    #[arg(long, default_value_t = 8)]
    each: u64,
    /// Prints what is missed and what is wrong, a line a garment.
    #[arg(long)]
    verbose: bool,
    /// Only garments of this design.
    #[arg(long)]
    design: Option<String>,
}

/// Figures of several garments.
#[derive(Default)]
struct Tally {
    score: SuggestionScore,
    garments: usize,
    without_error: usize,
    refused: usize,
}

impl Tally {
    fn add(&mut self, score: &SuggestionScore) {
        self.score.add(score);
        self.garments += 1;
        self.refused += usize::from(score.suggested == 0);
        self.without_error += usize::from(score.is_without_error());
    }

    fn print(&self, name: &str) {
        println!(
            "| {name} | {} | {:.3} | {:.3} ({}/{}) | {:.3} ({}/{}) | {} | {} |",
            self.garments,
            self.score.f1(),
            self.score.precision(),
            self.score.right,
            self.score.suggested,
            self.score.recall(),
            self.score.found,
            self.score.seams,
            self.without_error,
            self.refused
        );
    }
}

/// Prints the table.
pub(crate) fn main(options: &UnseenOptions) {
    let garments = if options.held_out {
        held_out(options.each)
    } else {
        developed(options.each)
    };
    let wanted = |g: &&UnseenGarment| options.design.as_ref().is_none_or(|d| d == g.design);
    let mut by: BTreeMap<String, Tally> = BTreeMap::new();
    let mut seams: Vec<JudgedSeam> = vec![];
    for garment in garments.iter().filter(wanted) {
        let judged = judge(&garment.truth, MIN_SEWN_CONFIDENCE);
        if options.verbose {
            tell(garment, &judged.score, &judged.seams);
        }
        let names = if garment.named { "named" } else { "unnamed" };
        for name in [
            format!("1 {}", garment.design),
            format!("2 {names}"),
            "3 all".into(),
        ] {
            by.entry(name).or_default().add(&judged.score);
        }
        seams.extend(judged.seams);
    }
    println!("| garments | count | F1 | precision | recall | without an error | refused |");
    println!("|---|---:|---:|---:|---:|---:|---:|");
    for (name, tally) in &by {
        tally.print(&name[2..]);
    }
    calibration(&seams);
}

/// Prints what is wrong with a garment, with the confidences of wrong seams and the reasons of
/// refusal.
fn tell(garment: &UnseenGarment, score: &SuggestionScore, seams: &[JudgedSeam]) {
    if score.found == score.seams && score.right == score.suggested {
        return;
    }
    let names: Vec<&str> = garment
        .truth
        .pattern
        .panels
        .iter()
        .map(|p| p.name.as_str())
        .collect();
    let wrong = seams.iter().filter(|s| !s.right);
    let wrong: Vec<String> = wrong
        .map(|s| format!("{} {:.2}", s.id, s.confidence))
        .collect();
    println!(
        "{} {} [{}] {:?}",
        garment.design, garment.seed, garment.naming, names
    );
    println!("    missed {:?}", score.missed);
    println!("    wrong {wrong:?}");
    let found = seamster::seam::suggest::suggest(&garment.truth.pattern, &Default::default());
    for warning in &found.warnings {
        println!("    {}", warning.detail);
    }
}

/// Prints the share of right seams in each bin of confidence.
fn calibration(seams: &[JudgedSeam]) {
    println!();
    println!("| confidence | seams | mean confidence | right |");
    println!("|---|---:|---:|---:|");
    let mut error = 0.0;
    for ends in BINS.windows(2) {
        let last = ends[1] == 1.0;
        let within = |s: &&JudgedSeam| s.confidence >= ends[0] && (s.confidence < ends[1] || last);
        let all: Vec<&JudgedSeam> = seams.iter().filter(within).collect();
        let count = all.len().max(1) as f64;
        let mean = all.iter().map(|s| s.confidence).sum::<f64>() / count;
        let right = all.iter().filter(|s| s.right).count() as f64 / count;
        error += (mean - right).abs() * all.len() as f64 / seams.len().max(1) as f64;
        println!(
            "| {}-{} | {} | {mean:.3} | {right:.3} |",
            ends[0],
            ends[1],
            all.len()
        );
    }
    println!("\nExpected calibration error {error:.3}");
}
