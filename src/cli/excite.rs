//! `denavit excite`: designs the motion that is most informative about the parameters within all
//! limits, or checks one.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::interrupt;
use super::motors;
use super::provenance::Provenance;
use super::terminal;
use crate::excite::check::check;
use crate::excite::{
    Criterion, Curve, Design, Effort, Expected, FrictionCoverage, Progress, ShortestError, Task, Watch, design,
    expected, known_from, known_values, nominal, shortest,
};
use crate::model::differentiated::Differentiated;
use crate::model::{Arm, DriveTerm, States};
use crate::report;
use dh_codegen::robot::Robot;

/// Design the motion from which the parameters are identified best, inside every limit of the robot
/// file.
///
/// Joints move along clamped quintic splines with a way point every second, from rest to rest.
/// Limits of position, velocity and acceleration hold between the samples too; torque (from the
/// file's links), ground, spheres and boxes (`collision`) are checked at 500 Hz. The same robot,
/// options and seed give the same motion.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit excite robots/kuka-lwr4.yaml --duration 10 --criterion logdet --out motion.csv --report motion.html\n\nCtrl-C stops early and writes the best feasible motion so far."
)]
pub(super) struct Excite {
    /// Robot file.
    robot: PathBuf,
    /// Check this motion instead of designing one: CSV with t, q.. and, if there, dq.., ddq... Exit
    /// status 1 where a limit is broken.
    #[arg(long, value_name = "CSV")]
    check: Option<PathBuf>,
    /// Length of the motion, s (of one period with --fourier).
    #[arg(long, default_value_t = 10.0, value_name = "SECONDS")]
    duration: f64,
    /// Criterion to minimise: condition number, -log det, Hadamard's bound (the paper's equation
    /// 9), sum of variances, largest variance.
    #[arg(long, value_enum, default_value_t = Which::Logdet)]
    criterion: Which,
    /// Motion to write: CSV with t, q.., dq.., ddq...
    #[arg(long, value_name = "CSV")]
    out: Option<PathBuf>,
    /// Samples per second of the written motion.
    #[arg(long, default_value_t = 100.0, value_name = "HZ")]
    rate: f64,
    /// Spline coefficients (JSON), for the simulator and for other rates.
    #[arg(long, value_name = "FILE")]
    coefficients: Option<PathBuf>,
    /// ROS `JointTrajectory` message (YAML).
    #[arg(long, value_name = "FILE")]
    ros: Option<PathBuf>,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a page with curves, limits, history and the moving arm.
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    /// Time between way points, s.
    #[arg(long, default_value_t = 1.0, value_name = "SECONDS")]
    spacing: f64,
    /// Fourier series with so many harmonics instead of a spline.
    #[arg(long, value_name = "HARMONICS")]
    fourier: Option<usize>,
    /// Periods of a Fourier series that are played.
    #[arg(long, default_value_t = 3)]
    periods: usize,
    /// Random motions to begin with.
    #[arg(long, default_value_t = 24)]
    starts: usize,
    /// Seed of the random motions.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Steps of the solver per start, at most.
    #[arg(long, default_value_t = 60)]
    iterations: usize,
    /// Threads; default: all cores. The result does not depend on it.
    #[arg(long)]
    threads: Option<usize>,
    /// Stop after this time with the best so far (then the result depends on the machine), s.
    #[arg(long, value_name = "SECONDS")]
    time_limit: Option<f64>,
    /// Leave the columns of drives out of the criterion: friction, rotor inertia, offsets.
    #[arg(long)]
    links_only: bool,
    /// Only the ten parameters of a body in the tool frame, the robot itself being known.
    #[arg(long)]
    tool: bool,
    /// Include richer friction laws: low and high speeds in both directions.
    #[arg(long)]
    friction: bool,
    /// Standard deviation of the torque noise per joint, N m, after the low-pass (`identify` prints
    /// it); one number for all, or one per joint. Weighs the joints; default: all the same, and for
    /// what is expected half a percent of the torque limit.
    #[arg(long, value_delimiter = ',', value_name = "NM")]
    noise: Vec<f64>,
    /// The given --noise is that of the sensors, white, in logs of so many samples per second.
    #[arg(long, value_name = "HZ", requires = "noise")]
    log_rate: Option<f64>,
    /// Cut-off of the low-pass that logs will go through, Hz: noise has at most two independent
    /// values per period of it.
    #[arg(long, default_value_t = 10.0, value_name = "HZ")]
    cutoff: f64,
    /// Motions that were played before (CSV): this one complements them.
    #[arg(long, num_args = 1.., value_name = "CSV")]
    known: Vec<PathBuf>,
    /// The file's parameters are known to this share of themselves, percent.
    #[arg(long, value_name = "PERCENT")]
    known_std: Option<f64>,
    /// Find the shortest motion, of at most --duration, after which every essential parameter has
    /// this relative standard deviation, percent.
    #[arg(long, value_name = "PERCENT", conflicts_with = "fourier")]
    target_std: Option<f64>,
    /// Time in which a joint without `acceleration` limit may reach its speed, s.
    #[arg(long, default_value_t = 0.5, value_name = "SECONDS")]
    acceleration_time: f64,
    /// Share of velocity, acceleration and jerk limits to use, percent.
    #[arg(long, default_value_t = 100.0, value_name = "PERCENT")]
    speed: f64,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Which {
    Cond,
    Logdet,
    Hadamard,
    Trace,
    Smallest,
}

impl Which {
    fn criterion(self) -> Criterion {
        match self {
            Self::Cond => Criterion::Condition,
            Self::Logdet => Criterion::LogDet,
            Self::Hadamard => Criterion::Hadamard,
            Self::Trace => Criterion::Trace,
            Self::Smallest => Criterion::Smallest,
        }
    }
}

impl Excite {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        self.validate()?;
        self.refuse_idle(&provenance)?;
        let file = files::robot(&self.robot)?;
        motors::on_every_joint(&self.robot, &file.robot, "an exciting motion drives every joint")?;
        files::check_outputs(
            &[
                ("--out", &self.out),
                ("--coefficients", &self.coefficients),
                ("--ros", &self.ros),
                ("--report", &self.report),
                ("--json", &self.json),
            ],
            file.read.iter().chain(&self.check).chain(&self.known),
        )?;
        let provenance = provenance.robot(&self.robot, &file);
        if let Some(path) = &self.check {
            return self.judge(path, &file.robot, &provenance);
        }
        let arm = Differentiated::new(&file.robot);
        let begun = Instant::now();
        let coverage;
        let mut task = Task::new(&arm, &file.robot, self.duration, self.acceleration_time)
            .map_err(|e| Failure::input(format!("{}: {e}", self.robot.display())))?;
        task.criterion = self.criterion.criterion();
        task.curve = self.curve()?;
        task.rate = CRITERION_RATE;
        task.share = self.speed / 100.0;
        self.check_links_only(&arm)?;
        if self.links_only || self.tool {
            task.links_only();
        }
        if self.tool {
            task.tool_only();
        }
        if self.friction {
            let has_offset = arm.base_parameters().iter().any(|b| b.is_drive_term(DriveTerm::FO));
            coverage = FrictionCoverage::new(&task.limits.iter().map(|l| l.velocity).collect::<Vec<_>>(), !has_offset);
            task.extra = Some(&coverage);
        }
        self.know(&mut task)?;
        let mut warnings = report::Warnings::default();
        for line in report::missing_text(&task.missing) {
            terminal::warn(&mut warnings, &self.robot.display().to_string(), &line);
        }
        let (found, expected, tried) = self.search(&task)?;
        let seconds = begun.elapsed().as_secs_f64();
        if !found.feasible {
            let broken: Vec<String> = found
                .closest
                .iter()
                .filter(|w| w.excess > 0.0)
                .map(|w| format!("{} at {:.2} s", w.what, w.time))
                .collect();
            if !found.stopped || self.out.is_none() {
                return Err(Failure::other(format!(
                    "no motion inside all limits was found; closest to it: {}; give it more --starts or --iterations, a longer --duration, a lower --speed",
                    broken.join("; ")
                )));
            }
            return Err(Failure::other(format!(
                "stopped before any motion inside all limits was found: {}",
                broken.join("; ")
            )));
        }
        let outcome = report::Outcome {
            task: &task,
            found: &found,
            expected: &expected,
            tried: &tried,
            seconds,
            warnings: &warnings,
        };
        self.deliver(&outcome, &provenance)
    }

    fn deliver(&self, outcome: &report::Outcome<'_>, provenance: &Provenance) -> Result<(), Failure> {
        let motion = &outcome.found.trajectory;
        let names = || outcome.task.limits.iter().map(|l| l.name.clone()).collect::<Vec<String>>();
        deliver(provenance)
            .file(self.out.as_ref(), || report::motion_csv(motion, self.rate))?
            .file(self.coefficients.as_ref(), || format!("{:#}\n", report::trajectory_json(motion)))?
            .file(self.ros.as_ref(), || report::joint_trajectory(motion, &names(), self.rate))?
            .file(self.report.as_ref(), || report::excite_html(outcome, &provenance.rows()))?
            .json(self.json.as_ref(), || report::excite_json(outcome))?
            .text(|| report::excite_text(outcome))
    }

    fn judge(&self, path: &Path, robot: &Robot, provenance: &Provenance) -> Result<(), Failure> {
        let written = super::motion::read(path, robot.dof())?;
        let verdict = check(robot, &written, Some(self.acceleration_time))
            .map_err(|e| Failure::input(format!("{}: {e}", path.display())))?;
        deliver(provenance)
            .json(self.json.as_ref(), || report::motion_check_json(&verdict))?
            .text(|| report::motion_check_text(&verdict))?;
        let broken: Vec<String> = verdict
            .findings
            .iter()
            .filter(|f| f.broken)
            .map(|f| {
                format!("{} of {} at {:.3} s ({:.5} where {:.5} is allowed)", f.kind, f.who, f.time, f.value, f.limit)
            })
            .collect();
        if broken.is_empty() {
            return Ok(());
        }
        let (count, s) = (broken.len(), if broken.len() == 1 { "" } else { "s" });
        Err(Failure::other(format!("{} breaks {count} limit{s}: {}", path.display(), broken.join("; "))))
    }

    fn check_links_only(&self, arm: &dyn Arm) -> Result<(), Failure> {
        match self.links_only && !arm.base_parameters().iter().any(|b| b.leader.is_drive()) {
            true => Err(Failure::input(format!(
                "--links-only: {} has no column of a drive that could be left out; leave the option out",
                self.robot.display()
            ))),
            false => Ok(()),
        }
    }

    /// Refuses options that have no effect with the others.
    fn refuse_idle(&self, provenance: &Provenance) -> Result<(), Failure> {
        const DESIGN: [&str; 24] = [
            "--duration",
            "--criterion",
            "--out",
            "--rate",
            "--coefficients",
            "--ros",
            "--report",
            "--spacing",
            "--fourier",
            "--periods",
            "--starts",
            "--seed",
            "--iterations",
            "--threads",
            "--time-limit",
            "--links-only",
            "--tool",
            "--friction",
            "--noise",
            "--cutoff",
            "--known",
            "--known-std",
            "--target-std",
            "--speed",
        ];
        let designs = self.check.is_none();
        provenance.refuse_idle(&DESIGN.map(|option| (option, designs, "--check judges a motion and designs none")))?;
        provenance.refuse_idle(&[
            ("--rate", self.out.is_some() || self.ros.is_some(), "it is that of --out and --ros"),
            ("--periods", self.fourier.is_some(), "it is that of a Fourier series (--fourier)"),
            ("--spacing", self.fourier.is_none(), "a Fourier series has no way points"),
            (
                "--cutoff",
                self.log_rate.is_none(),
                "with --log-rate the noise is white, and the number of samples counts",
            ),
            ("--links-only", !self.tool, "--tool leaves the columns of drives out already"),
        ])
    }

    fn validate(&self) -> Result<(), Failure> {
        let positive = [
            ("--duration", self.duration, 0.2, 600.0),
            ("--rate", self.rate, 1.0, 10_000.0),
            ("--spacing", self.spacing, 0.05, 60.0),
            ("--acceleration-time", self.acceleration_time, 1e-3, 100.0),
            ("--speed", self.speed, 1.0, 100.0),
            ("--cutoff", self.cutoff, 0.01, 1e5),
            ("--log-rate", self.log_rate.unwrap_or(1000.0), 1.0, 1e6),
            ("--time-limit", self.time_limit.unwrap_or(1.0), 0.0, 1e6),
        ];
        for (name, value, low, high) in positive {
            if !(low..=high).contains(&value) {
                return Err(Failure::input(format!("{name} {value}: from {low} to {high}")));
            }
        }
        let counts = [
            ("--starts", self.starts, 1, 10_000),
            ("--iterations", self.iterations, 1, 100_000),
            ("--periods", self.periods, 1, 1000),
            ("--threads", self.threads.unwrap_or(1), 1, 1024),
            ("--fourier", self.fourier.unwrap_or(2), 2, 50),
        ];
        for (name, value, low, high) in counts {
            if !(low..=high).contains(&value) {
                return Err(Failure::input(format!("{name} {value}: from {low} to {high}")));
            }
        }
        if self.fourier.is_none() && self.spacing > self.duration && self.spacing != 1.0 {
            return Err(Failure::input(format!(
                "--spacing {} is longer than the motion of {} s; give less",
                self.spacing, self.duration
            )));
        }
        if self.duration / self.spacing > 100.0 {
            return Err(Failure::input(format!(
                "--duration {} with --spacing {} makes more than 100 way points; use a wider spacing",
                self.duration, self.spacing
            )));
        }
        Ok(())
    }

    fn curve(&self) -> Result<Curve, Failure> {
        Ok(match self.fourier {
            Some(harmonics) => Curve::Fourier { period: self.duration, harmonics, periods: self.periods },
            None => Curve::Spline {
                duration: self.duration,
                intervals: ((self.duration / self.spacing).round() as usize).max(1),
            },
        })
    }

    /// Sets noise and prior knowledge. If neither is given, the criterion is plain equation (9).
    fn know(&self, task: &mut Task<'_>) -> Result<(), Failure> {
        let dof = task.dof();
        let share = |name: &str, value: Option<f64>| match value {
            Some(p) if !(p > 0.0 && p <= 1e4) => {
                Err(Failure::input(format!("{name} {p}: a share in percent, over zero")))
            }
            other => Ok(other.map(|p| p / 100.0)),
        };
        let known_std = share("--known-std", self.known_std)?;
        share("--target-std", self.target_std)?;
        let given = self.noises(dof)?;
        if self.target_std.is_some() && nominal(task).is_none_or(|values| values.is_empty()) {
            return Err(no_nominal("--target-std", self.tool));
        }
        if self.noise.is_empty() && self.known.is_empty() && known_std.is_none() && self.target_std.is_none() {
            return Ok(());
        }
        let noise = if self.noise.is_empty() { assumed_noise(task) } else { given };
        task.noise = self.per_sample(noise);
        if !self.known.is_empty() {
            let played: Vec<States> = self.known.iter().map(|path| states_of(path, dof)).collect::<Result<_, _>>()?;
            task.prior = Some(known_from(task, &played));
        }
        if let Some(share) = known_std {
            let values = known_values(task, share).ok_or_else(|| no_nominal("--known-std", self.tool))?;
            task.prior = Some(task.prior.take().map_or(values.clone(), |p| p + values));
        }
        Ok(())
    }

    /// Noise of independent samples with the same information. After a low-pass, noise of
    /// successive samples is correlated, which is equivalent to larger independent noise. With
    /// white noise, a higher sampling rate reduces its effect.
    fn per_sample(&self, noise: Vec<f64>) -> Vec<f64> {
        let independent = self.log_rate.unwrap_or((2.0 * self.cutoff).min(CRITERION_RATE));
        noise.into_iter().map(|s| s * (CRITERION_RATE / independent).sqrt()).collect()
    }

    fn noises(&self, dof: usize) -> Result<Vec<f64>, Failure> {
        if let Some(bad) = self.noise.iter().find(|s| !(**s > 0.0 && s.is_finite())) {
            return Err(Failure::input(format!("--noise {bad}: a standard deviation is positive, N m")));
        }
        match self.noise.len() {
            0 => Ok(vec![1.0; dof]),
            1 => Ok(vec![self.noise[0]; dof]),
            n if n == dof => Ok(self.noise.clone()),
            n => Err(Failure::input(format!("--noise has {n} numbers; give one, or one per joint ({dof})"))),
        }
    }

    /// Runs the designer with a progress bar, Ctrl-C and the time limit.
    fn search(&self, task: &Task<'_>) -> Result<Found, Failure> {
        let effort = Effort {
            starts: self.starts,
            seed: self.seed,
            iterations: self.iterations,
            threads: self.threads.unwrap_or(Effort::default().threads),
            ..Effort::default()
        };
        let stop = Arc::new(AtomicBool::new(false));
        interrupt::stop_on_interrupt(&stop);
        let bar = ProgressBar::new(1);
        if let Ok(style) = ProgressStyle::with_template("{bar:30} {percent}% {msg} {eta} left") {
            bar.set_style(style);
        }
        let begun = Instant::now();
        let limit = self.time_limit.map(Duration::from_secs_f64);
        let unit = if matches!(task.criterion, Criterion::LogDet | Criterion::Hadamard) {
            task.columns().count() as f64
        } else {
            1.0
        };
        let exponential = matches!(task.criterion, Criterion::Condition | Criterion::Trace | Criterion::Smallest);
        let name = task.criterion.name();
        let progress = |p: &Progress| {
            bar.set_length(p.total as u64);
            bar.set_position(p.done as u64);
            let best =
                p.best.map_or("-".to_string(), |b| format!("{:.2}", if exponential { b.exp() } else { b * unit }));
            bar.set_message(format!("{name} {best}, worst constraint {:+.3}", p.worst));
            if limit.is_some_and(|l| begun.elapsed() > l) {
                stop.store(true, Ordering::Relaxed);
            }
        };
        let watch = Watch { stop: &stop, progress: &progress };
        let found = match self.target_std {
            Some(percent) => shortest(task, percent, &effort, &watch).map(|s| (s.design, s.expected, s.tried)),
            None => design(task, &effort, &watch)
                .map(|found| {
                    let noise = if task.noise.iter().all(|s| *s == 1.0) {
                        self.per_sample(assumed_noise(task))
                    } else {
                        task.noise.clone()
                    };
                    let own = Task { noise, ..task.clone() };
                    let expected = expected(&own, &found.trajectory.sampled(task.rate).1);
                    (found, expected, Vec::new())
                })
                .map_err(ShortestError::from),
        };
        bar.finish_and_clear();
        found.map_err(|e| Failure::other(format!("{}: {e}", self.robot.display())))
    }
}

/// A design, its expected precision, and the durations tried.
type Found = (Design, Vec<Expected>, Vec<(f64, Option<f64>)>);

/// Failure for a relative target without nominal values.
fn no_nominal(option: &str, tool: bool) -> Failure {
    Failure::input(if tool {
        format!("{option}: the robot file has no body in the hand; write its nominal `M`, `MS` and `I` under `tool`")
    } else {
        format!("{option}: the robot file has no inertial parameters of all links; write nominal ones under `links`")
    })
}

/// Sampling rate of the criterion, Hz, as in the paper.
const CRITERION_RATE: f64 = 100.0;

/// Default noise, N m: half a percent of the torque limit, or 0.1 N m without a limit.
fn assumed_noise(task: &Task<'_>) -> Vec<f64> {
    task.limits.iter().map(|l| l.torque.map_or(0.1, |t| 0.005 * t)).collect()
}

/// States of a motion already played, at the criterion's rate.
fn states_of(path: &Path, dof: usize) -> Result<States, Failure> {
    let motion = super::motion::read(path, dof)?;
    let bad = |what: &str| Failure::input(format!("{}: {what}", path.display()));
    if motion.dq.is_empty() || motion.ddq.is_empty() {
        return Err(bad("a played motion needs the columns dq1.. and ddq1.., as `excite --out` writes them"));
    }
    let end = motion.t.last().copied().unwrap_or(0.0) - motion.t.first().copied().unwrap_or(0.0);
    if motion.t.len() < 2 || end <= 0.0 {
        return Err(bad("there is no motion in it"));
    }
    // The row nearest to each instant.
    let start = motion.t[0];
    let rows: Vec<usize> = (0..=(end * CRITERION_RATE).floor() as usize)
        .map(|k| {
            let t = start + k as f64 / CRITERION_RATE;
            let after = motion.t.partition_point(|x| *x < t).min(motion.t.len() - 1);
            let before = after.saturating_sub(1);
            if (motion.t[after] - t).abs() < (t - motion.t[before]).abs() { after } else { before }
        })
        .collect();
    let part =
        |of: &[Vec<f64>]| (0..dof).flat_map(|j| rows.iter().map(move |&r| (j, r))).map(|(j, r)| of[r][j]).collect();
    Ok(States { len: rows.len(), q: part(&motion.q), dq: part(&motion.dq), ddq: part(&motion.ddq) })
}
