//! The page on the format of garment files: its examples are what the service reads.

use seamster::fit::Garment;
use seamster::pattern::SeamPair;
use serde_json::Value;
use std::path::Path;

/// The blocks of JSON of the page.
fn examples() -> Vec<String> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/garment-format.md");
    let text = std::fs::read_to_string(page).expect("the page");
    let blocks = text.split("```json\n").skip(1);
    let code = |block: &str| block.split("```").next().map(str::to_owned);
    blocks.filter_map(code).collect()
}

#[test]
fn examples_are_garments_and_seams() {
    let mut kinds = [0; 3];
    for example in examples() {
        let value: Value = serde_json::from_str(&example).expect("JSON");
        let (kind, read) = match &value {
            Value::Array(_) => (0, serde_json::from_value::<Vec<SeamPair>>(value).map(drop)),
            Value::Object(fields) if fields.contains_key("seams") => {
                (1, serde_json::from_value::<Garment>(value).map(drop))
            }
            _ => (2, serde_json::from_value::<SeamPair>(value).map(drop)),
        };
        assert!(read.is_ok(), "{example}: {read:?}");
        kinds[kind] += 1;
    }
    assert_eq!((kinds[0], kinds[1]), (2, 1));
    assert!(kinds[2] >= 8, "{kinds:?}");
}
