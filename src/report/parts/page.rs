//! Frame of every HTML page: one self-contained file.

use std::fmt::Write;

use serde_json::Value;

use crate::report::visible;

/// Content that differs between pages.
pub(in crate::report) struct Page<'a> {
    /// Title of the window; plain text.
    pub title: String,
    /// Style rules beyond `page.css`.
    pub style: &'a str,
    /// Markup of the body.
    pub body: &'a str,
    /// Data of the script, as `data`.
    pub data: Value,
    /// Script that follows `page.js`.
    pub script: &'a str,
}

impl Page<'_> {
    pub(in crate::report) fn html(&self) -> String {
        // `</` would end the script element.
        let data = self.data.to_string().replace("</", "<\\/");
        let body = with_contents(self.body);
        format!(
            "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport content='width=device-width, initial-scale=1'>\n<title>{}</title>\n<style>\n{}{}</style></head>\n<body>\n{}<noscript><p>The curves need JavaScript; the tables do not.</p></noscript>\n<script id=data type=application/json>{data}</script>\n<script>\n{}{}</script>\n</body></html>\n",
            escape(&self.title),
            include_str!("page.css"),
            self.style,
            body,
            include_str!("page.js"),
            self.script,
        )
    }
}

/// Number of headings up to which there is no table of contents.
const CONTENTS: usize = 4;

/// The body with links to its headings before the first section.
fn with_contents(body: &str) -> String {
    let parts: Vec<&str> = body.split("<h2>").collect();
    let (Some(start), true) = (body.find("<section"), parts.len() > CONTENTS) else { return body.to_string() };
    let mut links = String::from("<nav aria-label=Contents>");
    let mut numbered = String::from(parts[0]);
    for (number, part) in parts.iter().enumerate().skip(1) {
        let heading = part.split("</h2>").next().unwrap_or_default();
        let _ = write!(links, "<a href='#s{number}'>{heading}</a> ");
        let _ = write!(numbered, "<h2 id=s{number}>{part}");
    }
    links.push_str("</nav>\n");
    // The length before the first section is unchanged: headings are inside sections.
    let at = if body[..start].contains("<h2>") { 0 } else { start };
    numbered.insert_str(at, &links);
    numbered
}

/// Escapes text for markup; control characters become visible.
pub(in crate::report) fn escape(text: &str) -> String {
    visible(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace('\'', "&#39;")
}
