//! `Accept`: the media type that a client prefers.

use axum::http::{HeaderMap, header};

/// Returns the type of `offered` that the client prefers (`Accept`, RFC 9110); among equals, and
/// without `Accept`, the first.
pub(in crate::http) fn preferred_type<'a>(
    headers: &HeaderMap,
    offered: &[&'a str],
) -> Option<&'a str> {
    let ranges: Vec<&str> = headers
        .get_all(header::ACCEPT)
        .iter()
        .filter_map(|value| value.to_str().ok())
        .flat_map(|list| list.split(','))
        .filter(|range| !range.trim().is_empty())
        .collect();
    if ranges.is_empty() {
        return offered.first().copied();
    }
    let mut best = None;
    for kind in offered {
        let weight = weight(&ranges, kind);
        if weight > 0.0 && best.is_none_or(|(most, _)| weight > most) {
            best = Some((weight, *kind));
        }
    }
    best.map(|(_, kind)| kind)
}

/// Returns the `q` of the most specific range that `kind` falls in, 0 if none.
fn weight(ranges: &[&str], kind: &str) -> f64 {
    let group = kind.split_once('/').map_or(kind, |(group, _)| group);
    let found = ranges.iter().filter_map(|range| {
        let mut parts = range.split(';').map(str::trim);
        let name = parts.next()?.to_ascii_lowercase();
        let specific = match name.as_str() {
            "*/*" => 0,
            name if name == kind => 2,
            name if name.strip_suffix("/*") == Some(group) => 1,
            _ => return None,
        };
        let q = parts.find_map(|part| part.strip_prefix("q="));
        Some((
            specific,
            q.map_or(Some(1.0), |q| q.parse().ok()).unwrap_or(0.0),
        ))
    });
    found
        .max_by_key(|(specific, _)| *specific)
        .map_or(0.0, |(_, q)| q)
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::HeaderValue;

    const MESH: [&str; 3] = ["model/gltf-binary", "model/obj", "application/json"];

    fn headers(value: &'static str) -> HeaderMap {
        HeaderMap::from_iter([(header::ACCEPT, HeaderValue::from_static(value))])
    }

    #[test]
    fn the_wanted_type_is_chosen_as_the_standard_has_it() {
        for (accept, chosen) in [
            ("model/obj", Some("model/obj")),
            ("*/*", Some("model/gltf-binary")),
            ("application/*", Some("application/json")),
            ("model/*;q=0.2, application/json", Some("application/json")),
            ("*/*, model/gltf-binary;q=0", Some("model/obj")),
            ("text/html", None),
            ("model/obj;q=0", None),
        ] {
            assert_eq!(preferred_type(&headers(accept), &MESH), chosen, "{accept}");
        }
        assert_eq!(preferred_type(&HeaderMap::new(), &MESH), Some(MESH[0]));
    }
}
