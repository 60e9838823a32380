//! The import of real files against the truth that lies beside them: the rows of the truth table.

use seamster_fixtures::truth;

#[test]
fn real_files_are_read_as_the_truth_has_them() {
    let Some(data) = truth::data() else {
        println!("left out: the truth of 48 real files (SEAMSTER_TEST_DATA is unset)");
        return;
    };
    for (name, make) in truth::SECTIONS.iter().filter(|s| s.0 == "import") {
        let table = make(&data);
        table.print(name);
        assert_eq!(table.rows.len(), 48);
        assert!(table.wrong().is_empty(), "{}", table.wrong().join("\n"));
    }
}
