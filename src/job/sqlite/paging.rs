//! Pages of a list that is sorted by falling id.

use crate::job::store::{Page, PageRequest};
use rusqlite::types::Value;
use uuid::Uuid;

/// Returns the id that all ids of a page are below.
pub(super) fn id_bound(request: &PageRequest) -> Value {
    let id = request.after.unwrap_or(Uuid::max());
    id.as_bytes().to_vec().into()
}

/// Returns the number of rows to read: one more than the page holds, to learn whether there is a
/// next page.
pub(super) fn row_limit(request: &PageRequest) -> i64 {
    i64::try_from(request.limit).map_or(i64::MAX, |limit| limit.saturating_add(1))
}

/// Makes a page of the rows that were read by [`row_limit`].
pub(super) fn into_page<T>(
    mut items: Vec<T>,
    request: &PageRequest,
    id: impl Fn(&T) -> Uuid,
) -> Page<T> {
    let is_more = items.len() > request.limit;
    items.truncate(request.limit);
    let last = items.last().map(id);
    Page {
        next: last.filter(|_| is_more),
        items,
    }
}
