//! The shape of a JSON request: all faults against its schema at once, before serde, which stops at the first.

use super::Garment;
use super::json_schema;
use crate::fault::{Fault, Faults, nearest};
use jsonschema::error::ValidationErrorKind as Kind;
use jsonschema::{ValidationError, Validator};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::sync::LazyLock;
use utoipa::ToSchema;

/// So many faults of one request are listed; a file of another kind has one at every line.
const LISTED: usize = 100;

/// The schema of a request type, ready to check with.
#[derive(Debug)]
pub(crate) struct Shape {
    schema: Value,
    validator: Validator,
}

/// Why bytes are not the value that was wanted.
#[derive(Debug, PartialEq)]
pub enum Misshapen {
    /// They are not JSON.
    Syntax(Fault),
    /// They are JSON of another shape.
    Shape(Faults),
}

impl From<Misshapen> for Faults {
    fn from(misshapen: Misshapen) -> Self {
        match misshapen {
            Misshapen::Syntax(fault) => fault.into(),
            Misshapen::Shape(faults) => faults,
        }
    }
}

/// Reads a garment from its JSON; what it means is not checked yet: [`super::prepare`] does that.
///
/// # Errors
/// Where it is not JSON, or every field that is missing, unknown or of the wrong kind.
pub fn read_garment(bytes: &[u8]) -> Result<Garment, Misshapen> {
    // Made from the type alone, once.
    static SHAPE: LazyLock<Shape> = LazyLock::new(Shape::of::<Garment>);
    SHAPE.read(bytes)
}

impl Shape {
    /// The shape of `T`.
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
    /// Where it is not JSON, or every place where it has not this shape.
    pub(crate) fn read<T: DeserializeOwned>(&self, bytes: &[u8]) -> Result<T, Misshapen> {
        let mut value = parse(bytes).map_err(Misshapen::Syntax)?;
        let faults = self.faults(&value);
        faults.or(()).map_err(Misshapen::Shape)?;
        integral(&mut value);
        serde_json::from_value(value).map_err(|error| {
            Misshapen::Shape(Fault::new("request/shape", "", error.to_string()).into())
        })
    }

    /// Every place where `value` has not this shape.
    fn faults(&self, value: &Value) -> Faults {
        let mut faults = vec![];
        for error in self.validator.iter_errors(value) {
            self.tell(&error, &mut faults);
            if faults.len() > LISTED {
                faults.truncate(LISTED);
                let detail = format!("there are more than {LISTED} faults; the rest is not listed");
                faults.push(Fault::new("request/more", "", detail));
                break;
            }
        }
        Faults(faults)
    }

    /// Says one violation in the words of [`Fault`].
    fn tell(&self, error: &ValidationError<'_>, faults: &mut Vec<Fault>) {
        let at = error.instance_path().as_str();
        match error.kind() {
            Kind::AdditionalProperties { unexpected } => {
                let known = self.properties(error);
                faults.extend(unexpected.iter().map(|name| unknown(at, name, &known)));
            }
            Kind::Required { property } => faults.push(missing(at, property)),
            Kind::OneOfNotValid { context } | Kind::AnyOf { context } => {
                match fitting_best(at, context) {
                    Some(branch) => branch.iter().for_each(|error| self.tell(error, faults)),
                    None => faults.push(none_fits(at, error.instance(), context)),
                }
            }
            Kind::Enum { options } => faults.push(not_a_choice(at, error.instance(), options)),
            kind => faults.push(Fault::new(
                code(kind),
                at,
                error.masked_with(excerpt(error.instance())).to_string(),
            )),
        }
    }

    /// Names of the fields of the object that `error` is about.
    fn properties(&self, error: &ValidationError<'_>) -> Vec<&str> {
        let path = error.schema_path().as_str();
        let object = path.rsplit_once('/').map_or("", |(object, _)| object);
        let fields = self.schema.pointer(&format!("{object}/properties"));
        fields
            .and_then(Value::as_object)
            .map(|fields| fields.keys().map(String::as_str).collect())
            .unwrap_or_default()
    }
}

/// Reads JSON, saying line and column where it is not.
fn parse(bytes: &[u8]) -> Result<Value, Fault> {
    serde_json::from_slice(bytes).map_err(|error| {
        let pointer = format!("line {} column {}", error.line(), error.column());
        Fault::new("request/syntax", pointer, format!("not JSON: {error}"))
    })
}

/// Turns 3.0 into 3: JSON knows one kind of number, serde two.
fn integral(value: &mut Value) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(integral),
        Value::Object(fields) => fields.values_mut().for_each(integral),
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

fn unknown(at: &str, name: &str, known: &[&str]) -> Fault {
    let fault = Fault::new(
        "request/unknown_field",
        format!("{at}/{}", escaped(name)),
        format!("there is no field {name:?} here"),
    );
    match nearest(name, known.iter().copied()) {
        Some(near) => fault.fix(format!("did you mean {near:?}?")),
        None if known.is_empty() => fault,
        None => fault.fix(format!("the fields are {}", known.join(", "))),
    }
}

fn missing(at: &str, property: &Value) -> Fault {
    let name = property.as_str().unwrap_or_default();
    Fault::new(
        "request/missing_field",
        format!("{at}/{}", escaped(name)),
        format!("the field {name:?} is missing"),
    )
}

fn not_a_choice(at: &str, value: &Value, options: &Value) -> Fault {
    let names: Vec<&str> = options
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_str)
        .collect();
    let choices = names.join(", ");
    let detail = format!("{} is not one of: {choices}", excerpt(value));
    let fault = Fault::new("request/not_a_choice", at, detail);
    let word = value.as_str();
    match word.and_then(|word| nearest(word, names.iter().copied())) {
        Some(near) => fault.fix(format!("did you mean {near:?}?")),
        None => fault,
    }
}

/// The alternative that `value` was most likely meant as: of those that want this kind of value, the one with the fewest faults.
fn fitting_best<'a>(
    at: &str,
    context: &'a [Vec<ValidationError<'static>>],
) -> Option<&'a Vec<ValidationError<'static>>> {
    context
        .iter()
        .filter(|branch| !branch.iter().any(|error| is_other_kind(at, error)))
        .min_by_key(|branch| branch.iter().map(weight).sum::<usize>())
}

fn is_other_kind(at: &str, error: &ValidationError<'_>) -> bool {
    if error.instance_path().as_str() != at {
        return false;
    }
    match error.kind() {
        Kind::Type { .. } => true,
        Kind::Enum { options } => {
            let same = |option: &Value| kind_of(option) == kind_of(error.instance());
            !options.as_array().is_some_and(|all| all.iter().any(same))
        }
        Kind::OneOfNotValid { context } => fitting_best(at, context).is_none(),
        _ => false,
    }
}

fn weight(error: &ValidationError<'_>) -> usize {
    match error.kind() {
        Kind::AdditionalProperties { unexpected } => unexpected.len(),
        Kind::OneOfNotValid { context } => fitting_best(error.instance_path().as_str(), context)
            .map_or(1, |branch| branch.iter().map(weight).sum()),
        _ => 1,
    }
}

fn none_fits(at: &str, value: &Value, context: &[Vec<ValidationError<'static>>]) -> Fault {
    let mut wanted: Vec<String> = vec![];
    collect_kinds(at, context, &mut wanted);
    wanted.dedup();
    let detail = format!("{} is not {}", excerpt(value), wanted.join(" or "));
    Fault::new("request/wrong_type", at, detail)
}

fn collect_kinds(at: &str, context: &[Vec<ValidationError<'static>>], wanted: &mut Vec<String>) {
    for error in context.iter().flatten() {
        if error.instance_path().as_str() != at {
            continue;
        }
        match error.kind() {
            Kind::Type { kind } => wanted.push(format!("of type {}", kind_name(kind))),
            Kind::Enum { options } => wanted.push(format!("one of {options}")),
            Kind::OneOfNotValid { context } => collect_kinds(at, context, wanted),
            _ => {}
        }
    }
}

fn kind_name(kind: &jsonschema::error::TypeKind) -> String {
    use jsonschema::error::TypeKind;
    match kind {
        TypeKind::Single(one) => one.to_string(),
        TypeKind::Multiple(many) => many
            .iter()
            .map(|one| one.to_string())
            .collect::<Vec<_>>()
            .join(" or "),
    }
}

fn kind_of(value: &Value) -> std::mem::Discriminant<Value> {
    std::mem::discriminant(value)
}

fn code(kind: &Kind) -> &'static str {
    match kind {
        Kind::Type { .. } => "request/wrong_type",
        Kind::Format { .. } | Kind::Pattern { .. } => "request/format",
        Kind::Minimum { .. }
        | Kind::Maximum { .. }
        | Kind::ExclusiveMinimum { .. }
        | Kind::ExclusiveMaximum { .. } => "request/out_of_range",
        Kind::MinItems { .. } | Kind::MaxItems { .. } => "request/wrong_length",
        _ => "request/shape",
    }
}

/// The value, short enough for a sentence.
fn excerpt(value: &Value) -> String {
    let whole = value.to_string();
    if whole.chars().count() <= 60 {
        return whole;
    }
    let start: String = whole.chars().take(57).collect();
    format!("{start}...")
}

/// A name as a token of a JSON Pointer (RFC 6901).
fn escaped(name: &str) -> String {
    name.replace('~', "~0").replace('/', "~1")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn faults(value: &Value) -> Vec<(String, String)> {
        let Faults(faults) = Shape::of::<Garment>().faults(value);
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
        let Faults(found) = Shape::of::<Garment>().faults(&seam(json!("first")));
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].pointer, "/seams/0/a/from");
        assert_eq!(
            found[0].detail,
            "\"first\" is not of type integer or of type object"
        );
    }

    #[test]
    fn a_misspelt_field_or_word_is_answered_with_the_nearest() {
        let Faults(found) = Shape::of::<Garment>()
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
        let read = Shape::of::<Garment>().read::<Garment>(b"{\n  \"seams\": [,]\n}");
        let Err(Misshapen::Syntax(fault)) = read else {
            panic!("{read:?}");
        };
        assert_eq!(fault.pointer, "line 2 column 13");
    }

    #[test]
    fn what_the_schema_accepts_serde_accepts() {
        let shape = Shape::of::<Garment>();
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
        // Doubles of every magnitude: a linear congruential generator's bits (Knuth, MMIX), where they are a number.
        let mut state = 1_u64;
        let bits = std::iter::repeat_with(|| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            state
        });
        let numbers = bits.map(f64::from_bits).filter(|x| x.is_finite());
        for (i, x) in numbers.take(10_000).enumerate() {
            let panel = crate::fit::PanelAsked {
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
        assert_eq!(faults(&garment).len(), LISTED + 1);
    }
}
