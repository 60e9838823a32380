//! Words of a name: where it is split, and letters without case and accents.

/// Longest word of a name that is looked at, in characters: no word of any language is longer.
const MAX_WORD: usize = 48;

/// Splits a name into words without case and accents: at what is no letter, where a capital
/// follows a small letter, before the last capital of several that a small letter follows, and
/// where the script changes.
pub(super) fn split(name: &str) -> Vec<String> {
    let letters: Vec<char> = name.chars().filter(|c| !is_combining(*c)).collect();
    let mut words = vec![String::new()];
    for (i, c) in letters.iter().enumerate() {
        let before = i.checked_sub(1).map(|i| letters[i]);
        let small_follows = letters.get(i + 1).is_some_and(|next| next.is_lowercase());
        let capital = c.is_uppercase()
            && before.is_some_and(|b| b.is_lowercase() || b.is_uppercase() && small_follows);
        let script = before.is_some_and(|b| is_unspaced(b) != is_unspaced(*c));
        if capital || script || !c.is_alphabetic() {
            words.push(String::new());
        }
        if c.is_alphabetic()
            && let Some(word) = words.last_mut()
        {
            fold_into(*c, word);
        }
    }
    words.retain(|word| !word.is_empty() && word.chars().count() <= MAX_WORD);
    words
}

/// Writes a letter without case and accents.
fn fold_into(letter: char, word: &mut String) {
    for c in letter.to_lowercase().filter(|c| !is_combining(*c)) {
        match c {
            'á' | 'à' | 'â' | 'ä' | 'ã' | 'å' | 'ą' => word.push('a'),
            'é' | 'è' | 'ê' | 'ë' | 'ę' | 'ě' => word.push('e'),
            'í' | 'ì' | 'î' | 'ï' | 'ı' => word.push('i'),
            'ó' | 'ò' | 'ô' | 'ö' | 'õ' | 'ø' | 'ő' => word.push('o'),
            'ú' | 'ù' | 'û' | 'ü' | 'ů' | 'ű' => word.push('u'),
            'ç' | 'ć' | 'č' => word.push('c'),
            'ñ' | 'ń' => word.push('n'),
            'ś' | 'š' | 'ş' => word.push('s'),
            'ź' | 'ż' | 'ž' => word.push('z'),
            'ý' => word.push('y'),
            'ł' => word.push('l'),
            'ğ' => word.push('g'),
            'ё' => word.push('е'),
            'й' => word.push('и'),
            'æ' => word.push_str("ae"),
            'œ' => word.push_str("oe"),
            'ß' => word.push_str("ss"),
            other => word.push(other),
        }
    }
}

/// Returns true for a letter of a script without spaces between words: Chinese, Japanese, Korean.
pub(super) fn is_unspaced(c: char) -> bool {
    matches!(c, '\u{2e80}'..='\u{9fff}' | '\u{ac00}'..='\u{d7af}' | '\u{f900}'..='\u{faff}')
}

/// Returns true for an accent that follows its letter.
fn is_combining(c: char) -> bool {
    ('\u{300}'..='\u{36f}').contains(&c)
}

/// Returns a word without case and accents.
pub(super) fn folded(word: &str) -> String {
    let mut folded = String::new();
    for c in word.chars().filter(|c| !is_combining(*c)) {
        fold_into(c, &mut folded);
    }
    folded
}
