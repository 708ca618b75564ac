//! Wraps the comments of printed code at 100 columns.

/// Last column of a comment line.
const WIDTH: usize = 100;

/// Text with comment lines no longer than [`WIDTH`], as far as words allow. Tables and code are
/// kept as they are: they are no comments, or must not be wrapped.
pub(super) fn wrapped(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + text.len() / 50);
    let mut fenced = false;
    for line in text.split_inclusive('\n') {
        let indent = line.len() - line.trim_start_matches(' ').len();
        let marks = ["///", "//!", "//"].into_iter().find(|m| line[indent..].starts_with(m));
        let Some(mark) = marks else {
            out += line;
            continue;
        };
        let body = line[indent + mark.len()..].trim();
        fenced ^= body.starts_with("```");
        if line.trim_end().chars().count() <= WIDTH || body.starts_with('|') || fenced {
            out += line;
            continue;
        }
        let list = if body.starts_with("- ") { "  " } else { "" };
        let head = format!("{}{mark} ", &line[..indent]);
        out += &paragraph(body, &head, list);
        out.push('\n');
    }
    out
}

/// Wraps words into lines that begin with `head`, and from the second line on also with `hang`.
fn paragraph(body: &str, head: &str, hang: &str) -> String {
    let mut lines = vec![head.to_string()];
    let mut empty = true;
    for word in body.split_whitespace() {
        let length = |text: &str| text.chars().count();
        let line = lines.last().map_or(0, |l| length(l));
        if !empty && line + 1 + length(word) > WIDTH {
            lines.push(format!("{head}{hang}"));
            empty = true;
        }
        if let Some(line) = lines.last_mut() {
            if !empty {
                line.push(' ');
            }
            line.push_str(word);
            empty = false;
        }
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::wrapped;

    #[test]
    fn long_comments_wrap_and_keep_their_words() {
        let words = "word ".repeat(40);
        let text =
            format!("    /// {words}\n//! | {words} |\nlet x = \"// {words}\";\n//! ```\n//! {words}\n//! ```\n");
        let out = wrapped(&text);
        let lines: Vec<&str> = out.lines().collect();
        let wrapped_lines = lines.iter().filter(|l| l.starts_with("    /// ")).count();
        assert_eq!(wrapped_lines, 3, "{out}");
        assert!(lines[..3].iter().all(|l| l.len() <= 100), "{out}");
        assert_eq!(lines.len(), 3 + 5, "table, code and strings stay: {out}");
        assert_eq!(out.matches("word").count(), text.matches("word").count());
    }
}
