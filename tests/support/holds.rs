//! What holds of any input at all: what the fuzz targets run, and the tests on the corpus.
#![allow(
    dead_code,
    reason = "each program takes this file in as its own and uses some of it"
)]

use seamster::config::Limits;
use seamster::pattern::{ImportOptions, Pattern, SeamPair, checked, import};
use std::collections::BTreeMap;

/// A file is read as a pattern that passes its own check and survives JSON, or it is refused with a reason and a place.
pub(crate) fn of_file(bytes: &[u8]) {
    match import(bytes, &ImportOptions::default(), &Limits::default()) {
        Ok(pattern) => {
            let json = serde_json::to_string(&pattern).expect("a pattern is JSON");
            let back: Pattern = serde_json::from_str(&json).expect("its own JSON");
            let again = checked(back, &Limits::default());
            let again = again.unwrap_or_else(|faults| panic!("not a pattern: {faults}"));
            assert_eq!(again.panels.len(), pattern.panels.len());
        }
        Err(faults) => {
            assert!(!faults.0.is_empty());
            for fault in faults.0 {
                // Of JSON, a pointer, which is empty where it is about the whole.
                let place = fault.pointer.starts_with("line ") || fault.pointer.starts_with('/');
                assert!(
                    place || bytes.trim_ascii_start().starts_with(b"{"),
                    "{fault:?}"
                );
                assert!(!fault.code.is_empty() && !fault.detail.is_empty());
            }
        }
    }
}

/// Seams of a fixed pattern (the skirt that ships) are all right, or each fault has a place; every seam is reported on.
pub(crate) fn of_seams(bytes: &[u8]) {
    let Ok(pairs) = serde_json::from_slice::<Vec<SeamPair>>(bytes) else {
        return;
    };
    let file = include_bytes!("../../static/samples/skirt.dxf");
    let pattern = import(file, &ImportOptions::default(), &Limits::default());
    let pattern = pattern.expect("the skirt that ships");
    let (report, set) = seamster::seam::check(
        &pattern,
        &pairs,
        &BTreeMap::new(),
        0.012,
        &Limits::default(),
    );
    match set {
        Ok(set) => assert_eq!((set.seams.len(), report.ok), (pairs.len(), true)),
        Err(faults) => assert!(!report.ok && faults.0.iter().all(|f| f.pointer.starts_with('/'))),
    }
}
