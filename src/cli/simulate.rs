//! `denavit simulate`: plays a motion on the simulated robot and records a log.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::{Args, ValueEnum};
use dh_codegen::robot::{Effect, Inertia, Robot};
use flate2::Compression;
use flate2::write::GzEncoder;
use indicatif::{ProgressBar, ProgressStyle};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::provenance::Provenance;
use super::table::Table;
use super::terminal;
use crate::data::log::csv;
use crate::report;
use crate::simulate;
use crate::simulate::{Mode, Recording, Request, SimulateError, SimulationFile, Simulator, Trajectory};

/// Play a motion on the simulated robot and record a log.
///
/// The trajectory has columns `t, q1..` and, where they are known, `dq1..` and `ddq1..` (quintics
/// between the rows; what is missing comes from splines), or is a file of coefficients. The bodies
/// are those of the robot file, the drives those of the file and of `--effects`. A loop makes the
/// arm follow, and sensors of 1 kHz record `t, q1.., tau1.., qd1..`. docs/simulate.md shows every
/// effect.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit simulate robots/kuka-lwr4.yaml --trajectory motion.csv --out log.csv \\\n      --effects effects.yaml --seed 1\nwhere effects.yaml may hold\n  joints:\n    3: { stribeck_friction: { FS: 4.1, VS: 0.08 }, backlash: {} }\n  effects: { base_tilt: { roll: 0.5deg } }\n  sensors: { rate: 1000, torque_noise: 0.05 }"
)]
pub(super) struct Simulate {
    /// Robot file; every link's inertial parameters must be in it.
    robot: PathBuf,
    /// The motion: CSV with a header, or the coefficients (.json) that `excite --coefficients`
    /// writes.
    #[arg(long, value_name = "FILE", required_unless_present = "free")]
    trajectory: Option<PathBuf>,
    /// Path of the log: .csv or .csv.gz.
    #[arg(long, value_name = "LOG")]
    out: PathBuf,
    /// Effects, sensors, control and solver.
    #[arg(long, value_name = "YAML")]
    effects: Option<PathBuf>,
    /// Of the noise: the same seed gives the same bytes.
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Control of the arm; the effects file may set it too.
    #[arg(long, value_enum)]
    control: Option<ControlMode>,
    /// No torque: a swing of so many seconds from rest, from the trajectory's first row or from
    /// --start.
    #[arg(long, value_name = "SECONDS", conflicts_with = "control")]
    free: Option<f64>,
    /// Start of a free swing: q1,q2,.. in rad.
    #[arg(long, value_name = "Q", value_delimiter = ',', allow_hyphen_values = true, requires = "free")]
    start: Option<Vec<f64>>,
    /// Write the figures of the run as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum ControlMode {
    /// Feedforward of the file's model and feedback.
    Position,
    /// Gravity of the file's model and feedback.
    Pd,
    /// The trajectory's tau columns.
    Torque,
    /// None: the motion is followed exactly, and torques follow from the laws.
    Exact,
}

/// Longest simulation of a free motion, s.
const LONGEST: f64 = 1e5;

impl Simulate {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let name = self.out.to_string_lossy().to_lowercase();
        if !name.ends_with(".csv") && !name.ends_with(".csv.gz") {
            let shown = self.out.display();
            return Err(Failure::input(format!(
                "--out {shown}: logs are written as .csv or .csv.gz; choose such a name"
            )));
        }
        let file = files::robot(&self.robot)?;
        let inputs = file.read.iter().chain(&self.trajectory).chain(&self.effects);
        files::check_outputs(&[("--out", &Some(self.out.clone())), ("--json", &self.json)], inputs)?;
        provenance.refuse_idle(&[("--trajectory", self.start.is_none(), "--start says where the swing begins")])?;
        let mut warnings = report::Warnings::default();
        let given = match &self.effects {
            Some(path) => effects(path, &file.robot, &mut warnings)?,
            None => SimulationFile::default(),
        };
        let mut request = Request { seed: self.seed, ..Request::default() };
        given.apply(&mut request);
        if let Some(mode) = self.control {
            request.control.mode = match mode {
                ControlMode::Position => Mode::Position,
                ControlMode::Pd => Mode::Pd,
                ControlMode::Torque => Mode::Torque,
                ControlMode::Exact => Mode::Exact,
            };
        }
        if self.free.is_some() {
            request.control.mode = Mode::Free;
        }
        let trajectory = self.trajectory(file.robot.dof(), request.control.mode)?;
        let motion = self.trajectory.as_ref().map_or("denavit".to_string(), |path| path.display().to_string());
        for doubt in simulate::motion_warnings(&trajectory, &file.robot) {
            terminal::warn(&mut warnings, &motion, &doubt);
        }
        let simulator = Simulator::new(&file.robot, &given.effects).map_err(|e| self.failed(e))?;

        let span = trajectory.span();
        let bar = bar();
        let begin = Instant::now();
        let recording = simulator
            .run(&trajectory, &request, &mut |t| {
                bar.set_position((1000.0 * (t - span.start) / (span.end - span.start)) as u64);
                bar.set_message(format!("{:.1} of {:.1} s", t - span.start, span.end - span.start));
            })
            .map_err(|e| self.failed(e))?;
        let seconds = begin.elapsed().as_secs_f64();
        bar.finish_and_clear();

        self.write(&recording)?;
        let provenance = provenance.robot(&self.robot, &file);
        let mut out = deliver(&provenance);
        out.wrote(&self.out);
        let name = &file.robot.name;
        out.json(self.json.as_ref(), || report::simulate_json(name, &recording, &request, &warnings))?
            .text(|| report::simulate_text(name, &recording, &request, seconds, &warnings))
    }

    fn trajectory(&self, n: usize, mode: Mode) -> Result<Trajectory, Failure> {
        if let Some(duration) = self.free.filter(|d| !(*d > 0.0 && *d <= LONGEST)) {
            return Err(Failure::input(format!("--free {duration}: seconds, more than 0 and at most {LONGEST}")));
        }
        if let (Some(start), Some(duration)) = (&self.start, self.free) {
            if start.len() != n {
                return Err(Failure::input(format!("--start has {} values; the robot has {n} joints", start.len())));
            }
            if let Some(q) = start.iter().find(|q| !q.is_finite()) {
                return Err(Failure::input(format!("--start has a value {q}; write finite numbers, rad or m")));
            }
            return Trajectory::rest(start, duration).map_err(Failure::input);
        }
        let Some(path) = &self.trajectory else {
            return Err(Failure::input("--free takes its start from --start q1,q2,.. or from --trajectory FILE"));
        };
        let shown = path.display();
        if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("json")) {
            return self.coefficients(path, n, mode);
        }
        let table = Table::read(path)?;
        let found = table.count("q");
        if found == 0 {
            table.column("q1")?;
        }
        if found != n {
            let error = SimulateError::Joints { found, expected: n };
            return Err(Failure::input(format!("{shown}: {error}")));
        }
        let t = table.column("t")?.to_vec();
        let q = table.joints("q", n)?;
        if let Some(duration) = self.free {
            if t.is_empty() {
                return Err(Failure::input(format!("{shown} has no rows; write where the swing starts")));
            }
            let first: Vec<f64> = (0..n).map(|j| q[j * t.len()]).collect();
            return Trajectory::rest(&first, duration).map_err(Failure::input);
        }
        // If one column of a kind is present, all of them are required.
        let optional = |prefix: &str| -> Result<Option<Vec<f64>>, Failure> {
            let some = (1..=n).any(|j| table.has(&format!("{prefix}{j}")));
            some.then(|| table.joints(prefix, n)).transpose()
        };
        let tau = if mode == Mode::Torque { optional("tau")? } else { None };
        let made = Trajectory::new(n, t, q, optional("dq")?, optional("ddq")?);
        let made = made.and_then(|m| if let Some(tau) = tau { m.with_torques(tau) } else { Ok(m) });
        made.map_err(|e| Failure::input(format!("{shown}: {e}")))
    }

    /// Reads the output of `excite --coefficients`.
    fn coefficients(&self, path: &Path, n: usize, mode: Mode) -> Result<Trajectory, Failure> {
        let shown = path.display();
        let bad = |what: String| Failure::input(format!("{shown}: {what}"));
        let value = serde_json::from_str(&files::text(path)?).map_err(|e| bad(format!("not JSON: {e}")))?;
        let mend = "a motion in JSON is what `denavit excite --coefficients` writes; else give a CSV";
        let motion = report::trajectory_of_json(&value).map_err(|e| bad(format!("{e}; {mend}")))?;
        if motion.dof() != n {
            return Err(bad(SimulateError::Joints { found: motion.dof(), expected: n }.to_string()));
        }
        if mode == Mode::Torque {
            return Err(bad("coefficients have no torques to play; give a CSV with tau1..".into()));
        }
        match self.free {
            Some(duration) => Trajectory::rest(&motion.at(0.0).q, duration),
            None => Trajectory::of_motion(&motion),
        }
        .map_err(|e| bad(e.to_string()))
    }

    fn failed(&self, error: SimulateError) -> Failure {
        let robot = self.robot.display();
        let place = match (&error, &self.effects) {
            (SimulateError::NoLinks { .. }, _) | (_, None) => robot.to_string(),
            (SimulateError::Integration(_), Some(effects)) => format!("{robot} with {}", effects.display()),
            (_, Some(effects)) => effects.display().to_string(),
        };
        Failure::input(format!("{place}: {error}"))
    }

    fn write(&self, recording: &Recording) -> Result<(), Failure> {
        let name = self.out.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
        files::stream(&self.out, |output| {
            if !name.ends_with(".gz") {
                return csv::write(&recording.log, output);
            }
            let mut packer = GzEncoder::new(output, Compression::default());
            csv::write(&recording.log, &mut packer)?;
            packer.finish().map(|_| ())
        })
    }
}

/// A progress bar, hidden without a terminal.
fn bar() -> ProgressBar {
    let bar = if std::io::stderr().is_terminal() { ProgressBar::new(1000) } else { ProgressBar::hidden() };
    if let Ok(style) = ProgressStyle::with_template("simulating [{bar:30}] {msg} {eta}") {
        bar.set_style(style);
    }
    bar
}

/// Reads an effects file; its notes become warnings.
pub(in crate::cli) fn effects(
    path: &Path,
    robot: &Robot,
    warnings: &mut report::Warnings,
) -> Result<SimulationFile, Failure> {
    let shown = path.display().to_string();
    let file = SimulationFile::from_yaml(&files::text(path)?, robot)
        .map_err(|problems| Failure::input(format!("{shown} can't be used:\n{}", problems.in_file(&shown))))?;
    file.notes.iter().for_each(|note| terminal::warn(warnings, &shown, &note.to_string()));
    for effect in &file.effects.robot {
        if let Effect::Payload(payload) = effect
            && !payload.is_point()
            && let Err(why) = Inertia::from_array(payload.body()).physical()
        {
            terminal::warn(warnings, &shown, &format!("payload: no body has these ten parameters: {why}"));
        }
    }
    Ok(file)
}
