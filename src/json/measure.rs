//! Walks through JSON text, counts what it holds and keeps none of it.

use super::bounds::{BoundedPlace, JsonBounds};
use crate::fault::{Fault, RequestCode, pointer_token};
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::Value;
use std::fmt;

/// The most faults of one request that are listed; a file of another kind has one at every line.
pub(crate) const MOST_LISTED: usize = 100;

/// Memory of one value \[bytes\].
const VALUE: usize = size_of::<Value>();
/// Memory of one field of an object beside its name: value, name, hash and place in the index
/// \[bytes\].
const FIELD: usize = VALUE + 64;
/// Room that the first item of a list or field of an object makes; it doubles from there.
const LEAST_ROOM: usize = 4;
/// Least memory of a text, with what the allocator adds \[bytes\].
const TEXT: usize = 32;

/// The size of JSON, and where it is above its bounds.
#[derive(Clone, Debug, Default)]
pub(crate) struct JsonSize {
    /// Memory that it takes once it is read \[bytes\].
    pub(crate) memory: usize,
    /// A fault for every list and text that is too long; the first hundred.
    pub(crate) faults: Vec<Fault>,
    /// True if measuring stopped before the end: the faults are not all.
    pub(crate) is_cut: bool,
}

/// Measures JSON. What is no JSON is measured up to where it breaks off, as far as it would be
/// read.
pub(crate) fn measure(bytes: &[u8], bounds: &JsonBounds) -> JsonSize {
    let mut walk = Walk {
        bounds,
        path: Vec::new(),
        size: JsonSize::default(),
    };
    let mut reader = serde_json::Deserializer::from_slice(bytes);
    let place = Some(&bounds.root);
    // An error is one of the text, which its reader tells, or has been noted in `size`.
    let _ = At {
        walk: &mut walk,
        place,
    }
    .deserialize(&mut reader);
    walk.size
}

/// A step of the path to a value.
enum Step {
    Item(usize),
    Field(String),
}

/// A walk through JSON.
struct Walk<'a> {
    bounds: &'a JsonBounds,
    path: Vec<Step>,
    size: JsonSize,
}

impl Walk<'_> {
    /// Counts memory; an error once it is too much.
    fn take<E: Error>(&mut self, bytes: usize) -> Result<(), E> {
        self.size.memory += bytes;
        let most = self.bounds.elsewhere.memory;
        if self.size.memory <= most {
            return Ok(());
        }
        self.size.is_cut = true;
        let detail = format!("reading the request takes more than {most} bytes of memory");
        let fault = Fault::new(RequestCode::TooLarge, "", detail);
        self.size.faults.push(fault.fix("send less at once"));
        Err(E::custom("too large"))
    }

    /// Counts a text or a name.
    fn take_text<E: Error>(&mut self, text: &str) -> Result<(), E> {
        let most = self.bounds.elsewhere.chars;
        if text.len() > most {
            let count = text.chars().count();
            if count > most {
                let fix = format!("give {most} at most");
                let detail = format!("a text here has {count} characters");
                self.note(RequestCode::TooLong, detail, fix)?;
            }
        }
        self.take(text.len() + TEXT)
    }

    /// Notes a fault at the place of the walk; an error once there are as many as are listed.
    fn note<E: Error>(&mut self, code: RequestCode, detail: String, fix: String) -> Result<(), E> {
        let pointer = self.pointer();
        let fault = Fault::new(code, pointer, detail);
        self.size.faults.push(fault.fix(fix));
        if self.size.faults.len() < MOST_LISTED {
            return Ok(());
        }
        self.size.is_cut = true;
        Err(E::custom("too many faults"))
    }

    fn pointer(&self) -> String {
        let steps = self.path.iter().map(|step| match step {
            Step::Item(index) => format!("/{index}"),
            Step::Field(name) => format!("/{}", pointer_token(name)),
        });
        steps.collect()
    }

    /// Returns the most items of a list or fields of an object at a place.
    fn most(&self, place: Option<&BoundedPlace>) -> usize {
        let own = place.and_then(BoundedPlace::items);
        own.unwrap_or(self.bounds.elsewhere.items)
    }

    /// Counts the room of a list or an object of `count` entries, each of which was counted when it
    /// came, or notes that they are too many.
    fn end<E: Error>(&mut self, count: usize, most: usize, (what, size): Kind) -> Result<(), E> {
        if count <= most {
            let room = count.next_power_of_two().max(LEAST_ROOM);
            return self.take(if count == 0 { 0 } else { (room - count) * size });
        }
        let detail = format!("there are {count} {what} here");
        let fix = format!("give {most} at most");
        self.note(RequestCode::WrongLength, detail, fix)
    }

    /// Notes that the entries of a list or an object that breaks off are too many, if they are:
    /// what is before the break would be read. Returns the error of the break.
    fn broken_off<E: Error>(
        &mut self,
        error: E,
        (count, most): (usize, usize),
        kind: Kind,
    ) -> Result<(), E> {
        if count > most {
            self.end::<E>(count, most, kind)?;
        }
        Err(error)
    }
}

/// The word for the entries of a list or an object, and the memory of each \[bytes\].
type Kind = (&'static str, usize);
const ITEMS: Kind = ("items", VALUE);
const FIELDS: Kind = ("fields", FIELD);

/// A value to be walked through, and the bounds of its place.
struct At<'w, 'a> {
    walk: &'w mut Walk<'a>,
    place: Option<&'a BoundedPlace>,
}

impl<'de> DeserializeSeed<'de> for At<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for At<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<(), A::Error> {
        let Self { walk, place } = self;
        let most = walk.most(place);
        let below = place.and_then(BoundedPlace::item);
        let mut count = 0;
        while count < most {
            walk.path.push(Step::Item(count));
            let item = At { walk, place: below };
            if items.next_element_seed(item)?.is_none() {
                walk.path.pop();
                return walk.end(count, most, ITEMS);
            }
            walk.path.pop();
            walk.take(VALUE)?;
            count += 1;
        }
        loop {
            match items.next_element::<IgnoredAny>() {
                Ok(Some(_)) => count += 1,
                Ok(None) => return walk.end(count, most, ITEMS),
                Err(error) => return walk.broken_off(error, (count, most), ITEMS),
            }
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<(), A::Error> {
        let Self { walk, place } = self;
        let most = walk.most(place);
        let mut count = 0;
        loop {
            let name = match fields.next_key_seed(Name { walk }) {
                Ok(Some(name)) => name,
                Ok(None) => return walk.end(count, most, FIELDS),
                Err(error) => return walk.broken_off(error, (count, most), FIELDS),
            };
            count += 1;
            if count > most {
                if let Err(error) = fields.next_value::<IgnoredAny>() {
                    return walk.broken_off(error, (count, most), FIELDS);
                }
                continue;
            }
            let below = place.and_then(|place| place.field(&name));
            walk.take(FIELD)?;
            walk.path.push(Step::Field(name));
            fields.next_value_seed(At { walk, place: below })?;
            walk.path.pop();
        }
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<(), E> {
        self.walk.take_text(text)
    }

    fn visit_bool<E: Error>(self, _: bool) -> Result<(), E> {
        Ok(())
    }

    fn visit_u64<E: Error>(self, _: u64) -> Result<(), E> {
        Ok(())
    }

    fn visit_i64<E: Error>(self, _: i64) -> Result<(), E> {
        Ok(())
    }

    fn visit_f64<E: Error>(self, _: f64) -> Result<(), E> {
        Ok(())
    }

    fn visit_unit<E: Error>(self) -> Result<(), E> {
        Ok(())
    }
}

/// The name of a field, counted; one that is too long is cut, since it is a fault anyway.
struct Name<'w, 'a> {
    walk: &'w mut Walk<'a>,
}

impl<'de> DeserializeSeed<'de> for Name<'_, '_> {
    type Value = String;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<String, D::Error> {
        deserializer.deserialize_str(self)
    }
}

impl<'de> Visitor<'de> for Name<'_, '_> {
    type Value = String;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a name")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<String, E> {
        let most = self.walk.bounds.elsewhere.chars;
        self.walk.take_text(name)?;
        Ok(name.chars().take(most).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::super::AnyPlace;
    use super::*;

    fn size(text: &str) -> JsonSize {
        let elsewhere = AnyPlace {
            items: 3,
            chars: 5,
            memory: 10_000,
        };
        let lists = [("/many", 5), ("/rows/*/x", 1)];
        measure(text.as_bytes(), &JsonBounds::new(elsewhere, lists))
    }

    fn faults(text: &str) -> Vec<(String, String)> {
        let faults = size(text).faults.into_iter();
        faults.map(|fault| (fault.pointer, fault.detail)).collect()
    }

    #[test]
    fn every_list_object_and_text_has_its_limit() {
        assert_eq!(faults(r#"{"many": [1,2,3,4,5], "few": [1,2,3]}"#), []);
        let found = faults(
            r#"{"many": [1,2,3,4,5,6], "few": [[],{},"é",0], "rows": [{"x": [1,2]}, "abcdef"]}"#,
        );
        let expected = [
            ("/many", "there are 6 items here"),
            ("/few", "there are 4 items here"),
            ("/rows/0/x", "there are 2 items here"),
            ("/rows/1", "a text here has 6 characters"),
        ];
        let expected = expected.map(|(at, detail)| (at.to_owned(), detail.to_owned()));
        assert_eq!(found, expected);
        let found = faults(r#"{"a":1,"b":1,"c":1,"d":1}"#);
        assert_eq!(
            found,
            [(String::new(), "there are 4 fields here".to_owned())]
        );
        assert_eq!(faults(r#"{"abcdef": 0}"#).len(), 1);
        assert_eq!(faults(r#""\u00e9\u00e9\u00e9\u00e9\u00e9""#), []);
    }

    #[test]
    fn memory_is_counted_and_ends_the_walk() {
        let small = size("[[0],[0],[0]]");
        // Three lists, with room for four each, in a list with room for four.
        assert_eq!(small.memory, 16 * VALUE);
        let deep = "[".repeat(120) + &"]".repeat(120);
        let deep = size(&deep);
        assert!(deep.is_cut && deep.memory < 10_000 + 4 * VALUE);
        assert_eq!(deep.faults.len(), 1);
        assert_eq!(deep.faults[0].code, RequestCode::TooLarge);
    }

    #[test]
    fn the_walk_ends_at_the_hundredth_fault() {
        let elsewhere = AnyPlace {
            items: 1_000,
            chars: 1,
            memory: 1 << 20,
        };
        let text = format!("[{}\"ab\"]", "\"ab\",".repeat(500));
        let size = measure(text.as_bytes(), &JsonBounds::new(elsewhere, []));
        assert!(size.is_cut);
        assert_eq!(size.faults.len(), MOST_LISTED);
    }

    #[test]
    fn what_is_no_json_is_left_to_its_reader() {
        for text in ["", "[1,", "{\"a\"", "nul", "[1] 2"] {
            assert_eq!(faults(text), [], "{text}");
        }
    }

    #[test]
    fn what_breaks_off_after_too_many_items_is_refused_for_these() {
        for text in ["[1,2,3,4,5", "[1,2,3,4,}", r#"{"a":1,"b":1,"c":1,"d":1,"e"#] {
            assert_eq!(faults(text).len(), 1, "{text}");
        }
    }
}
