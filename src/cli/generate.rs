//! `denavit generate`: writes the drop-in crate, or checks whether the one on disk is stale.

mod folder;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use dh_codegen::Runtime;
use dh_codegen::arm::Function;

use self::folder::{Folder, Stale};
use super::Failure;
use super::delivery::deliver;
use super::files;
use super::motors;
use super::provenance::Provenance;
use super::terminal::say;

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
    /// Only files of the crate are written, and those of an earlier run that it no longer has are
    /// removed.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Derivatives too: of the regressors, the torques and the frames, as products with the
    /// transposed Jacobian (`base_regressor_adjoint` and so on).
    #[arg(long)]
    adjoints: bool,
    /// Source of the crate's runtime: a copy inside it, or the crate denavit-runtime.
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

/// Whether cargo accepts this as a version requirement: comparators of up to three numbers,
/// separated by commas.
fn is_requirement(text: &str) -> bool {
    let number = |part: &str| {
        matches!(part, "*" | "x" | "X")
            || (!part.is_empty() && part.len() < 20 && part.bytes().all(|b| b.is_ascii_digit()))
    };
    let comparator = |text: &str| {
        let version = text.trim().trim_start_matches(['=', '^', '~', '>', '<']).trim_start();
        let numbers = version.split(['-', '+']).next().unwrap_or_default();
        (1..=3).contains(&numbers.split('.').count()) && numbers.split('.').all(number)
    };
    text.split(',').all(comparator)
}

impl Generate {
    /// Runtime of the crate, as the generator expects it.
    fn runtime(&self) -> Result<Runtime, Failure> {
        let quoted = |text: &str| toml_string(text);
        let named = self.runtime_path.is_some() || self.runtime_version.is_some();
        match self.runtime {
            RuntimeSource::Shipped if named => Err(Failure::input(
                "--runtime-path and --runtime-version name a dependency; add --runtime crate".to_string(),
            )),
            RuntimeSource::Shipped => Ok(Runtime::Shipped),
            RuntimeSource::Crate if !self.runtime_version.as_deref().is_none_or(is_requirement) => {
                let given = self.runtime_version.as_deref().unwrap_or_default();
                Err(Failure::input(format!(
                    "--runtime-version {given}: no version of a crate; give one as 0.1 or =0.1.2"
                )))
            }
            RuntimeSource::Crate => Ok(Runtime::Crate(match (&self.runtime_path, &self.runtime_version) {
                (Some(path), _) => format!("{{ path = {} }}", quoted(path)),
                (None, version) => quoted(version.as_deref().unwrap_or(env!("CARGO_PKG_VERSION"))),
            })),
        }
    }

    /// Options that reproduce the same crate.
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
        motors::note(&self.robot, &file.robot);
        let further: &[Function] = if self.adjoints { &Function::ADJOINTS } else { &[] };
        let crate_files = dh_codegen::krate_on(&file.robot, &file.text, further, &self.runtime()?);
        if let Some(path) = self.runtime_path.as_ref().filter(|path| !self.out.join(path).join("Cargo.toml").exists()) {
            // The folder may be created later.
            let seen = self.out.join(path);
            say(&format!(
                "note: --runtime-path: there is no crate in {} yet; the generated crate needs it",
                seen.display()
            ));
        }
        let there = Folder::at(&self.out)?;
        if there == Folder::Foreign && !self.force {
            return Err(folder::foreign(&self.out));
        }
        let stale = Stale::of(&self.out, &crate_files);
        if self.check && !stale.is_empty() {
            return Err(self.outdated(&stale));
        }
        if !stale.is_empty() {
            match there {
                Folder::Absent => folder::create(&self.out, &crate_files)?,
                _ => folder::update(&self.out, there, &crate_files, &stale)?,
            }
        }
        let json = || serde_json::json!({ "out": self.out.display().to_string(), "files": crate_files.len(), "written": stale.written, "removed": stale.removed });
        deliver(&provenance.robot(&self.robot, &file)).json(self.json.as_ref(), json)?.text(|| {
            let removed = match stale.removed.len() {
                0 => String::new(),
                n => format!(", {n} of an earlier run removed"),
            };
            let what = match stale.is_empty() {
                true => "up to date".into(),
                false => format!("{} of {} files written{removed}", stale.written.len(), crate_files.len()),
            };
            format!("{}: {what}\n", self.out.display())
        })
    }

    /// Failure of a check: the files that would change, and the command to write them.
    fn outdated(&self, stale: &Stale) -> Failure {
        let out = self.out.display();
        let removed = stale.removed.iter().map(|path| format!("{path} (no longer written)"));
        let all: Vec<String> = stale.written.iter().cloned().chain(removed).collect();
        let again = format!("denavit generate {} --out {out}{}", self.robot.display(), self.options());
        Failure::other(format!("stale in {out}: {}; run `{again}`", all.join(", ")))
    }
}

/// A quoted string for a TOML file.
fn toml_string(text: &str) -> String {
    let escaped = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04x}", c as u32),
        c => c.to_string(),
    };
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}
