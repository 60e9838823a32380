//! JSON of clients, measured before it is read: the items of its lists, the characters of its texts
//! and the memory that reading it takes. Measuring itself takes next to none.

mod bounds;
mod measure;

pub(crate) use bounds::{AnyPlace, JsonBounds};
pub(crate) use measure::{MOST_LISTED, measure};
