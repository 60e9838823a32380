//! Texts of the form `Key: Value`, by which AAMA and ASTM files say names, sizes, quantities and units.

use super::entity::{Entity, Shape};
use crate::pattern::Quantity;

/// The labels of a piece or of a file, with the line of each.
#[derive(Clone, Debug, Default)]
pub(super) struct Labels(Vec<(String, String, usize)>);

impl Labels {
    /// The labels among these entities.
    pub(super) fn of<'a>(entities: impl Iterator<Item = &'a Entity>) -> Self {
        Self(
            entities
                .filter_map(|entity| match &entity.shape {
                    Shape::Text(_, text) => {
                        split(text).map(|(key, value)| (key, value, entity.line))
                    }
                    _ => None,
                })
                .collect(),
        )
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

    /// `Quantity: 2` (as drawn) or `Quantity: 1,1` (as drawn, mirrored).
    pub(super) fn quantity(&self) -> Option<Quantity> {
        let mut parts = self.get("quantity")?.split(',').map(|part| {
            let digits: String = part
                .trim()
                .chars()
                .take_while(char::is_ascii_digit)
                .collect();
            digits.parse::<u32>().ok()
        });
        Some(Quantity {
            left: parts.next()??,
            right: parts.next().flatten().unwrap_or(0),
        })
    }
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
