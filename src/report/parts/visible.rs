//! Makes control characters visible in text for readers.

use std::borrow::Cow;

/// Writes control characters as `\u{1b}`; line breaks and tabs stay. Marks that reorder or hide
/// text count as control characters.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(is_control) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_control(c) { out.extend(c.escape_unicode()) } else { out.push(c) }
    }
    Cow::Owned(out)
}

/// Whether a terminal interprets this character instead of showing it.
pub fn is_control(c: char) -> bool {
    let layout = matches!(c, '\n' | '\t');
    let unseen = matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}');
    (c.is_control() && !layout) || unseen
}
