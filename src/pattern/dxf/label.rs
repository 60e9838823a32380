//! Texts of the form `Key: Value`, by which AAMA and ASTM files say names, sizes, quantities and units.

use super::entity::{Entity, Shape};
use super::quantity;
use crate::pattern::Quantity;

/// At most this many notes of a piece are looked through for a quantity.
const NOTES: usize = 200;

/// The labels of a piece or of a file, with the line of each, and its texts that are none.
#[derive(Clone, Debug, Default)]
pub(super) struct Labels(Vec<(String, String, usize)>, Vec<String>);

impl Labels {
    /// The labels among these entities.
    pub(super) fn of<'a>(entities: impl Iterator<Item = &'a Entity>) -> Self {
        let mut labels = Self::default();
        for entity in entities {
            if let Shape::Text(_, text) = &entity.shape {
                match split(text) {
                    Some((key, value)) => labels.0.push((key, value, entity.line)),
                    None if labels.1.len() < NOTES => labels.1.push(text.trim().to_owned()),
                    None => {}
                }
            }
        }
        labels
    }

    /// The first value of `key` (lower case) that is not empty.
    pub(super) fn get(&self, key: &str) -> Option<&str> {
        self.with_line(key).map(|(value, _)| value)
    }

    /// The same, with its line.
    pub(super) fn with_line(&self, key: &str) -> Option<(&str, usize)> {
        let found = self.0.iter().find(|(k, v, _)| k == key && !v.is_empty());
        found.map(|(_, value, line)| (value.as_str(), *line))
    }

    /// Whether a key begins with `start` (lower case).
    pub(super) fn any_key(&self, start: &str) -> bool {
        self.0.iter().any(|(key, ..)| key.starts_with(start))
    }

    /// How many are cut, by a label (`Quantity: 2`, `Quantity: 1,1`) or a note (`Cut 2`, `x2`, `1 pair`, `L1 R1`).
    pub(super) fn quantity(&self) -> Option<Quantity> {
        const KEYS: [&str; 5] = ["quantity", "qty", "cut", "pieces", "number of pieces"];
        let labelled = KEYS
            .iter()
            .find_map(|key| quantity::of_value(self.get(key)?));
        labelled.or_else(|| self.1.iter().find_map(|note| quantity::of_note(note)))
    }
}

/// Whether a text is a label, of a piece or of the whole file.
pub(super) fn is_label(text: &str) -> bool {
    split(text).is_some()
}

/// Whether a text may be the name of a piece: neither a label nor a quantity.
pub(super) fn is_name(text: &str) -> bool {
    !text.trim().is_empty() && !is_label(text) && quantity::of_note(text).is_none()
}

/// `Key: Value` as (lower-case key, value); `None` for other text.
fn split(text: &str) -> Option<(String, String)> {
    let (key, value) = text.split_once(':')?;
    let key = key
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
        .to_lowercase();
    (!key.is_empty()).then(|| (key, value.trim().to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(texts: &[&str]) -> Labels {
        let entities: Vec<Entity> = texts
            .iter()
            .map(|text| Entity {
                layer: "1".into(),
                line: 1,
                shape: Shape::Text([0.0; 2], (*text).to_owned()),
            })
            .collect();
        Labels::of(entities.iter())
    }

    #[test]
    fn keys_are_read_in_any_case() {
        let found = labels(&["PIECE  NAME: Front: left", "quantity: 1,1", "NM"]);
        assert_eq!(found.get("piece name"), Some("Front: left"));
        assert_eq!(found.quantity(), Some(Quantity { left: 1, right: 1 }));
        assert_eq!(
            labels(&["Quantity: 2"]).quantity(),
            Some(Quantity { left: 2, right: 0 })
        );
        assert_eq!(labels(&["Quantity: many"]).quantity(), None);
    }
}
