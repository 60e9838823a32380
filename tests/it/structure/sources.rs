//! Source files of the library and the program.

use std::path::Path;

/// Returns every file of `src` as its path below that and its text, in the order of their paths.
pub(super) fn sources() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut sources = vec![];
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("src is there") {
            let path = entry.expect("src can be listed").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let text = std::fs::read_to_string(&path).expect("sources are text");
                let path = path.strip_prefix(&root).expect("found under it");
                sources.push((path.to_string_lossy().into_owned(), text));
            }
        }
    }
    sources.sort();
    sources
}

/// Returns the code of a file: comments and the insides of strings are left out, and blanks that
/// separate no two words.
pub(super) fn code(text: &str) -> String {
    squeezed(&stripped(text))
}

/// Returns the text with comments and the insides of strings taken out.
fn stripped(text: &str) -> String {
    let mut code = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let skip = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if let Some(length) = string_length(rest) {
            code.push_str("\"\"");
            length
        } else {
            code.push(c);
            c.len_utf8()
        };
        rest = &rest[skip..];
    }
    code
}

/// Returns the length of the string or character that `rest` begins with, if it begins with one.
fn string_length(rest: &str) -> Option<usize> {
    if let Some(raw) = rest.strip_prefix('r') {
        let hashes = raw.len() - raw.trim_start_matches('#').len();
        let end = format!("\"{}", "#".repeat(hashes));
        let inside = raw[hashes..].strip_prefix('"')?;
        return Some(1 + hashes + 1 + inside.find(&end)? + end.len());
    }
    // Characters that would open a string or a comment; lifetimes open nothing.
    for quote in ["'\"'", "'\\\"'", "'/'", "'\\''"] {
        if rest.starts_with(quote) {
            return Some(quote.len());
        }
    }
    let inside = rest.strip_prefix('"')?;
    let mut escaped = false;
    let end = inside.find(|c| {
        let closes = c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        closes
    })?;
    Some(end + 2)
}

/// Returns the code without blanks that separate no two words.
fn squeezed(code: &str) -> String {
    let mut squeezed = String::new();
    let mut words = code.split_whitespace().peekable();
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    while let Some(word) = words.next() {
        squeezed.push_str(word);
        if word.ends_with(is_word) && words.peek().is_some_and(|next| next.starts_with(is_word)) {
            squeezed.push(' ');
        }
    }
    squeezed
}
