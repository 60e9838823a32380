//! Suggested seams of drafted garments of many classes and ways of naming, against the seams that
//! they were drafted with.

use seamster::seam::suggest::MIN_SEWN_CONFIDENCE;
use seamster_fixtures::truth::suggest_truth::{SuggestionScore, judge};
use seamster_fixtures::unseen::{UnseenGarment, developed};

/// Garments of each class.
const EACH: u64 = 2;

#[test]
fn drafted_garments_are_sewn_as_they_were_drafted() {
    let mut all = SuggestionScore::default();
    let garments = developed(EACH);
    let mut clean = 0;
    for UnseenGarment { truth, .. } in &garments {
        let score = judge(truth, MIN_SEWN_CONFIDENCE).score;
        clean += usize::from(score.is_without_error());
        all.add(&score);
    }
    // What is required of them.
    let (wrong, missed) = (&all.wrong, &all.missed);
    assert!(all.f1() >= 0.95, "wrong: {wrong:?}, missed: {missed:?}");
    assert!(4 * clean >= 3 * garments.len(), "{clean} without an error");
}
