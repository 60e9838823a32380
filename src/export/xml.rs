//! Texts made safe to stand in XML, such as names that came from an upload.

/// Escapes a text for content and attributes: the five characters of XML are written as references,
/// what XML cannot hold or what turns the direction of writing becomes a blank.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\'' => escaped += "&#39;",
            c if c.is_control() || is_format(c) => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

/// Returns true for characters that are not to be seen but change how others are, and those that
/// XML 1.0 leaves out.
fn is_format(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}')
        || matches!(u32::from(c) & 0xffff, 0xfffe | 0xffff)
}

#[cfg(test)]
mod tests {
    use super::escape;

    #[test]
    fn texts_can_neither_end_an_element_nor_begin_one() {
        assert_eq!(
            escape("</text><script>\"&'\u{0}\u{1b}\u{202e}\u{ffff}"),
            "&lt;/text&gt;&lt;script&gt;&quot;&amp;&#39;    "
        );
        assert_eq!(escape("Ärmel 前片 É"), "Ärmel 前片 É");
    }
}
