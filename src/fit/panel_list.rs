//! Panels by their ids in a sentence.

/// Panels that are named; of a garment of thousands the rest is counted.
const NAMED: usize = 8;

/// Returns the ids of panels as a sentence lists them.
pub(super) fn panel_list<'a>(ids: impl Iterator<Item = &'a str>) -> String {
    let quoted: Vec<_> = ids.map(|id| format!("`{id}`")).collect();
    let (named, others) = quoted.split_at(quoted.len().min(NAMED));
    match others.len() {
        0 => named.join(", "),
        more => format!("{} and {more} more", named.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_are_counted() {
        let ids: Vec<String> = (0..11).map(|i| format!("p{i}")).collect();
        let list = |count: usize| panel_list(ids[..count].iter().map(String::as_str));
        assert_eq!(list(2), "`p0`, `p1`");
        assert!(list(8).ends_with("`p7`"));
        assert!(list(11).ends_with("`p7` and 3 more"));
    }
}
