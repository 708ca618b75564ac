//! `denavit generate`: writes the drop-in crate, or says whether the one on disk is stale.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fs, io};

use clap::{Args, ValueEnum};
use dh_codegen::Runtime;
use dh_codegen::arm::Function;

use super::Failure;
use super::files;
use super::provenance::Provenance;

const MANIFEST: &str = "Cargo.toml";
const ROOT: &str = "src/lib.rs";
/// Root of a crate that is being rewritten.
const UNFINISHED: &str = "compile_error!(\"`denavit generate` was interrupted here; run it again\");\n";

/// Write the drop-in crate with the robot's closed-form functions.
///
/// The crate is a folder of its own: no_std, no allocation, no dependency. With `--runtime crate`
/// it depends on denavit-runtime instead, so that several robots share their types and traits. The
/// same file always gives the same bytes.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit generate robots/kuka-lwr4.yaml --out generated/kuka-lwr4\n  denavit generate robots/kuka-lwr4.yaml --out generated/kuka-lwr4 --check\n  denavit generate robots/ur10e.yaml --out ur10e --adjoints\n  denavit generate robots/ur10e.yaml --out ur10e --runtime crate --runtime-path ../dh-macro/runtime"
)]
pub(super) struct Generate {
    /// Robot file.
    robot: PathBuf,
    /// Folder of the crate: one that is not there yet, is empty, or holds a crate of this command.
    /// Only files of the crate are written.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Derivatives too: of the regressors, the torques and the frames, as products with the
    /// transposed Jacobian (`base_regressor_adjoint` and so on).
    #[arg(long)]
    adjoints: bool,
    /// Where the crate takes its runtime from: a copy inside it, or the crate denavit-runtime.
    #[arg(long, value_enum, default_value = "shipped")]
    runtime: RuntimeSource,
    /// Folder of denavit-runtime, seen from DIR; without it the version of this command is named.
    #[arg(long, value_name = "PATH")]
    runtime_path: Option<String>,
    /// Version of denavit-runtime, as in a Cargo.toml.
    #[arg(long, value_name = "VERSION", conflicts_with = "runtime_path")]
    runtime_version: Option<String>,
    /// Write nothing; exit with 1 where the crate in DIR is not what would be written.
    #[arg(long)]
    check: bool,
    /// Write into a folder that holds something else, too; files of the same names are replaced.
    #[arg(long)]
    force: bool,
    /// Write the list of files and what became of them as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum RuntimeSource {
    /// A copy of what the robot needs.
    Shipped,
    /// A dependency on denavit-runtime.
    Crate,
}

impl Generate {
    /// Runtime of the crate, as the generator takes it.
    fn runtime(&self) -> Result<Runtime, Failure> {
        let quoted = |text: &str| toml_string(text);
        let named = self.runtime_path.is_some() || self.runtime_version.is_some();
        match self.runtime {
            RuntimeSource::Shipped if named => Err(Failure::input(
                "--runtime-path and --runtime-version name a dependency; add --runtime crate".to_string(),
            )),
            RuntimeSource::Shipped => Ok(Runtime::Shipped),
            RuntimeSource::Crate => Ok(Runtime::Crate(match (&self.runtime_path, &self.runtime_version) {
                (Some(path), _) => format!("{{ path = {} }}", quoted(path)),
                (None, version) => quoted(version.as_deref().unwrap_or(env!("CARGO_PKG_VERSION"))),
            })),
        }
    }

    /// Options that the command takes again to write the same crate.
    fn options(&self) -> String {
        let mut t = String::new();
        if self.adjoints {
            t += " --adjoints";
        }
        if self.runtime == RuntimeSource::Crate {
            t += " --runtime crate";
        }
        if let Some(path) = &self.runtime_path {
            t += &format!(" --runtime-path {path}");
        }
        if let Some(version) = &self.runtime_version {
            t += &format!(" --runtime-version {version}");
        }
        t
    }

    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let file = files::robot(&self.robot)?;
        files::check_outputs(&[("--json", &self.json)], &file.read)?;
        let further: &[Function] = if self.adjoints { &Function::ADJOINTS } else { &[] };
        let crate_files = dh_codegen::krate_on(&file.robot, &file.text, further, &self.runtime()?);
        let state = state(&self.out)?;
        if state == Folder::Foreign && !self.force {
            return Err(foreign(&self.out));
        }
        let stale = differing(&self.out, &crate_files);
        if self.check && !stale.is_empty() {
            let options = self.options();
            let again = format!("denavit generate {} --out {}{options}", self.robot.display(), self.out.display());
            return Err(Failure::other(format!(
                "stale in {}: {}; run `{again}`",
                self.out.display(),
                stale.join(", ")
            )));
        }
        if !self.check && !stale.is_empty() {
            match state {
                Folder::Absent => create(&self.out, &crate_files)?,
                _ => update(&self.out, &crate_files, &stale)?,
            }
        }
        if let Some(target) = &self.json {
            let value = serde_json::json!({ "out": self.out.display().to_string(), "files": crate_files.len(), "written": if self.check { vec![] } else { stale.clone() } });
            files::json(target, value, &provenance.robot(&self.robot, &file))?;
        }
        if !files::is_stdout(&self.json) {
            let what = if stale.is_empty() {
                "up to date".into()
            } else {
                format!("{} of {} files written", stale.len(), crate_files.len())
            };
            files::print(&format!("{}: {what}\n", self.out.display()))?;
        }
        Ok(())
    }
}

/// A string of a TOML file.
fn toml_string(text: &str) -> String {
    let escaped = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04x}", c as u32),
        c => c.to_string(),
    };
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}

/// What stands where the crate is to go.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Folder {
    Absent,
    Empty,
    /// Its `Cargo.toml` carries the generator's mark.
    Generated,
    Foreign,
}

fn state(out: &Path) -> Result<Folder, Failure> {
    let failed = |e: io::Error| Failure::input(format!("{} can't be used: {e}; name a folder", out.display()));
    let mut entries = match fs::read_dir(out) {
        Ok(entries) => entries,
        Err(e) if e.kind() == io::ErrorKind::NotFound && fs::symlink_metadata(out).is_err() => {
            return Ok(Folder::Absent);
        }
        Err(e) => return Err(failed(e)),
    };
    if entries.next().is_none() {
        return Ok(Folder::Empty);
    }
    let manifest = fs::read(out.join(MANIFEST)).unwrap_or_default();
    Ok(if manifest.starts_with(dh_codegen::MARK.as_bytes()) { Folder::Generated } else { Folder::Foreign })
}

fn foreign(out: &Path) -> Failure {
    let manifest = match out.join(MANIFEST).exists() {
        true => "its Cargo.toml was not written by `denavit generate`",
        false => "it has no Cargo.toml",
    };
    Failure::input(format!(
        "{} is not empty, and {manifest}; nothing was written. Name a new folder, or add --force to replace files of the same names",
        out.display()
    ))
}

/// Writes a new crate beside its place and moves it there, so that it is whole or absent.
fn create(out: &Path, crate_files: &BTreeMap<String, String>) -> Result<(), Failure> {
    let failed = |e: io::Error| Failure::other(format!("{} can't be written: {e}", out.display()));
    let mut name = out.file_name().unwrap_or_default().to_os_string();
    name.push(format!(".{}.partial", std::process::id()));
    let beside = out.with_file_name(name);
    let written = crate_files.iter().try_for_each(|(path, text)| write(&beside, path, text));
    written.and_then(|()| fs::rename(&beside, out).map_err(failed)).inspect_err(|_| {
        let _ = fs::remove_dir_all(&beside);
    })
}

/// Replaces what is stale. Until all is written the root of the crate is an error that says so:
/// files of two robots are never compiled together.
fn update(out: &Path, crate_files: &BTreeMap<String, String>, stale: &[&str]) -> Result<(), Failure> {
    let whole = |path: &str| write(out, path, &crate_files[path]);
    if stale.contains(&MANIFEST) {
        whole(MANIFEST)?;
    }
    if stale.iter().any(|path| ![MANIFEST, ROOT].contains(path)) {
        write(out, ROOT, UNFINISHED)?;
        stale.iter().filter(|path| ![MANIFEST, ROOT].contains(path)).try_for_each(|path| whole(path))?;
    }
    whole(ROOT)
}

fn write(folder: &Path, path: &str, text: &str) -> Result<(), Failure> {
    files::create_folder(folder, Path::new(path))?;
    files::write(&folder.join(path), text.as_bytes())
}

/// Files that are not on disk as they would be written.
fn differing<'a>(out: &Path, crate_files: &'a BTreeMap<String, String>) -> Vec<&'a str> {
    crate_files
        .iter()
        .filter(|(path, text)| std::fs::read(out.join(path)).ok().as_deref() != Some(text.as_bytes()))
        .map(|(path, _)| path.as_str())
        .collect()
}
