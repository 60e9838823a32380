//! The bounds of one kind of JSON, by place.

use crate::config::Limits;
use std::collections::BTreeMap;

/// The name of a step of a place that stands for every item of a list and every field of an object.
const EVERY: &str = "*";

/// The bounds of one kind of JSON.
#[derive(Clone, Debug)]
pub(crate) struct JsonBounds {
    /// Lists and objects that have a limit of their own.
    pub(super) root: BoundedPlace,
    /// The bounds of every other place.
    pub(super) elsewhere: AnyPlace,
}

/// The bounds of places that have none of their own.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AnyPlace {
    /// Items of a list, or fields of an object.
    pub(crate) items: usize,
    /// Characters of a text or of the name of a field.
    pub(crate) chars: usize,
    /// Memory of the whole, once it is read \[bytes\].
    pub(crate) memory: usize,
}

/// A place and those below it.
#[derive(Clone, Debug, Default)]
pub(super) struct BoundedPlace {
    items: Option<usize>,
    below: BTreeMap<&'static str, Self>,
}

impl AnyPlace {
    /// Returns the bounds of requests.
    pub(crate) fn of_requests(limits: &Limits) -> Self {
        Self {
            items: limits.list_items,
            chars: limits.text_chars,
            memory: limits.json_memory_bytes,
        }
    }
}

impl JsonBounds {
    /// Creates bounds of lists and objects, each by its place, where `*` stands for any item or
    /// field: `/seams/*/a`.
    pub(crate) fn new(
        elsewhere: AnyPlace,
        lists: impl IntoIterator<Item = (&'static str, usize)>,
    ) -> Self {
        let mut root = BoundedPlace::default();
        for (place, items) in lists {
            root.at(place).items = Some(items);
        }
        Self { root, elsewhere }
    }

    /// Returns the bounds of a document that has this one under the name `field`.
    pub(crate) fn under(self, field: &'static str) -> Self {
        let below = BTreeMap::from([(field, self.root)]);
        let root = BoundedPlace { items: None, below };
        Self { root, ..self }
    }
}

impl BoundedPlace {
    /// Returns the place at `path` below this one, made if it is not there.
    fn at(&mut self, path: &'static str) -> &mut Self {
        let steps = path.split('/').filter(|step| !step.is_empty());
        steps.fold(self, |place, step| place.below.entry(step).or_default())
    }

    /// Returns the bound of the items of a list or the fields of an object here.
    pub(super) fn items(&self) -> Option<usize> {
        self.items
    }

    /// Returns the place of the field `name`.
    pub(super) fn field(&self, name: &str) -> Option<&Self> {
        self.below.get(name).or_else(|| self.below.get(EVERY))
    }

    /// Returns the place of each item.
    pub(super) fn item(&self) -> Option<&Self> {
        self.below.get(EVERY)
    }
}
