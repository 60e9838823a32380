//! Prints the truth table: what the project makes of the real data in the folder that
//! `SEAMSTER_TEST_DATA` names, against what is known of it. Ends with 1 where anything differs.

use seamster_fixtures::truth;
use std::process::ExitCode;

/// Prints the sections of these names, or all of them.
pub(crate) fn main(sections: &[String]) -> ExitCode {
    let Some(data) = truth::data() else {
        eprintln!("SEAMSTER_TEST_DATA must name the folder of real data");
        return ExitCode::FAILURE;
    };
    let mut wrong = 0;
    for (name, make) in truth::SECTIONS {
        if sections.is_empty() || sections.iter().any(|a| a == name) {
            let table = make(&data);
            table.print(name);
            wrong += table.wrong().len();
        }
    }
    if wrong == 0 {
        ExitCode::SUCCESS
    } else {
        println!("{wrong} differences");
        ExitCode::FAILURE
    }
}
