//! The faults of a request against its schema, found one by one, so that the search ends when
//! enough are found.
//!
//! The validator of the whole would make every fault of a list of alternatives before it tells the
//! first: a million of them for one body. Lists, objects and alternatives are walked through here;
//! what is left, single values, is the validator's.

use super::schema_fault::{self, excerpt, missing_field, unknown_field};
use super::unsupported::escape;
use crate::fault::{Fault, RequestCode};
use crate::json::MOST_LISTED;
use jsonschema::Validator;
use serde_json::{Map, Value};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Keywords of a schema that the walk keeps, or that say nothing on the value.
const WALKED: [&str; 14] = [
    "$schema",
    "$defs",
    "title",
    "description",
    "default",
    "examples",
    "type",
    "properties",
    "required",
    "additionalProperties",
    "propertyNames",
    "items",
    "minItems",
    "maxItems",
];

/// Validators of single values, made when they are first needed.
#[derive(Debug, Default)]
pub(super) struct LeafValidators {
    by_schema: Mutex<HashMap<String, Arc<Validator>>>,
}

impl LeafValidators {
    /// Returns the validator of a part of the schema `root`.
    fn of(&self, part: &Value, root: &Value) -> Arc<Validator> {
        let text = part.to_string();
        let lock = || {
            self.by_schema
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
        };
        if let Some(known) = lock().get(&text) {
            return Arc::clone(known);
        }
        let mut whole = part.clone();
        if let (Some(object), Some(defs)) = (whole.as_object_mut(), root.get("$defs"))
            && text.contains("\"$ref\"")
        {
            object.insert("$defs".to_owned(), defs.clone());
        }
        let validator = Arc::new(super::json_schema::validator(&whole));
        lock().insert(text, Arc::clone(&validator));
        validator
    }
}

/// Returns the faults of `value` against `schema`: all of them, or one more than are listed.
pub(super) fn shape_faults(schema: &Value, leaves: &LeafValidators, value: &Value) -> Vec<Fault> {
    let mut walk = Walk {
        root: schema,
        leaves,
        at: String::new(),
        faults: Vec::new(),
    };
    walk.visit(schema, value);
    walk.faults
}

struct Walk<'a> {
    root: &'a Value,
    leaves: &'a LeafValidators,
    /// JSON Pointer to the value that is visited.
    at: String,
    faults: Vec<Fault>,
}

impl<'a> Walk<'a> {
    fn is_full(&self) -> bool {
        self.faults.len() > MOST_LISTED
    }

    fn visit(&mut self, schema: &'a Value, value: &Value) {
        let schema = self.resolved(schema);
        if schema.get("oneOf").is_some() {
            match self.alternative(schema, value) {
                Some(schema) => self.visit(schema, value),
                None => self.visit_leaf(schema, value),
            }
            return;
        }
        match (value, schema.as_object()) {
            (Value::Object(fields), Some(keywords)) if is_walked(keywords, "object") => {
                self.visit_object(keywords, fields);
            }
            (Value::Array(items), Some(keywords)) if is_walked(keywords, "array") => {
                self.visit_list(keywords, value, items);
            }
            _ => self.visit_leaf(schema, value),
        }
    }

    fn visit_below(&mut self, step: &str, schema: &'a Value, value: &Value) {
        let length = self.at.len();
        self.at.push('/');
        self.at.push_str(step);
        self.visit(schema, value);
        self.at.truncate(length);
    }

    fn visit_object(&mut self, schema: &'a Map<String, Value>, fields: &Map<String, Value>) {
        let known = schema.get("properties").and_then(Value::as_object);
        let required = schema.get("required").and_then(Value::as_array);
        for name in required.into_iter().flatten() {
            if !name.as_str().is_some_and(|name| fields.contains_key(name)) && !self.is_full() {
                self.faults.push(missing_field(&self.at, name));
            }
        }
        for (name, value) in fields {
            if self.is_full() {
                return;
            }
            let own = known.and_then(|known| known.get(name));
            match own.or_else(|| schema.get("additionalProperties")) {
                Some(Value::Bool(false)) => {
                    let known = known.into_iter().flatten();
                    let known: Vec<&str> = known.map(|(name, _)| name.as_str()).collect();
                    self.faults.push(unknown_field(&self.at, name, &known));
                }
                Some(part) => self.visit_below(&escape(name), part, value),
                None => {}
            }
        }
    }

    fn visit_list(&mut self, schema: &'a Map<String, Value>, list: &Value, items: &[Value]) {
        let bound = |name: &str| schema.get(name).and_then(Value::as_u64);
        let count = items.len() as u64;
        let wrong = match (bound("minItems"), bound("maxItems")) {
            (Some(least), _) if count < least => format!("less than {least}"),
            (_, Some(most)) if count > most => format!("more than {most}"),
            _ => {
                let Some(schema) = schema.get("items") else {
                    return;
                };
                for (i, item) in items.iter().enumerate() {
                    if self.is_full() {
                        return;
                    }
                    self.visit_below(&i.to_string(), schema, item);
                }
                return;
            }
        };
        let detail = format!("{} has {wrong} items", excerpt(list));
        let fault = Fault::new(RequestCode::WrongLength, self.at.as_str(), detail);
        self.faults.push(fault);
    }

    fn visit_leaf(&mut self, schema: &Value, value: &Value) {
        let validator = self.leaves.of(schema, self.root);
        if validator.is_valid(value) {
            return;
        }
        for error in validator.iter_errors(value) {
            for mut fault in schema_fault::faults(schema, &error) {
                fault.pointer.insert_str(0, &self.at);
                self.faults.push(fault);
            }
            if self.is_full() {
                return;
            }
        }
    }

    /// Follows references.
    fn resolved(&self, mut schema: &'a Value) -> &'a Value {
        while let Some(reference) = schema.get("$ref").and_then(Value::as_str) {
            let target = self.root.pointer(reference.trim_start_matches('#'));
            schema = target.expect("a generated schema refers to its own parts");
        }
        schema
    }

    /// Returns the alternative that the value was most likely meant as: of those of its kind, the
    /// one with the fewest unknown and missing fields. None where its kind does not tell.
    fn alternative(&self, schema: &'a Value, value: &Value) -> Option<&'a Value> {
        let mut branches = Vec::new();
        self.collect_branches(schema, &mut branches);
        branches.retain(|branch| is_of_type(branch, value));
        match (branches.as_slice(), value) {
            ([one], _) => Some(one),
            (_, Value::Object(fields)) => {
                let wrong = |branch: &&&Value| wrong_fields(branch, fields);
                branches.iter().min_by_key(wrong).copied()
            }
            _ => None,
        }
    }

    fn collect_branches(&self, schema: &'a Value, branches: &mut Vec<&'a Value>) {
        let schema = self.resolved(schema);
        match schema.get("oneOf").and_then(Value::as_array) {
            Some(parts) => {
                for part in parts {
                    self.collect_branches(part, branches);
                }
            }
            None => branches.push(schema),
        }
    }
}

/// Returns true if the walk keeps all keywords of a schema for values of `kind`.
fn is_walked(keywords: &Map<String, Value>, kind: &str) -> bool {
    let is_kind = keywords.get("type").is_some_and(|of| names(of, kind));
    is_kind && keywords.keys().all(|key| WALKED.contains(&key.as_str()))
}

/// Returns true if the value of the keyword `type` names `kind`.
fn names(of: &Value, kind: &str) -> bool {
    match of {
        Value::Array(kinds) => kinds.iter().any(|one| one == kind),
        one => one == kind,
    }
}

/// Returns true if a value is of the type that a schema wants.
fn is_of_type(schema: &Value, value: &Value) -> bool {
    let Some(of) = schema.get("type") else {
        return true;
    };
    match value {
        Value::Null => names(of, "null"),
        Value::Bool(_) => names(of, "boolean"),
        Value::Number(_) => names(of, "number") || names(of, "integer"),
        Value::String(_) => names(of, "string"),
        Value::Array(_) => names(of, "array"),
        Value::Object(_) => names(of, "object"),
    }
}

/// Counts the fields that a schema does not know, and those that it misses.
fn wrong_fields(schema: &Value, fields: &Map<String, Value>) -> usize {
    let known = schema.get("properties").and_then(Value::as_object);
    let is_known = |name: &String| known.is_some_and(|known| known.contains_key(name));
    let required = schema.get("required").and_then(Value::as_array);
    let names = required.into_iter().flatten().filter_map(Value::as_str);
    fields.keys().filter(|name| !is_known(name)).count()
        + names.filter(|name| !fields.contains_key(*name)).count()
}
