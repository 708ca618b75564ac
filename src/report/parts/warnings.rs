//! Warnings before the figures: one list per result, which text, JSON and page all show.

use serde_json::{Value, json};

use crate::data::log::{Finding, Kind, Severity};
use crate::data::signal::Prepared;
use crate::report::parts::page::escape;

/// Warnings of one result, the gravest first.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Warnings {
    all: Vec<String>,
    /// Those that a terminal has shown before the result.
    shown: Vec<String>,
}

impl Warnings {
    /// One more, a sentence or a paragraph.
    pub fn push(&mut self, warning: impl Into<String>) {
        self.all.push(warning.into());
    }

    /// One that a terminal has shown before, as it arose.
    pub fn push_shown(&mut self, warning: impl Into<String>) {
        self.shown.push(warning.into());
    }

    /// Findings that are more than notes.
    pub fn findings(&mut self, findings: &[Finding]) {
        let grave = findings.iter().filter(|f| f.severity != Severity::Note);
        self.all.extend(grave.map(ToString::to_string));
    }

    /// Findings in the logs, except notes.
    pub fn logs(&mut self, logs: &[Prepared]) {
        for log in logs {
            let grave = log.findings.iter().filter(|f| f.severity != Severity::Note);
            self.all.extend(grave.map(|f| format!("{}: {f}", log.file)));
            let unknown = log.findings.iter().filter(|f| matches!(f.kind, Kind::UnknownColumns { .. }));
            self.shown.extend(unknown.map(|f| format!("{}: {f}", log.file)));
        }
    }

    /// Each of them.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        self.all.iter().chain(&self.shown).map(String::as_str)
    }

    /// For the terminal: a paragraph each, behind an empty line.
    pub fn text(&self) -> String {
        self.all.iter().map(|warning| format!("\nwarning: {warning}\n")).collect()
    }

    /// `"warnings"`.
    pub fn json(&self) -> Value {
        json!(self.iter().collect::<Vec<_>>())
    }

    /// The section that stands behind the header of a page; nothing where there is no warning.
    pub(in crate::report) fn html(&self) -> String {
        if self.iter().next().is_none() {
            return String::new();
        }
        let items: String = self.iter().map(|w| format!("<li class=warning>{}</li>\n", escape(w))).collect();
        format!("<section><h2>Warnings</h2><ul class=findings>\n{items}</ul></section>\n")
    }
}
