//! `denavit bundle` packs a run into one file; `denavit replay` repeats it.
//!
//! A run takes place in its own folder with copies of its inputs, under the paths that it has
//! there. Its results therefore contain no path of the machine, and have the same bits wherever
//! they are made again. The container is a zip, which holds the files unchanged and can be opened
//! with any tool.

mod archive;
mod inputs;
mod window;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use clap::Args;
use serde_json::{Value, json};

use super::Failure;
use super::files;
use super::provenance::sha256;
use archive::Archive;
use inputs::Inputs;
use window::Window;

/// Description of the run in the archive.
const MANIFEST: &str = "bundle.json";

/// Run a command and write everything that it was into one file: its inputs, options, version,
/// messages, exit status and results.
///
/// The file is a zip. It serves as a report of a fault, or as a record of a result:
/// `denavit replay FILE` runs the command again and compares the results bit by bit. Inputs are the
/// files that the command line names, and the tool files that a robot file names. The robot and the
/// log are in the file as they are; look into it before you send it to somebody.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit bundle report.zip --window 12,15 -- diagnose arm.yaml monday.csv --json d.json"
)]
pub(super) struct Bundle {
    /// Archive to write.
    archive: PathBuf,
    /// Only the rows of logs whose time lies between these two, in the unit of their column `t`.
    #[arg(long, value_name = "FROM,TO", allow_hyphen_values = true)]
    window: Option<Window>,
    /// Verb and arguments, as after `denavit`.
    #[arg(last = true, required = true, value_name = "COMMAND")]
    command: Vec<String>,
}

/// Run the command of a bundle again, and compare what it writes bit by bit.
///
/// Exit status 0: the same exit status, messages on standard error and bits; 1: other ones, which
/// are named. The time that a result took (`seconds` in JSON) and text for a reader on standard
/// output are not compared. `--out` keeps the inputs and what the run
/// wrote.
#[derive(Args)]
#[command(after_help = "Example:\n  denavit replay report.zip --out unpacked")]
pub(super) struct Replay {
    /// Archive that `denavit bundle` wrote.
    archive: PathBuf,
    /// Folder to unpack into and to run in; default: a temporary one.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Outcome of a run.
struct Ended {
    status: i32,
    /// Standard output and standard error.
    said: [Vec<u8>; 2],
}

/// Runs this program in a folder.
fn run(folder: &Path, words: &[String]) -> Result<Ended, Failure> {
    let failed = |e: std::io::Error| Failure::other(format!("the command can't be run: {e}"));
    let program = std::env::current_exe().map_err(failed)?;
    let child = Command::new(program).args(words).current_dir(folder).stdin(Stdio::null()).output().map_err(failed)?;
    // A run ended by a signal has no status.
    Ok(Ended { status: child.status.code().unwrap_or(-1), said: [child.stdout, child.stderr] })
}

fn temporary() -> Result<tempfile::TempDir, Failure> {
    tempfile::tempdir().map_err(|e| Failure::other(format!("no temporary folder can be made: {e}")))
}

impl Bundle {
    pub(super) fn run(self) -> Result<(), Failure> {
        if matches!(self.command[0].as_str(), "bundle" | "replay") {
            return Err(Failure::input(format!("{} can't be bundled; name the verb itself", self.command[0])));
        }
        let folder = temporary()?;
        let inputs = Inputs::collect(&self.command, folder.path(), self.window.as_ref())?;
        let paths: Vec<PathBuf> = inputs.files.iter().map(|(original, _)| original.clone()).collect();
        files::check_outputs(&[("bundle", &Some(self.archive.clone()))], &paths)?;
        let ended = run(folder.path(), &inputs.words)?;
        let mut archive = Archive::default();
        archive.add_folder(folder.path(), "inputs")?;
        archive.add_folder(folder.path(), "outputs")?;
        let [out, err] = ended.said;
        archive.add("stdout.txt", out);
        archive.add("stderr.txt", err);
        let originals = inputs.files.iter().map(|(original, held)| json!({ "file": held, "was": original }));
        let manifest = json!({
            "denavit": env!("CARGO_PKG_VERSION"),
            "command": inputs.words,
            "given": self.command,
            "window": self.window.as_ref().map(Window::text),
            "status": ended.status,
            "inputs": originals.collect::<Vec<_>>(),
            "sha256": archive.digests(),
        });
        let text = format!("{manifest:#}\n");
        archive.add(MANIFEST, text.into_bytes());
        files::write(&self.archive, &archive.pack()?)?;
        files::print(&format!(
            "ended with {}; {} inputs, {} results\nwrote {}\n",
            ended.status,
            archive.count("inputs/"),
            archive.count("outputs/"),
            self.archive.display()
        ))
    }
}

impl Replay {
    pub(super) fn run(self) -> Result<(), Failure> {
        let shown = self.archive.display().to_string();
        let archive = Archive::read(&self.archive)?;
        let bad = |what: &str| Failure::input(format!("{shown}: {what}; name a file that `denavit bundle` wrote"));
        let manifest: Value = archive
            .get(MANIFEST)
            .and_then(|text| serde_json::from_slice(text).ok())
            .ok_or_else(|| bad("there is no description of a run in it"))?;
        let words: Option<Vec<String>> =
            manifest["command"].as_array().map(|all| all.iter().filter_map(|w| w.as_str().map(String::from)).collect());
        let words = words.filter(|words| inputs::harmless(words)).ok_or_else(|| bad("its command is none"))?;
        if archive.digests() != manifest["sha256"] {
            return Err(bad("its files are not those that were written"));
        }
        let kept;
        let folder: &Path = match &self.out {
            Some(out) => {
                files::create_folder(out, Path::new("."))?;
                out
            }
            None => {
                kept = temporary()?;
                kept.path()
            }
        };
        archive.unpack("inputs/", folder)?;
        files::create_folder(folder, Path::new("outputs/x"))?;
        let ended = run(folder, &words)?;
        let mut again = Archive::default();
        again.add_folder(folder, "outputs")?;
        let [out, err] = ended.said;
        again.add("stdout.txt", out);
        again.add("stderr.txt", err);
        let mut differences = archive.differences(&again);
        if manifest["status"] != ended.status {
            differences.push(format!("it ended with {}, now with {}", manifest["status"], ended.status));
        }
        let version = manifest["denavit"].as_str().unwrap_or("?");
        let json = archive.get("stdout.txt").is_some_and(|text| serde_json::from_slice::<Value>(text).is_ok());
        let results = archive.count("outputs/") + usize::from(json);
        let plural = if results == 1 { "" } else { "s" };
        let of = format!("{results} result{plural} of `denavit {}`, version {version}", words.join(" "));
        match differences.is_empty() {
            true => files::print(&format!("the same exit status, messages and bits: {of}\n")),
            false => Err(Failure { status: 1, message: format!("{of}; not the same: {}", differences.join("; ")) }),
        }
    }
}

/// Digest of a result that two runs of the same command must share: JSON without its computing
/// time.
fn comparable(name: &str, bytes: &[u8]) -> String {
    if let Ok(mut value) = serde_json::from_slice::<Value>(bytes) {
        if let Some(fields) = value.as_object_mut() {
            fields.remove("seconds");
        }
        return sha256(value.to_string().as_bytes());
    }
    // Text for readers may contain the computing time.
    if name == "stdout.txt" { String::new() } else { sha256(bytes) }
}
