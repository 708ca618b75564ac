//! The logs of a command: purpose, digest and fingerprint of each. No sample counts twice.

use std::path::{Path, PathBuf};

use dh_codegen::robot::files_of_runs;

use super::Failure;
use super::prepare::{Recognised, keep_pages, recognised_pass};
use crate::data::log::{Common, Finding, Fingerprint, Kind, Severity};
use crate::data::signal::{Motion, Prepare, PrepareError, Prepared};

/// Purpose of a log.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    Fit,
    Validate,
    Unloaded,
    Loaded,
    Estimate,
}

impl Purpose {
    fn name(self) -> &'static str {
        match self {
            Self::Fit => "fitted",
            Self::Validate => "validating",
            Self::Unloaded => "unloaded",
            Self::Loaded => "loaded",
            Self::Estimate => "estimated",
        }
    }
}

/// A log that was read.
struct Entry {
    purpose: Purpose,
    path: PathBuf,
    sha256: String,
    fingerprint: Fingerprint,
}

/// Largest number of rows in the fingerprints of all logs: 34 MB.
const MOST_ROWS: usize = 1 << 19;

/// Largest number of logs of a command: each has its own factors, some 0.4 MB.
const MOST_LOGS: usize = 200;

/// The logs read so far.
#[derive(Default)]
pub(super) struct Logbook {
    entries: Vec<Entry>,
    /// Logs that were fitted when the robot file was made: path and SHA-256.
    fitted_before: Vec<[String; 2]>,
}

impl Logbook {
    /// Creates a logbook for a command on the robot file with this text.
    pub(super) fn of(robot_file: &str) -> Self {
        let fitted = files_of_runs(robot_file).into_iter().filter(|[purpose, ..]| *purpose == "fitted log");
        Self { fitted_before: fitted.map(|[_, path, sha256]| [path, sha256]).collect(), ..Self::default() }
    }

    /// First pass over a log. A log that shares samples with an earlier one is refused.
    pub(super) fn pass(
        &mut self,
        purpose: Purpose,
        path: &Path,
        dof: usize,
        prepare: &Prepare,
        sink: impl FnMut(&Motion),
    ) -> Result<Prepared, Failure> {
        keep_pages();
        self.try_pass(purpose, path, dof, prepare, sink)?.map_err(Failure::input)
    }

    /// The same; an error of the preparation is returned unchanged.
    pub(super) fn try_pass(
        &mut self,
        purpose: Purpose,
        path: &Path,
        dof: usize,
        prepare: &Prepare,
        sink: impl FnMut(&Motion),
    ) -> Result<Result<Prepared, PrepareError>, Failure> {
        if self.entries.len() >= MOST_LOGS {
            return Err(Failure::input(format!(
                "more than {MOST_LOGS} logs: join recordings in one file, numbered in a column `seg`"
            )));
        }
        let Recognised { mut prepared, sha256, fingerprint } = recognised_pass(path, dof, prepare, sink)?;
        if let Ok(prepared) = &mut prepared {
            if purpose == Purpose::Validate {
                prepared.findings.extend(self.fitted_before(&sha256));
            }
            let entry = Entry { purpose, path: path.to_path_buf(), sha256, fingerprint };
            self.entries.iter().try_for_each(|other| apart(&entry, other))?;
            self.entries.push(entry);
            let share = MOST_ROWS / self.entries.len();
            self.entries.iter_mut().for_each(|entry| entry.fingerprint.shrink(share));
        }
        Ok(prepared)
    }

    /// Note on a validating log that was fitted before.
    fn fitted_before(&self, sha256: &str) -> Option<Finding> {
        let [path, _] = self.fitted_before.iter().find(|[_, digest]| digest == sha256)?;
        let kind = Kind::FittedBefore { path: path.clone() };
        Some(Finding { kind, severity: Severity::Warning, line: None, column: None, count: 1 })
    }

    /// Purpose, path and SHA-256 of each file, for a provenance.
    pub(super) fn digests(&self) -> impl Iterator<Item = (&'static str, String, &str)> {
        self.entries.iter().map(|e| (e.purpose.name(), e.path.display().to_string(), e.sha256.as_str()))
    }
}

/// Refuses a log that shares samples with another one.
fn apart(log: &Entry, other: &Entry) -> Result<(), Failure> {
    let Some(common) = log.fingerprint.common(&other.fingerprint) else { return Ok(()) };
    let (shown, before) = (log.path.display(), other.path.display());
    let (here, there) = (log.purpose.name(), other.purpose.name());
    let what = match common {
        Common::All => format!("{shown} ({here}) holds the same samples as {before} ({there})"),
        Common::Stretch(seconds) => format!(
            "{shown} ({here}) shares {seconds:.1} of its {:.1} s with {before} ({there}): the samples are equal, bit for bit",
            log.fingerprint.duration()
        ),
        Common::Rounded(seconds) => format!(
            "{shown} ({here}) shares {seconds:.1} of its {:.1} s with {before} ({there}): the samples are equal where both are written with as many digits",
            log.fingerprint.duration()
        ),
    };
    let advice = if log.purpose != other.purpose {
        "figures on samples that were used already say nothing; give logs of separate recordings"
    } else if matches!(log.purpose, Purpose::Fit | Purpose::Unloaded | Purpose::Loaded) {
        "samples that count twice make standard deviations too small; give each recording once"
    } else {
        "give each recording once"
    };
    Err(Failure::input(format!("{what}; {advice}")))
}
