//! Requests read from JSON: measured, then all faults against their schema at once, before serde,
//! which stops at the first.

use super::garment::Garment;
use super::garment_bounds::garment_bounds;
use super::json_schema;
use super::shape_faults::{LeafValidators, shape_faults};
use crate::config::Limits;
use crate::fault::{Fault, Faults, RequestCode};
use crate::json::{JsonBounds, MOST_LISTED, measure};
use jsonschema::Validator;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::sync::LazyLock;
use utoipa::ToSchema;

/// The schema of a request type, ready to check with.
#[derive(Debug)]
pub(crate) struct RequestSchema {
    schema: Value,
    validator: Validator,
    leaves: LeafValidators,
}

/// The reason why bytes could not be read as a request.
#[derive(Debug, PartialEq)]
pub enum ReadError {
    /// They are not JSON.
    Syntax(Fault),
    /// They are JSON, but not as the schema and the limits say: every fault.
    Schema(Faults),
    /// They are JSON, but not as the schema and the limits say: the first faults, at which the
    /// search ended.
    Many(Faults),
}

impl From<ReadError> for Faults {
    fn from(error: ReadError) -> Self {
        match error {
            ReadError::Syntax(fault) => fault.into(),
            ReadError::Schema(faults) => faults,
            ReadError::Many(mut faults) => {
                let detail = "the search for faults ended here; there may be more";
                faults.0.push(Fault::new(RequestCode::More, "", detail));
                faults
            }
        }
    }
}

/// Reads a garment from its JSON; [`resolve`](super::resolve()) checks its meaning.
///
/// # Errors
/// Where it is not JSON or larger than the limits, or every field that is missing, unknown or of
/// the wrong kind.
pub fn read_garment(bytes: &[u8], limits: &Limits) -> Result<Garment, ReadError> {
    RequestSchema::measure(bytes, &garment_bounds(limits))?;
    garment_schema().read(bytes)
}

/// Returns the schema of garments.
pub(crate) fn garment_schema() -> &'static RequestSchema {
    // Made from the type alone, once.
    static SCHEMA: LazyLock<RequestSchema> = LazyLock::new(RequestSchema::of::<Garment>);
    &SCHEMA
}

impl RequestSchema {
    /// Returns the schema of `T`.
    pub(crate) fn of<T: ToSchema>() -> Self {
        let schema = json_schema::of::<T>();
        Self {
            validator: json_schema::validator(&schema),
            schema,
            leaves: LeafValidators::default(),
        }
    }

    /// Returns the memory that reading a request takes \[bytes\].
    ///
    /// # Errors
    /// Every list and text that is longer than its bound.
    pub(crate) fn measure(bytes: &[u8], bounds: &JsonBounds) -> Result<usize, ReadError> {
        let size = measure(bytes, bounds);
        if size.is_cut {
            return Err(ReadError::Many(Faults(size.faults)));
        }
        Faults(size.faults)
            .or(size.memory)
            .map_err(ReadError::Schema)
    }

    /// Reads a value whose size was measured before.
    ///
    /// # Errors
    /// Where it is not JSON, or every place where it differs from the schema.
    pub(crate) fn read<T: DeserializeOwned>(&self, bytes: &[u8]) -> Result<T, ReadError> {
        let mut value = parse(bytes).map_err(ReadError::Syntax)?;
        if !self.validator.is_valid(&value) {
            return Err(self.read_error(&value));
        }
        make_whole_numbers_integers(&mut value);
        serde_json::from_value(value).map_err(|error| {
            ReadError::Schema(Fault::new(RequestCode::Shape, "", error.to_string()).into())
        })
    }

    /// Returns a fault for every place where `value` differs from the schema, at most as many as
    /// are listed.
    fn read_error(&self, value: &Value) -> ReadError {
        let mut faults = shape_faults(&self.schema, &self.leaves, value);
        if faults.is_empty() {
            let detail = "the request does not have the shape that the schema requires";
            faults.push(Fault::new(RequestCode::Shape, "", detail));
        }
        let is_cut = faults.len() > MOST_LISTED;
        faults.truncate(MOST_LISTED);
        if is_cut {
            ReadError::Many(Faults(faults))
        } else {
            ReadError::Schema(Faults(faults))
        }
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

    fn found(value: &Value) -> Vec<Fault> {
        let schema = garment_schema();
        if schema.validator.is_valid(value) {
            return vec![];
        }
        let ReadError::Schema(Faults(faults)) = schema.read_error(value) else {
            panic!("there are few");
        };
        faults
    }

    fn faults(value: &Value) -> Vec<(String, String)> {
        found(value)
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
        let found = found(&seam(json!("first")));
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].pointer, "/seams/0/a/from");
        assert_eq!(
            found[0].detail,
            "\"first\" is not of type integer or of type object"
        );
    }

    #[test]
    fn a_misspelt_field_or_word_is_answered_with_the_nearest() {
        let found = found(&json!({"seams": [], "simulate": {"metod": 1, "want": "drap"}}));
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
        let read = garment_schema().read::<Garment>(b"{\n  \"seams\": [,]\n}");
        let Err(ReadError::Syntax(fault)) = read else {
            panic!("{read:?}");
        };
        assert_eq!(fault.pointer, "line 2 column 13");
    }

    #[test]
    fn what_the_schema_accepts_serde_accepts() {
        let shape = garment_schema();
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
        let text = br#"{"seams": [], "avatar": null}"#;
        let mut garment: Garment = garment_schema().read(text).expect("it is right");
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
        let read: Garment = garment_schema().read(&saved).expect("it was right");
        for (id, panel) in &garment.panels {
            let (saved, read) = (panel.seam_allowance_m, read.panels[id].seam_allowance_m);
            assert_eq!(saved.to_bits(), read.to_bits(), "{saved:e}");
        }
        assert_eq!(read, garment);
    }

    #[test]
    fn a_hostile_list_gives_a_bounded_answer() {
        let garment = json!({"seams": vec![7; 10_000]});
        let ReadError::Many(Faults(faults)) = garment_schema().read_error(&garment) else {
            panic!("there are more than are listed");
        };
        assert_eq!(faults.len(), MOST_LISTED);
        assert_eq!(faults[99].pointer, "/seams/99");
    }

    #[test]
    fn as_many_faults_as_are_listed_are_all() {
        let garment = json!({"seams": vec![7; MOST_LISTED]});
        assert_eq!(faults(&garment).len(), MOST_LISTED);
    }

    #[test]
    fn lists_are_counted_before_they_are_read() {
        let limits = Limits::default();
        let read = |garment: &Value| read_garment(garment.to_string().as_bytes(), &limits);
        let garment =
            json!({"seams": vec![json!({}); limits.seams + 1], "schema": "x".repeat(5000)});
        let Err(ReadError::Schema(Faults(faults))) = read(&garment) else {
            panic!("it is too large");
        };
        let found: Vec<_> = faults
            .iter()
            .map(|f| (f.code.as_str(), f.pointer.as_str()))
            .collect();
        let expected = [
            ("request/wrong_length", "/seams"),
            ("request/too_long", "/schema"),
        ];
        assert_eq!(found, expected);
    }
}
