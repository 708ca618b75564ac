//! Shared by the verbs that read logs: preparation of samples to motion, and the pass over a file.

use std::fs::File;
use std::io::{BufReader, Read, Seek};
use std::path::{Path, PathBuf};

use clap::Args;
use dh_codegen::robot::Robot;
use indicatif::{ProgressBar, ProgressStyle};

use super::Failure;
use super::files;
use super::reading::ReadOptions;
use super::terminal;
use crate::data::log::{
    Acceptance, Digest, Finding, Fingerprint, Fingerprinted, Format, Kind, Reading, Source, Table, open_parquet,
    open_table, source,
};
use crate::data::signal::{DeadZone, Filter, Motion, Prepare, PrepareError, Prepared, each_motion};
use crate::identify::recording::{self, torque_constants};

/// Low-pass, clock, torque column, and what to keep.
#[derive(Args, Clone)]
pub(super) struct Preparation {
    /// Cut-off frequency of the low-pass, Hz; 0 for none. Default: for each joint the one at which
    /// the expected error of its acceleration is least, given the spectrum of its motion and the
    /// noise of its encoder, at most 10.
    #[arg(long)]
    cutoff: Option<f64>,
    /// Order of one pass of the Butterworth low-pass.
    #[arg(long, default_value_t = 5)]
    order: usize,
    /// Seconds cut off both ends of each stretch.
    #[arg(long, default_value_t = 0.2)]
    trim: f64,
    /// Seconds by which the torque is late against the positions; it is moved back by as much.
    #[arg(long, default_value_t = 0.0, value_name = "SECONDS")]
    delay: f64,
    /// Use every n-th sample, after the low-pass. Default: of `force` each; of other verbs as many
    /// as a low-passed signal needs, 12 in a period of the cut-off (1 for each sample).
    #[arg(long, value_name = "N")]
    stride: Option<usize>,
    /// Speed up to which a joint is at rest, rad/s: its dry friction is then anything within its
    /// breakaway level, and its rows do not determine its Coulomb level. Default: three standard
    /// deviations of the speed's noise in the log; 0: never at rest.
    #[arg(long, value_name = "SPEED")]
    dead_zone: Option<f64>,
    #[command(flatten)]
    read: ReadOptions,
}

impl Preparation {
    /// A preparation with defaults for all options not given here.
    pub(super) fn plainly(read: ReadOptions) -> Self {
        Self { cutoff: None, order: 5, trim: 0.2, delay: 0.0, stride: Some(1), dead_zone: None, read }
    }

    /// Refuses options that have no effect with the others. `standing`: reason why every joint
    /// counts as standing, if it does.
    pub(super) fn check_options(&self, standing: Option<&str>) -> Result<(), Failure> {
        if self.cutoff == Some(0.0) && self.order != 5 {
            return Err(Failure::input("--order is of the low-pass, and --cutoff 0 asks for none"));
        }
        match standing.filter(|_| self.dead_zone.is_some()) {
            Some(why) => Err(Failure::input(format!("--dead-zone changes nothing: {why}"))),
            None => Ok(()),
        }
    }

    /// Checks the options and returns the preparation.
    pub(super) fn prepare(&self, robot: &Robot) -> Result<Prepare, Failure> {
        let keep = self.read.keep.acceptance()?;
        let bad = |what: String| Err(Failure::input(what));
        if let Some(cutoff) = self.cutoff.filter(|cutoff| !(*cutoff >= 0.0 && cutoff.is_finite())) {
            return bad(format!("--cutoff {cutoff}: a frequency in Hz, or 0 for none"));
        }
        if !(1..=12).contains(&self.order) {
            return bad(format!("--order {}: from 1 to 12", self.order));
        }
        if !(self.trim >= 0.0 && self.trim.is_finite()) {
            return bad(format!("--trim {}: seconds, zero or more", self.trim));
        }
        if self.delay.is_nan() || self.delay.abs() > 10.0 {
            return bad(format!("--delay {}: seconds, at most 10", self.delay));
        }
        if let Some(speed) = self.dead_zone.filter(|speed| !(*speed >= 0.0 && speed.is_finite())) {
            return bad(format!("--dead-zone {speed}: a speed in rad/s, or 0 for none"));
        }
        if self.stride == Some(0) {
            return bad("--stride 0: one or more".into());
        }
        Ok(Prepare {
            filter: Some(self.highest()).filter(|filter| filter.cutoff > 0.0),
            adaptive: self.cutoff.is_none(),
            dead_zone: self.dead_zone(),
            trim: self.trim,
            torque_delay: self.delay,
            stride: self.stride.unwrap_or(1),
            thinned: self.stride.is_none(),
            torque: self.read.torque.quantity(),
            torque_constants: torque_constants(robot),
            reading: self.read.map.reading(Some(robot))?,
            keep,
            ..Prepare::default()
        })
    }

    /// Definition of rest.
    fn dead_zone(&self) -> DeadZone {
        match self.dead_zone {
            Some(speed) if speed > 0.0 => DeadZone::Fixed(speed),
            Some(_) => DeadZone::Off,
            None => DeadZone::FromNoise,
        }
    }

    /// The low-pass, or the one with the highest cutoff if it depends on the log.
    fn highest(&self) -> Filter {
        Filter { order: self.order, cutoff: self.cutoff.unwrap_or(Filter::default().cutoff) }
    }

    /// Description of the low-pass for reports.
    pub(super) fn low_pass(prepare: &Prepare) -> String {
        match prepare.filter {
            Some(Filter { order, cutoff }) => {
                let by = if prepare.adaptive { "by the log, at most " } else { "" };
                format!("Butterworth order {order}, {by}{cutoff} Hz, forward and backward")
            }
            None => "none".into(),
        }
    }
}

/// Adds findings from comparing the logs with the limits of the robot file.
///
/// # Errors
/// Returns an error if torques are in another unit and that is not accepted.
pub(super) fn against_limits(prepared: &mut [Prepared], robot: &Robot, keep: Acceptance) -> Result<(), Failure> {
    prepared.iter_mut().try_for_each(|log| recording::against_limits(log, robot, keep)).map_err(Failure::input)
}

/// Prints a warning line if a log has unknown columns, whatever other output there is; returns the
/// log.
pub(super) fn warned(path: &Path, log: Prepared) -> Prepared {
    let unknown = |finding: &&Finding| matches!(finding.kind, Kind::UnknownColumns { .. });
    if let Some(finding) = log.findings.iter().find(unknown) {
        terminal::say(&format!("{}: warning: {finding}", path.display()));
    }
    log
}

/// One pass over a log, with a progress bar on a terminal.
pub(super) fn pass(path: &Path, dof: usize, prepare: &Prepare, sink: impl FnMut(&Motion)) -> Result<Prepared, Failure> {
    try_pass(path, dof, prepare, sink)?.map_err(Failure::input)
}

/// The same; an error of the preparation is returned unchanged, for callers that can handle it.
pub(super) fn try_pass(
    path: &Path,
    dof: usize,
    prepare: &Prepare,
    sink: impl FnMut(&Motion),
) -> Result<Result<Prepared, PrepareError>, Failure> {
    keep_pages();
    let (bar, mut source) = open(path, &prepare.reading, None)?;
    let prepared = each_motion(&mut *source, dof, prepare, sink);
    bar.finish_and_clear();
    Ok(prepared)
}

/// Result of a first pass over a log: its preparation, and its digest and fingerprint.
pub(super) struct Recognised {
    pub prepared: Result<Prepared, PrepareError>,
    /// SHA-256 of the file's bytes.
    pub sha256: String,
    pub fingerprint: Fingerprint,
}

/// [`try_pass`] with digest and fingerprint.
pub(super) fn recognised_pass(
    path: &Path,
    dof: usize,
    prepare: &Prepare,
    sink: impl FnMut(&Motion),
) -> Result<Recognised, Failure> {
    let ((prepared, fingerprint), sha256) = hashed_pass(path, &prepare.reading, |source| {
        let mut fingerprinted = Fingerprinted::new(source);
        (each_motion(&mut fingerprinted, dof, prepare, sink), fingerprinted.finish())
    })?;
    Ok(Recognised { prepared, sha256, fingerprint })
}

/// Result of `read` on the rows of a log, and the SHA-256 of the file's bytes.
pub(super) fn hashed_pass<T>(
    path: &Path,
    reading: &Reading,
    read: impl FnOnce(&mut dyn Source) -> T,
) -> Result<(T, String), Failure> {
    let digest = Digest::default();
    let (bar, mut source) = open(path, reading, Some(&digest))?;
    let found = read(&mut *source);
    bar.finish_and_clear();
    Ok((found, digest.hexadecimal()))
}

/// The rows of a log, and its progress bar.
fn open(path: &Path, reading: &Reading, digest: Option<&Digest>) -> Result<(ProgressBar, Box<dyn Source>), Failure> {
    let (bar, name, table) = opened(path, reading, digest)?;
    Ok((bar, source(&name, table, reading).map_err(Failure::input)?))
}

/// A log's table as in its file, and its name for messages.
pub(super) fn table(path: &Path, reading: &Reading) -> Result<(String, Box<dyn Table>), Failure> {
    keep_pages();
    opened(path, reading, None).map(|(_, name, table)| (name, table))
}

/// Opens a log and hashes it into `digest` while it is read. Parquet is read with seeking, all
/// other formats as a stream.
fn opened(
    path: &Path,
    reading: &Reading,
    digest: Option<&Digest>,
) -> Result<(ProgressBar, String, Box<dyn Table>), Failure> {
    let name = if files::is_stdin(path) { "standard input".into() } else { path.display().to_string() };
    let inside = recorded_in(path)?;
    let path = inside.as_deref().unwrap_or(path);
    let mut file = files::open(path)?;
    let bar = bar(path, &file);
    let failed = |e: std::io::Error| Failure::input(format!("{name} can't be read: {e}"));
    let seeks = |format: &Format| *format == Format::Parquet || cfg!(feature = "rosbag2") && *format == Format::Sqlite;
    let format = format_of(&mut file).map_err(failed)?.filter(seeks);
    if let (Some(_), Some(digest)) = (format, digest) {
        digest.take_in(BufReader::with_capacity(1 << 18, bar.wrap_read(&file))).map_err(failed)?;
        file.rewind().map_err(failed)?;
    }
    let table = match format {
        Some(Format::Parquet) => open_parquet(&name, file),
        #[cfg(feature = "rosbag2")]
        Some(Format::Sqlite) => {
            let flags = rusqlite::OpenFlags::SQLITE_OPEN_READ_ONLY;
            let failed = |e| Failure::input(format!("{name} can't be read: {e}"));
            let connection = rusqlite::Connection::open_with_flags(path, flags).map_err(failed)?;
            crate::data::log::open_sqlite(&name, connection, reading)
        }
        _ => {
            let input = BufReader::new(bar.wrap_read(file));
            match digest {
                Some(digest) => open_table(&name, digest.reading(input), reading),
                None => open_table(&name, input, reading),
            }
        }
    };
    table.map(|table| (bar, name, table)).map_err(Failure::input)
}

/// Makes the allocator keep memory that is freed between two chunks of a log. glibc returns blocks
/// above the size of the largest freed one to the kernel, which then clears each page: two thirds
/// of the kernel's time on a long log. No page of this block is touched.
///
/// A diagnosis, which keeps what it has read, does not use this: there would be holes between its
/// blocks.
pub(super) fn keep_pages() {
    drop(std::hint::black_box(Vec::<u8>::with_capacity(31 << 20)));
}

/// The single file in a folder written by rosbag2; `None` if the path is no such folder.
fn recorded_in(path: &Path) -> Result<Option<PathBuf>, Failure> {
    if !path.join("metadata.yaml").is_file() {
        return Ok(None);
    }
    let failed = |e: std::io::Error| Failure::input(format!("{} can't be read: {e}", path.display()));
    let mut found = Vec::new();
    for entry in std::fs::read_dir(path).map_err(failed)? {
        let entry = entry.map_err(failed)?.path();
        let name = entry.to_string_lossy();
        if [".mcap", ".db3", ".db3.zstd", ".mcap.zstd"].iter().any(|ending| name.ends_with(ending)) {
            found.push(entry);
        }
    }
    found.sort();
    match found.as_slice() {
        [one] => Ok(Some(one.clone())),
        [] => Err(Failure::input(format!("{} has no recording (.mcap, .db3)", path.display()))),
        many => {
            let names: Vec<String> = many.iter().map(|p| p.display().to_string()).collect();
            Err(Failure::input(format!(
                "{} has {} recordings; give each as a log of its own: {}",
                path.display(),
                many.len(),
                names.join(" ")
            )))
        }
    }
}

/// Format of a plain file; `None` for a pipe.
fn format_of(file: &mut File) -> std::io::Result<Option<Format>> {
    if !file.metadata()?.is_file() || file.stream_position()? != 0 {
        return Ok(None);
    }
    let mut magic = Vec::new();
    file.by_ref().take(16).read_to_end(&mut magic)?;
    file.rewind()?;
    Ok(Some(Format::of(&magic)))
}

/// A progress bar on a terminal if the file is large.
fn bar(path: &Path, file: &File) -> ProgressBar {
    let bar = match file.metadata() {
        Ok(meta) if meta.len() > 1 << 20 => ProgressBar::new(meta.len()),
        _ => ProgressBar::hidden(),
    };
    if let Ok(style) = ProgressStyle::with_template("{msg} [{bar:30}] {bytes}/{total_bytes} {eta}") {
        bar.set_style(style);
    }
    bar.set_message(terminal::visible(&path.display().to_string()).into_owned());
    bar
}
