//! Warnings that precede the figures: one list per result, shared by text, JSON and page.

use serde_json::{Value, json};

use crate::data::log::{Finding, Kind, Severity};
use crate::data::signal::Prepared;
use crate::report::parts::page::escape;

/// Warnings of one result, the most serious first.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Warnings {
    all: Vec<String>,
    /// Warnings that were printed to the terminal before the result.
    shown: Vec<String>,
}

impl Warnings {
    /// Adds a warning, a sentence or a paragraph.
    pub fn push(&mut self, warning: impl Into<String>) {
        self.all.push(warning.into());
    }

    /// Adds a warning that was printed to the terminal when it arose.
    pub fn push_shown(&mut self, warning: impl Into<String>) {
        self.shown.push(warning.into());
    }

    /// Adds findings more serious than notes.
    pub fn findings(&mut self, findings: &[Finding]) {
        let grave = findings.iter().filter(|f| f.severity != Severity::Note);
        self.all.extend(grave.map(ToString::to_string));
    }

    /// Adds findings in the logs more serious than notes.
    pub fn logs(&mut self, logs: &[Prepared]) {
        for log in logs {
            let grave = log.findings.iter().filter(|f| f.severity != Severity::Note);
            self.all.extend(grave.map(|f| format!("{}: {f}", log.file)));
            let unknown = log.findings.iter().filter(|f| matches!(f.kind, Kind::UnknownColumns { .. }));
            self.shown.extend(unknown.map(|f| format!("{}: {f}", log.file)));
        }
    }

    /// Iterates over all warnings.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        self.all.iter().chain(&self.shown).map(String::as_str)
    }

    /// For the terminal: one paragraph each, after an empty line.
    pub fn text(&self) -> String {
        self.all.iter().map(|warning| format!("\nwarning: {warning}\n")).collect()
    }

    /// The key `warnings`.
    pub fn json(&self) -> Value {
        json!(self.iter().collect::<Vec<_>>())
    }

    /// The section after the header of a page; empty without warnings.
    pub(in crate::report) fn html(&self) -> String {
        if self.iter().next().is_none() {
            return String::new();
        }
        let items: String = self.iter().map(|w| format!("<li class=warning>{}</li>\n", escape(w))).collect();
        format!("<section><h2>Warnings</h2><ul class=findings>\n{items}</ul></section>\n")
    }
}
