//! Texts of the form `Key: Value`, by which AAMA and ASTM files give names, sizes,
//! quantities and units.

use super::quantity;
use crate::pattern::Quantity;
use crate::pattern::dxf::entity::geometry::{DxfEntity, EntityShape};

/// At most this many notes of a piece are looked through for a quantity.
const NOTES: usize = 200;

/// A text `Key: Value`.
#[derive(Clone, Debug)]
struct TextLabel {
    /// Lower case, with single blanks.
    key: String,
    value: String,
    line: usize,
}

/// The texts of a piece or of a file.
#[derive(Clone, Debug, Default)]
pub(crate) struct DxfLabels {
    labels: Vec<TextLabel>,
    /// Texts that are no labels.
    notes: Vec<String>,
}

impl DxfLabels {
    /// Returns the labels and notes among entities.
    pub(crate) fn of<'a>(entities: impl Iterator<Item = &'a DxfEntity>) -> Self {
        let mut found = Self::default();
        for entity in entities {
            let EntityShape::Text(_, text) = &entity.shape else {
                continue;
            };
            match split(text) {
                Some((key, value)) => found.labels.push(TextLabel {
                    key,
                    value,
                    line: entity.line,
                }),
                None if found.notes.len() < NOTES => found.notes.push(text.trim().to_owned()),
                None => {}
            }
        }
        found
    }

    /// Returns the first value of `key` (lower case) that is not empty.
    pub(crate) fn get(&self, key: &str) -> Option<&str> {
        self.with_line(key).map(|(value, _)| value)
    }

    /// Returns the first value of `key` (lower case) that is not empty, with its line.
    pub(crate) fn with_line(&self, key: &str) -> Option<(&str, usize)> {
        let mut labels = self.labels.iter();
        let found = labels.find(|label| label.key == key && !label.value.is_empty());
        found.map(|label| (label.value.as_str(), label.line))
    }

    /// Returns true if a key begins with `start` (lower case).
    pub(crate) fn has_key_with(&self, start: &str) -> bool {
        self.labels.iter().any(|label| label.key.starts_with(start))
    }

    /// Sets the value of `key` (lower case) in place of what the texts say.
    pub(crate) fn set(&mut self, key: &str, value: &str, line: usize) {
        self.labels.retain(|label| label.key != key);
        self.labels.push(TextLabel {
            key: key.to_owned(),
            value: value.to_owned(),
            line,
        });
    }

    /// Returns the texts that are no labels.
    pub(crate) fn notes(&self) -> impl Iterator<Item = &str> {
        self.notes.iter().map(String::as_str)
    }

    /// Returns the number that is cut, by a label (`Quantity: 2`, `Quantity: 1,1`) or a note
    /// (`Cut 2`, `x2`, `1 pair`, `L1 R1`).
    pub(crate) fn quantity(&self) -> Option<Quantity> {
        const KEYS: [&str; 5] = ["quantity", "qty", "cut", "pieces", "number of pieces"];
        let labeled = KEYS
            .iter()
            .find_map(|key| quantity::from_value(self.get(key)?));
        labeled.or_else(|| self.notes.iter().find_map(|note| quantity::from_note(note)))
    }
}

/// Returns true if a text is a label, of a piece or of the whole file.
pub(crate) fn is_label(text: &str) -> bool {
    split(text).is_some()
}

/// Returns true if a text may be the name of a piece: neither a label nor a quantity.
pub(crate) fn is_name(text: &str) -> bool {
    !text.trim().is_empty() && !is_label(text) && quantity::from_note(text).is_none()
}

/// Splits `Key: Value` into the lower-case key and the value; `None` for other text.
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

    fn labels(texts: &[&str]) -> DxfLabels {
        let entities: Vec<DxfEntity> = texts
            .iter()
            .map(|text| DxfEntity {
                layer: "1".into(),
                line: 1,
                shape: EntityShape::Text([0.0; 2], (*text).to_owned()),
            })
            .collect();
        DxfLabels::of(entities.iter())
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
