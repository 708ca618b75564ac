//! The frame of every page: one file that needs no network.

use std::fmt::Write;

use serde_json::Value;

use crate::report::visible;

/// Differences between pages.
pub(in crate::report) struct Page<'a> {
    /// In the window's title; plain text.
    pub title: String,
    /// Style beyond `page.css`.
    pub style: &'a str,
    /// Markup of the body.
    pub body: &'a str,
    /// Input of the script, as `data`.
    pub data: Value,
    /// Script after `page.js`.
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

/// Fewest headings that a table of contents is worth.
const CONTENTS: usize = 4;

/// The body with a link to each of its headings in front of the first section.
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
    // Nothing before the first section changes its length: headings stand in sections.
    let at = if body[..start].contains("<h2>") { 0 } else { start };
    numbered.insert_str(at, &links);
    numbered
}

/// Text inside markup; control characters are shown.
pub(in crate::report) fn escape(text: &str) -> String {
    visible(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace('\'', "&#39;")
}
