//! JSON Pointers (RFC 6901).

/// Returns a name as a token of a JSON Pointer: `~` and `/` escaped.
pub(crate) fn pointer_token(name: &str) -> String {
    name.replace('~', "~0").replace('/', "~1")
}
