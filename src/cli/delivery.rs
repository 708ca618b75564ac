//! Delivery of a result: files, page, JSON and text, in the same way for all verbs.

use std::path::PathBuf;

use serde_json::Value;

use super::Failure;
use super::files;
use super::provenance::Provenance;

/// Outputs being delivered. The text is printed unless another output goes to standard output.
pub(super) struct Delivery<'a> {
    provenance: &'a Provenance,
    on_stdout: bool,
    written: Vec<PathBuf>,
}

/// Starts the delivery of a result with this provenance.
pub(super) fn deliver(provenance: &Provenance) -> Delivery<'_> {
    Delivery { provenance, on_stdout: false, written: Vec::new() }
}

impl Delivery<'_> {
    /// Writes a file, if a path is given.
    pub(super) fn file<B: AsRef<[u8]>>(
        self,
        path: Option<&PathBuf>,
        content: impl FnOnce() -> B,
    ) -> Result<Self, Failure> {
        self.try_file(path, || Ok(content()))
    }

    /// Writes a file whose content can fail, if a path is given.
    pub(super) fn try_file<B: AsRef<[u8]>>(
        mut self,
        path: Option<&PathBuf>,
        content: impl FnOnce() -> Result<B, Failure>,
    ) -> Result<Self, Failure> {
        if let Some(path) = path {
            files::write(path, content()?.as_ref())?;
            self.wrote(path);
        }
        Ok(self)
    }

    /// Records a file that has already been written.
    pub(super) fn wrote(&mut self, path: &PathBuf) {
        self.on_stdout |= files::is_stdout([path]);
        self.written.push(path.clone());
    }

    /// Writes the JSON, if a path is given.
    pub(super) fn json(mut self, path: Option<&PathBuf>, value: impl FnOnce() -> Value) -> Result<Self, Failure> {
        if let Some(path) = path {
            files::json(path, value(), self.provenance)?;
            self.on_stdout |= files::is_stdout([path]);
        }
        Ok(self)
    }

    /// Prints the text, then the names of the files written.
    pub(super) fn text(self, text: impl FnOnce() -> String) -> Result<(), Failure> {
        let written = self.written.iter().map(|path| format!("wrote {}\n", path.display()));
        let written: String = written.collect();
        self.only_text(|| text() + &written)
    }

    /// Prints the text alone.
    pub(super) fn only_text(self, text: impl FnOnce() -> String) -> Result<(), Failure> {
        if self.on_stdout { Ok(()) } else { files::print(&text()) }
    }
}
