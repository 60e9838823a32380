//! Lists of names in sentences.

/// Names listed in one sentence before it says how many more there are.
const MAX_NAMED: usize = 8;

/// Returns names in quotation marks, each once, with "and" before the last.
pub(crate) fn quoted_list<'a, T>(names: impl Iterator<Item = &'a T>) -> String
where
    T: AsRef<str> + ?Sized + 'a,
{
    let mut quoted: Vec<String> = vec![];
    for name in names.map(|name| format!("`{}`", name.as_ref())) {
        if !quoted.contains(&name) {
            quoted.push(name);
        }
    }
    if quoted.len() > MAX_NAMED {
        let more = quoted.len() - MAX_NAMED;
        quoted.truncate(MAX_NAMED);
        quoted.push(format!("{more} more"));
    }
    match quoted.pop() {
        Some(last) if !quoted.is_empty() => format!("{} and {last}", quoted.join(", ")),
        Some(last) => last,
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_are_counted_and_each_is_named_once() {
        let ids: Vec<String> = (0..11).map(|i| format!("p{i}")).collect();
        let list = |count: usize| quoted_list(ids[..count].iter());
        assert_eq!(list(0), "");
        assert_eq!(list(1), "`p0`");
        assert_eq!(list(3), "`p0`, `p1` and `p2`");
        assert!(list(8).ends_with("`p6` and `p7`"));
        assert!(list(11).ends_with("`p7` and 3 more"));
        assert_eq!(quoted_list(["a", "b", "a"].into_iter()), "`a` and `b`");
    }
}
