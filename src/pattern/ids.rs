//! Panel ids made from piece names.

use std::collections::BTreeSet;

/// Makes unique ids of names: lower case, what is neither letter, digit nor `_` becomes one `-`, a
/// beginning that all names share with the style's name is left off, and a number is added where
/// two would be equal.
pub(crate) fn from_names(names: &[String], style: &str) -> Vec<String> {
    let slugs: Vec<String> = names.iter().map(|name| slug(name)).collect();
    let prefix = slug(style);
    let stripped: Option<Vec<String>> = slugs
        .iter()
        .map(|s| {
            s.strip_prefix(&prefix)
                .map(|rest| rest.trim_start_matches(['-', '_']).to_owned())
        })
        .collect();
    let short = stripped
        .filter(|s| !prefix.is_empty() && s.len() > 1 && s.iter().all(|rest| !rest.is_empty()));
    unique(short.unwrap_or(slugs))
}

fn slug(name: &str) -> String {
    let mut out = String::new();
    for c in name.to_lowercase().chars() {
        if c.is_alphanumeric() || c == '_' {
            out.push(c);
        } else if !out.ends_with('-') {
            out.push('-');
        }
    }
    out.trim_matches('-').to_owned()
}

fn unique(slugs: Vec<String>) -> Vec<String> {
    let mut taken = BTreeSet::new();
    slugs
        .into_iter()
        .map(|slug| {
            let base = if slug.is_empty() {
                "panel".to_owned()
            } else {
                slug
            };
            let mut id = base.clone();
            let mut number = 2_usize;
            while !taken.insert(id.clone()) {
                id = format!("{base}-{number}");
                number += 1;
            }
            id
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ids(names: &[&str], style: &str) -> Vec<String> {
        from_names(
            &names.iter().map(|n| (*n).to_owned()).collect::<Vec<_>>(),
            style,
        )
    }

    #[test]
    fn ids_are_lower_case_and_unique() {
        assert_eq!(
            ids(
                &["Front / Left", "skirt_front", "FRONT LEFT", "前片", "?"],
                ""
            ),
            ["front-left", "skirt_front", "front-left-2", "前片", "panel"]
        );
    }

    #[test]
    fn style_prefix_is_left_off_where_all_names_have_it() {
        assert_eq!(ids(&["AB12-FR", "AB12-BK"], "ab12"), ["fr", "bk"]);
        assert_eq!(ids(&["AB12-FR", "BK"], "AB12"), ["ab12-fr", "bk"]);
        assert_eq!(ids(&["AB12", "AB12-BK"], "AB12"), ["ab12", "ab12-bk"]);
    }
}
