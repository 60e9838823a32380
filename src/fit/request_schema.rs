//! Requests read from JSON: all faults against their schema at once, before serde, which stops at
//! the first.

use super::garment::Garment;
use super::{json_schema, schema_fault};
use crate::fault::{Fault, Faults, RequestCode};
use jsonschema::Validator;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::sync::LazyLock;
use utoipa::ToSchema;

/// The most faults of one request that are listed; a file of another kind has one at every line.
const MOST_LISTED: usize = 100;

/// The schema of a request type, ready to check with.
#[derive(Debug)]
pub(crate) struct RequestSchema {
    schema: Value,
    validator: Validator,
}

/// The reason why bytes could not be read as a request.
#[derive(Debug, PartialEq)]
pub enum ReadError {
    /// They are not JSON.
    Syntax(Fault),
    /// They are JSON, but not as the schema says.
    Schema(Faults),
}

impl From<ReadError> for Faults {
    fn from(error: ReadError) -> Self {
        match error {
            ReadError::Syntax(fault) => fault.into(),
            ReadError::Schema(faults) => faults,
        }
    }
}

/// Reads a garment from its JSON; [`resolve`](super::resolve()) checks its meaning.
///
/// # Errors
/// Where it is not JSON, or every field that is missing, unknown or of the wrong kind.
pub fn read_garment(bytes: &[u8]) -> Result<Garment, ReadError> {
    // Made from the type alone, once.
    static SCHEMA: LazyLock<RequestSchema> = LazyLock::new(RequestSchema::of::<Garment>);
    SCHEMA.read(bytes)
}

impl RequestSchema {
    /// Returns the schema of `T`.
    pub(crate) fn of<T: ToSchema>() -> Self {
        let schema = json_schema::of::<T>();
        let validator = jsonschema::draft202012::options()
            .should_validate_formats(true)
            .build(&schema)
            .expect("a generated schema is a schema; a test builds every one");
        Self { schema, validator }
    }

    /// Reads a value.
    ///
    /// # Errors
    /// Where it is not JSON, or every place where it differs from the schema.
    pub(crate) fn read<T: DeserializeOwned>(&self, bytes: &[u8]) -> Result<T, ReadError> {
        let mut value = parse(bytes).map_err(ReadError::Syntax)?;
        let faults = self.faults(&value);
        faults.or(()).map_err(ReadError::Schema)?;
        make_whole_numbers_integers(&mut value);
        serde_json::from_value(value).map_err(|error| {
            ReadError::Schema(Fault::new(RequestCode::Shape, "", error.to_string()).into())
        })
    }

    /// Returns a fault for every place where `value` differs from the schema.
    fn faults(&self, value: &Value) -> Faults {
        let mut faults = vec![];
        for error in self.validator.iter_errors(value) {
            faults.extend(schema_fault::faults(&self.schema, &error));
            if faults.len() > MOST_LISTED {
                faults.truncate(MOST_LISTED);
                let detail =
                    format!("there are more than {MOST_LISTED} faults; the rest is not listed");
                faults.push(Fault::new(RequestCode::More, "", detail));
                break;
            }
        }
        Faults(faults)
    }
}

/// Reads JSON, saying line and column where it is not.
fn parse(bytes: &[u8]) -> Result<Value, Fault> {
    serde_json::from_slice(bytes).map_err(|error| {
        let pointer = format!("line {} column {}", error.line(), error.column());
        Fault::new(RequestCode::Syntax, pointer, format!("not JSON: {error}"))
    })
}

/// Turns 3.0 into 3: JSON knows one kind of number, serde two.
fn make_whole_numbers_integers(value: &mut Value) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(make_whole_numbers_integers),
        Value::Object(fields) => fields.values_mut().for_each(make_whole_numbers_integers),
        Value::Number(number) if number.is_f64() => {
            let x = number.as_f64().unwrap_or(0.5);
            if x.fract() == 0.0 && x.abs() < 9e15 && (x != 0.0 || x.is_sign_positive()) {
                #[expect(clippy::cast_possible_truncation, reason = "whole and below 2^53")]
                let whole = x as i64;
                *value = whole.into();
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn faults(value: &Value) -> Vec<(String, String)> {
        let Faults(faults) = RequestSchema::of::<Garment>().faults(value);
        faults
            .into_iter()
            .map(|f| (f.code.to_string(), f.pointer))
            .collect()
    }

    fn seam(from: Value) -> Value {
        let run = json!({"panel": "front", "from": from, "to": 1});
        json!({"seams": [{"id": "s", "a": run, "b": {"panel": "back", "from": 0, "to": 1}}]})
    }

    fn one(code: &str, pointer: &str) -> Vec<(String, String)> {
        vec![(code.to_owned(), pointer.to_owned())]
    }

    #[test]
    fn a_right_garment_has_no_faults() {
        for from in [
            json!(0),
            json!({"edge": 3, "at": 0.25}),
            json!({"notch": 2}),
        ] {
            assert_eq!(faults(&seam(from)), []);
        }
    }

    #[test]
    fn all_faults_come_at_once() {
        let garment = json!({
            "seams": [{"id": "s", "a": {"panel": "front", "form": 0, "to": 1}, "b": 7, "match": "as_piked"}],
            "simulate": {"edge_lenght_m": 0.01, "tolerance": "small"},
            "wind": {"velocity_m_s": [0, 3]},
        });
        let mut found: Vec<String> = faults(&garment).into_iter().map(|(_, at)| at).collect();
        found.sort();
        let expected = [
            "/seams/0/a/form",
            "/seams/0/a/from",
            "/seams/0/b",
            "/seams/0/match",
            "/simulate/edge_lenght_m",
            "/simulate/tolerance",
            "/wind/velocity_m_s",
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn the_alternative_that_fits_best_is_the_one_reported() {
        let misspelt = seam(json!({"edge": 3, "att": 0.25}));
        let found = faults(&misspelt);
        assert!(
            found.contains(&("request/unknown_field".into(), "/seams/0/a/from/att".into())),
            "{found:?}"
        );
        assert!(
            found.contains(&("request/missing_field".into(), "/seams/0/a/from/at".into())),
            "{found:?}"
        );
        assert_eq!(found.len(), 2, "{found:?}");
        let extra = seam(json!({"notch": 2, "at": 0.5}));
        assert_eq!(
            faults(&extra),
            one("request/unknown_field", "/seams/0/a/from/at")
        );
    }

    #[test]
    fn no_alternative_of_that_kind_names_all_of_them() {
        let Faults(found) = RequestSchema::of::<Garment>().faults(&seam(json!("first")));
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].pointer, "/seams/0/a/from");
        assert_eq!(
            found[0].detail,
            "\"first\" is not of type integer or of type object"
        );
    }

    #[test]
    fn a_misspelt_field_or_word_is_answered_with_the_nearest() {
        let Faults(found) = RequestSchema::of::<Garment>()
            .faults(&json!({"seams": [], "simulate": {"metod": 1, "want": "drap"}}));
        let fixes: Vec<_> = found.iter().filter_map(|f| f.fix.as_deref()).collect();
        assert!(fixes.contains(&"did you mean \"method\"?"), "{found:?}");
        assert!(fixes.contains(&"did you mean \"drape\"?"), "{found:?}");
    }

    #[test]
    fn a_pattern_by_id_must_be_an_id() {
        let garment = json!({"seams": [], "pattern": "skirt"});
        assert_eq!(faults(&garment), one("request/format", "/pattern"));
    }

    #[test]
    fn numbers_out_of_range_have_a_pointer() {
        for bad in [json!(-1), json!(1e300), json!(0.5)] {
            let found = faults(&seam(bad));
            assert_eq!(found.len(), 1);
            assert_eq!(found[0].1, "/seams/0/a/from");
        }
    }

    #[test]
    fn syntax_is_reported_by_line_and_column() {
        let read = RequestSchema::of::<Garment>().read::<Garment>(b"{\n  \"seams\": [,]\n}");
        let Err(ReadError::Syntax(fault)) = read else {
            panic!("{read:?}");
        };
        assert_eq!(fault.pointer, "line 2 column 13");
    }

    #[test]
    fn what_the_schema_accepts_serde_accepts() {
        let shape = RequestSchema::of::<Garment>();
        let texts = [
            r#"{"seams": "suggest"}"#,
            r#"{"seams": [], "avatar": null, "wind": null, "start_from": null}"#,
            r#"{"seams": [], "wind": {"velocity_m_s": [0, -0.0, 3.0]}, "pins": [{"panel": "p", "corner": 2.0}]}"#,
            r#"{"seams": [{"id": "s", "a": [{"panel": "f", "from": {"edge": 1.0, "at": 1}, "to": 0}], "b": {"panel": "f", "from": 0, "to": 1, "direction": null}}]}"#,
        ];
        for text in texts {
            let read = shape.read::<Garment>(text.as_bytes());
            assert!(read.is_ok(), "{text}: {read:?}");
        }
    }

    #[test]
    fn a_saved_garment_is_read_back_bit_for_bit() {
        let mut garment = read_garment(br#"{"seams": [], "avatar": null}"#).expect("it is right");
        // Doubles of every magnitude: a linear congruential generator's bits (Knuth, MMIX), where
        // they are a number.
        let mut state = 1_u64;
        let bits = std::iter::repeat_with(|| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            state
        });
        let numbers = bits.map(f64::from_bits).filter(|x| x.is_finite());
        for (i, x) in numbers.take(10_000).enumerate() {
            let panel = crate::fit::PanelSpec {
                seam_allowance_m: x,
                ..Default::default()
            };
            garment.panels.insert(i.to_string(), panel);
        }
        let saved = serde_json::to_vec(&garment).expect("it is JSON");
        let read = read_garment(&saved).expect("it was right");
        for (id, panel) in &garment.panels {
            let (saved, read) = (panel.seam_allowance_m, read.panels[id].seam_allowance_m);
            assert_eq!(saved.to_bits(), read.to_bits(), "{saved:e}");
        }
        assert_eq!(read, garment);
    }

    #[test]
    fn a_hostile_list_gives_a_bounded_answer() {
        let garment = json!({"seams": vec![7; 10_000]});
        assert_eq!(faults(&garment).len(), MOST_LISTED + 1);
    }
}
