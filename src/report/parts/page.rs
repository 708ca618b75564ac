//! The frame of every page: one file that needs no network.

use serde_json::Value;

use crate::report::visible;

/// What differs between pages.
pub(in crate::report) struct Page<'a> {
    /// In the window's title; plain text.
    pub title: String,
    /// Style beyond `page.css`.
    pub style: &'a str,
    /// Markup of the body.
    pub body: &'a str,
    /// What the script draws, as `data`.
    pub data: Value,
    /// Script after `page.js`.
    pub script: &'a str,
}

impl Page<'_> {
    pub(in crate::report) fn html(&self) -> String {
        // `</` would end the script element.
        let data = self.data.to_string().replace("</", "<\\/");
        format!(
            "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport content='width=device-width, initial-scale=1'>\n<title>{}</title>\n<style>\n{}{}</style></head>\n<body>\n{}<noscript><p>The curves need JavaScript; the tables do not.</p></noscript>\n<script id=data type=application/json>{data}</script>\n<script>\n{}{}</script>\n</body></html>\n",
            escape(&self.title),
            include_str!("page.css"),
            self.style,
            self.body,
            include_str!("page.js"),
            self.script,
        )
    }
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
