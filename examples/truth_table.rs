//! Prints the truth table: what the project makes of the real data in the folder that `SEAMSTER_TEST_DATA` names,
//! against what is known of it. Arguments choose sections; ends with 1 where anything differs.

#[path = "../tests/support/truth/mod.rs"]
mod truth;

use std::process::ExitCode;

fn main() -> ExitCode {
    let Some(data) = truth::data() else {
        eprintln!("SEAMSTER_TEST_DATA must name the folder of real data");
        return ExitCode::FAILURE;
    };
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let mut wrong = 0;
    for (name, make) in truth::SECTIONS {
        if asked.is_empty() || asked.iter().any(|a| a == name) {
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
