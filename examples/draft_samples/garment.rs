//! The garment file of a draft: its seams by the corners that the drawing has, and where its panels start.

use seamster::scene::DressForm;
use serde_json::{Value, json};

/// Seams and placements of a garment.
pub(crate) struct Draft {
    /// Name, then both sides, each a panel with the corners it runs from and to; the `from`s meet.
    pub(crate) seams: Vec<(&'static str, Run, Run)>,
    /// Panels and the key points they start at.
    pub(crate) placements: Vec<(&'static str, &'static str)>,
}

/// A panel, the corner where a side of a seam begins, and the one where it ends.
pub(crate) type Run = (&'static str, usize, usize);

impl Draft {
    /// The file, without `pattern`.
    pub(crate) fn json(&self, form: &DressForm) -> String {
        let seams: Vec<Value> = self
            .seams
            .iter()
            .map(|(id, a, b)| json!({"id": id, "a": side(a), "b": side(b)}))
            .collect();
        let panels: serde_json::Map<String, Value> = self
            .placements
            .iter()
            .map(|(panel, at)| ((*panel).to_owned(), json!({"placement": {"at": at}})))
            .collect();
        let file = json!({
            "schema": "seamster/garment/1",
            "seams": seams,
            "panels": panels,
            "default_fabric": "cotton-poplin",
            "avatar": {"form": form},
        });
        let mut text = serde_json::to_string_pretty(&file).expect("plain values have a text");
        text.push('\n');
        text
    }
}

fn side((panel, from, to): &Run) -> Value {
    json!({"panel": panel, "from": from, "to": to})
}
