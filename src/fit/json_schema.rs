//! JSON Schema 2020-12 of a request type, made from the same derive as the `OpenAPI` document.

use super::garment::Garment;
use jsonschema::Validator;
use serde_json::{Map, Value, json};
use utoipa::ToSchema;

/// Largest integer that every JSON reader keeps exactly.
const INTEGER_MAX: u64 = (1 << 53) - 1;

/// Returns the JSON Schema of the garment file, as `api/garment.schema.json` has it.
pub fn garment_schema_json() -> String {
    let json = serde_json::to_string_pretty(&of::<Garment>());
    json.expect("a schema always serializes") + "\n"
}

/// Returns the schema of `T`, complete in itself: schemas that it refers to are in `$defs`.
pub(super) fn of<T: ToSchema>() -> Value {
    let mut parts = vec![];
    T::schemas(&mut parts);
    let mut defs: Map<String, Value> = parts
        .into_iter()
        .map(|(name, part)| (name, to_value(&part)))
        .collect();
    defs.sort_keys();
    let mut root = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": T::name(),
    });
    let schema = to_value(&T::schema());
    let object = root.as_object_mut().expect("made as an object above");
    object.extend(schema.as_object().cloned().unwrap_or_default());
    if !defs.is_empty() {
        object.insert("$defs".to_owned(), Value::Object(defs));
    }
    tighten(&mut root, 0);
    root
}

/// Makes the validator of a schema.
pub(super) fn validator(schema: &Value) -> Validator {
    jsonschema::draft202012::options()
        .should_validate_formats(true)
        .build(schema)
        .expect("a generated schema is a schema; a test builds every one")
}

fn to_value(part: &impl serde::Serialize) -> Value {
    serde_json::to_value(part).expect("a schema of strings and numbers always serializes")
}

/// Makes the schema as strict as serde is: local references, closed objects, lengths of tuples,
/// ranges of integers.
///
/// `depth` counts the arrays round this schema. The derive drops the length of `[f64; N]`; in what
/// clients send, a row of numbers that is a field of its own is a vector of three, and one that is
/// an item of a list is a point of two; a list of any length says so by `minItems`.
fn tighten(schema: &mut Value, depth: usize) {
    let Some(object) = schema.as_object_mut() else {
        return;
    };
    if let Some(Value::String(reference)) = object.get_mut("$ref") {
        *reference = reference.replace("#/components/schemas/", "#/$defs/");
    }
    if object.get("additionalProperties") == Some(&json!(false)) {
        // Without it the validator does not say which field was not expected.
        object.entry("properties").or_insert(json!({}));
    }
    if object.contains_key("properties") {
        object
            .entry("additionalProperties")
            .or_insert(Value::Bool(false));
    }
    let is_row = object.get("type") == Some(&json!("array")) && object["items"]["type"] == "number";
    if is_row && !object.contains_key("minItems") {
        let length = if depth == 0 { 3 } else { 2 };
        object.insert("minItems".to_owned(), json!(length));
        object.insert("maxItems".to_owned(), json!(length));
    }
    if object.get("type") == Some(&json!("integer")) {
        let bounds = match object.get("format").and_then(Value::as_str) {
            Some("int32") => u64::from(u32::MAX >> 1),
            _ => INTEGER_MAX,
        };
        object.entry("maximum").or_insert(json!(bounds));
    }
    for (key, value) in object.iter_mut() {
        match (key.as_str(), value) {
            ("properties" | "$defs", Value::Object(parts)) => {
                parts.values_mut().for_each(|part| tighten(part, 0));
            }
            ("oneOf", Value::Array(parts)) => {
                parts.iter_mut().for_each(|part| tighten(part, depth));
            }
            ("items", part) => tighten(part, depth + 1),
            ("additionalProperties", part) => tighten(part, 0),
            _ => {}
        }
    }
}
