//! Violations of a request's schema in the words of [`Fault`].

use super::unsupported::escape;
use crate::fault::{Fault, RequestCode, nearest};
use jsonschema::ValidationError;
use jsonschema::error::{TypeKind, ValidationErrorKind as Kind};
use serde_json::Value;
use std::fmt::{self, Write};

/// Returns the faults that one violation of `schema` comes to.
pub(super) fn faults(schema: &Value, error: &ValidationError<'_>) -> Vec<Fault> {
    let at = error.instance_path().as_str();
    match error.kind() {
        Kind::AdditionalProperties { unexpected } => {
            let known = properties(schema, error);
            let unexpected = unexpected.iter();
            unexpected
                .map(|name| unknown_field(at, name, &known))
                .collect()
        }
        Kind::Required { property } => vec![missing_field(at, property)],
        Kind::OneOfNotValid { context } | Kind::AnyOf { context } => {
            match best_alternative(at, context) {
                Some(branch) => branch.iter().flat_map(|e| faults(schema, e)).collect(),
                None => vec![no_alternative(at, error.instance(), context)],
            }
        }
        Kind::Enum { options } => vec![not_a_choice(at, error.instance(), options)],
        kind => {
            let detail = error.masked_with(excerpt(error.instance())).to_string();
            vec![Fault::new(code(kind), at, detail)]
        }
    }
}

/// Returns the names of the fields of the object that `error` is about.
fn properties<'a>(schema: &'a Value, error: &ValidationError<'_>) -> Vec<&'a str> {
    let path = error.schema_path().as_str();
    let object = path.rsplit_once('/').map_or("", |(object, _)| object);
    let fields = schema.pointer(&format!("{object}/properties"));
    fields
        .and_then(Value::as_object)
        .map(|fields| fields.keys().map(String::as_str).collect())
        .unwrap_or_default()
}

pub(super) fn unknown_field(at: &str, name: &str, known: &[&str]) -> Fault {
    let fault = Fault::new(
        RequestCode::UnknownField,
        format!("{at}/{}", escape(name)),
        format!("there is no field {name:?} here"),
    );
    match nearest(name, known.iter().copied()) {
        Some(near) => fault.fix(format!("did you mean {near:?}?")),
        None if known.is_empty() => fault,
        None => fault.fix(format!("the fields are {}", known.join(", "))),
    }
}

pub(super) fn missing_field(at: &str, property: &Value) -> Fault {
    let name = property.as_str().unwrap_or_default();
    Fault::new(
        RequestCode::MissingField,
        format!("{at}/{}", escape(name)),
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
    let fault = Fault::new(RequestCode::NotAChoice, at, detail);
    let word = value.as_str();
    match word.and_then(|word| nearest(word, names.iter().copied())) {
        Some(near) => fault.fix(format!("did you mean {near:?}?")),
        None => fault,
    }
}

/// Returns the alternative that the value was most likely meant as: of those that want its kind,
/// the one with the fewest faults.
fn best_alternative<'a>(
    at: &str,
    context: &'a [Vec<ValidationError<'static>>],
) -> Option<&'a Vec<ValidationError<'static>>> {
    context
        .iter()
        .filter(|branch| !branch.iter().any(|error| is_other_kind(at, error)))
        .min_by_key(|branch| branch.iter().map(fault_count).sum::<usize>())
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
        Kind::OneOfNotValid { context } => best_alternative(at, context).is_none(),
        _ => false,
    }
}

fn fault_count(error: &ValidationError<'_>) -> usize {
    match error.kind() {
        Kind::AdditionalProperties { unexpected } => unexpected.len(),
        Kind::OneOfNotValid { context } => {
            best_alternative(error.instance_path().as_str(), context)
                .map_or(1, |branch| branch.iter().map(fault_count).sum())
        }
        _ => 1,
    }
}

fn no_alternative(at: &str, value: &Value, context: &[Vec<ValidationError<'static>>]) -> Fault {
    let mut wanted: Vec<String> = vec![];
    collect_kinds(at, context, &mut wanted);
    wanted.dedup();
    let detail = format!("{} is not {}", excerpt(value), wanted.join(" or "));
    Fault::new(RequestCode::WrongType, at, detail)
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

fn kind_name(kind: &TypeKind) -> String {
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

fn code(kind: &Kind) -> RequestCode {
    match kind {
        Kind::Type { .. } => RequestCode::WrongType,
        Kind::Format { .. } | Kind::Pattern { .. } => RequestCode::Format,
        Kind::Minimum { .. }
        | Kind::Maximum { .. }
        | Kind::ExclusiveMinimum { .. }
        | Kind::ExclusiveMaximum { .. } => RequestCode::OutOfRange,
        Kind::MinItems { .. } | Kind::MaxItems { .. } => RequestCode::WrongLength,
        _ => RequestCode::Shape,
    }
}

/// Characters of a value in a sentence.
const EXCERPT: usize = 60;

/// Returns the value as JSON, short enough for a sentence; no more of it is written.
pub(super) fn excerpt(value: &Value) -> String {
    let mut start = Excerpt::default();
    if write!(start, "{value}").is_ok() {
        return start.text;
    }
    let start: String = start.text.chars().take(EXCERPT - 3).collect();
    format!("{start}...")
}

/// Text that takes the characters of an excerpt and refuses more.
#[derive(Default)]
struct Excerpt {
    text: String,
    count: usize,
}

impl fmt::Write for Excerpt {
    fn write_str(&mut self, part: &str) -> fmt::Result {
        for character in part.chars() {
            if self.count == EXCERPT {
                return Err(fmt::Error);
            }
            self.text.push(character);
            self.count += 1;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_long_value_is_cut() {
        assert_eq!(excerpt(&json!([1, "a"])), "[1,\"a\"]");
        let whole = json!("é".repeat(EXCERPT - 2));
        assert_eq!(excerpt(&whole), whole.to_string());
        let cut = excerpt(&json!(vec![7; 100_000]));
        assert!(cut.starts_with("[7,7,") && cut.ends_with("..."), "{cut}");
        assert_eq!(cut.chars().count(), EXCERPT);
    }
}
