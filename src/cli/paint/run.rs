//! `denavit paint run`: runs a plan under control against the simulated wall.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use dh_codegen::arm::param;
use dh_codegen::robot::{Effects, Robot};
use indicatif::{ProgressBar, ProgressStyle};

use crate::apps::painting::Plan;
use crate::apps::painting::run::{Feedback, Known, Law, RunError, RunTask, SETTLE, in_contact, roller_moment, run};
use crate::apps::painting::wall::RollerWall;
use crate::cli::delivery::deliver;
use crate::cli::paint::plan::tool;
use crate::cli::provenance::Provenance;
use crate::cli::simulate::effects;
use crate::cli::{Failure, files, motors};
use crate::control::robot::contact_point;
use crate::model::interpreted::Interpreted;
use crate::report;
use crate::simulate::{Request, SimulationFile, Simulator};

/// Run a plan against the simulated wall: position and force control of the paper's section V.
///
/// The controller's model is the robot file; the simulated robot has the file's effects and those
/// of --effects. Gains are proposed from a linear model of arm, wall, filter and sampling
/// (docs/control.md). The force comes from the joint torques, or from a sensor in the wall.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit paint plan robots/kuka-lwr4.yaml --tool robots/tools/large-roller.yaml --plan plan.json\n  denavit paint run robots/kuka-lwr4.yaml --tool robots/tools/large-roller.yaml --plan plan.json --out force.csv --report run.html"
)]
pub(super) struct Run {
    /// Robot file; every link's inertial parameters must be in it.
    robot: PathBuf,
    /// The plan: what `denavit paint plan --plan` wrote.
    #[arg(long, value_name = "FILE")]
    plan: PathBuf,
    /// Tool file, in place of the robot file's tool.
    #[arg(long, value_name = "FILE")]
    tool: Option<PathBuf>,
    /// Effects and sensors of the simulated robot that its controller's model lacks.
    #[arg(long, value_name = "YAML")]
    effects: Option<PathBuf>,
    /// Force in the feedback.
    #[arg(long, value_enum, default_value_t = Which::Estimated)]
    feedback: Which,
    /// Force to press with, N.
    #[arg(long, default_value_t = 30.0, value_name = "N")]
    force: f64,
    /// Share of the desired force that is fed forward as joint torques; 0: equation (13) of the
    /// paper.
    #[arg(long, default_value_t = 1.0, value_name = "0..1")]
    carry: f64,
    /// Share of the planned motion's torques (inertia, friction, known effects) that is fed
    /// forward.
    #[arg(long, default_value_t = 1.0, value_name = "0..1")]
    feed: f64,
    /// Share of the estimated force aside of the wall's normal that is fed forward.
    #[arg(long, default_value_t = 0.5, value_name = "0..1")]
    aside: f64,
    /// Share of the drag that is predicted from where the plan slides, with friction as learned so
    /// far. It is learned in a wipe of 4 cm along the roller's axis, at the end of the settling
    /// time (where that is 3 s or longer).
    #[arg(long, default_value_t = 1.0, value_name = "0..1")]
    drag: f64,
    /// How many coats: each but the first is fed the displacement along the normal that the force's
    /// error on the coats before asks for (docs/control.md). Shown is the last one.
    #[arg(long, default_value_t = 1, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=20))]
    coats: u32,
    /// The paper's law: nothing is fed forward but gravity.
    #[arg(long, conflicts_with_all = ["carry", "feed", "aside", "drag"])]
    paper: bool,
    /// How large a moment the contact may carry, N m (standard deviation); `inf`: any. Default:
    /// force times the roller's width over the root of 12, as the pressure's middle may be anywhere
    /// along it; any with `--paper`.
    #[arg(long, value_name = "N M", conflicts_with = "no_moment")]
    moment: Option<f64>,
    /// By how much a joint's friction may be off at most just after it has turned round, N m: what
    /// may be friction is not taken for force. `inf`, the default: by as much as there is; 0, the
    /// default with `--paper`: the model is right.
    #[arg(long, value_name = "N M")]
    doubt: Option<f64>,
    /// The contact carries no moment: three components of the force are estimated instead of six.
    #[arg(long)]
    no_moment: bool,
    /// Corner of the low-pass of the forces, Hz.
    #[arg(long, default_value_t = 10.0, value_name = "HZ")]
    corner: f64,
    /// How long it presses at the first point before it paints, s.
    #[arg(long, default_value_t = SETTLE, value_name = "S")]
    settle: f64,
    /// Stiffness of roller and wall, N/m.
    #[arg(long, default_value_t = 8000.0, value_name = "N/M")]
    stiffness: f64,
    /// Of the noise: the same seed gives the same bytes.
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Forces and places over time: CSV.
    #[arg(long, value_name = "CSV")]
    out: Option<PathBuf>,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a page with the force over time, the path on the wall and the gains.
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Which {
    /// Equation (14).
    Estimated,
    /// The sensor in the wall.
    Measured,
}

/// Reads an effects file of which all sections have an effect here: painting has its own control
/// and its own solver tolerance.
fn played(path: &Path, robot: &Robot, warnings: &mut report::Warnings) -> Result<SimulationFile, Failure> {
    let file = effects(path, robot, warnings)?;
    let idle = file.settings().find(|(section, _)| *section != "sensors");
    match idle {
        None => Ok(file),
        Some((section, key)) => Err(Failure::input(format!(
            "{}: `{section}: {key}` has no effect on `paint run`, which has a control and a solver of its own; leave it out",
            path.display()
        ))),
    }
}

impl Run {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        self.validate()?;
        let mut file = files::robot(&self.robot)?;
        motors::on_every_joint(&self.robot, &file.robot, "painting drives every joint")?;
        files::check_outputs(
            &[("--out", &self.out), ("--json", &self.json), ("--report", &self.report)],
            file.read.iter().chain([&self.plan]).chain(&self.tool).chain(&self.effects),
        )?;
        let provenance = provenance
            .robot(&self.robot, &file)
            .with("low-pass of the forces", format!("three poles, {} Hz", self.corner));
        let shown = self.robot.display();
        let mut warnings = report::Warnings::default();
        if let Some(path) = &self.tool {
            file.robot.tool = Some(tool(path, &mut warnings)?);
        }
        let robot = file.robot;
        let plan = self.plan(&self.plan)?;
        self.made_for(&plan, &robot)?;
        let given = match &self.effects {
            Some(path) => played(path, &robot, &mut warnings)?,
            None => SimulationFile::default(),
        };
        let mut request = Request::default();
        given.apply(&mut request);
        let real = Simulator::new(&robot, &given.effects).map_err(|e| Failure::input(format!("{shown}: {e}")))?;
        let own = Simulator::new(&robot, &Effects::default()).map_err(|e| Failure::input(format!("{shown}: {e}")))?;
        let arm = Interpreted::new(&robot, &Interpreted::BODIES);
        let standard = param::standard_values(&robot).ok_or_else(|| {
            Failure::input(format!("{shown}: the links are not all known; add `links:`, or identify them"))
        })?;
        let known = Known {
            robot: &robot,
            arm: &arm,
            standard: &standard,
            drives: own.drives().to_vec(),
            spread: vec![1.0; robot.dof()],
            turning: vec![self.doubt.unwrap_or(if self.paper { 0.0 } else { f64::INFINITY }); robot.dof()],
        };
        let law = if self.paper {
            Law::PAPER
        } else {
            Law { carry: self.carry, feed: self.feed, aside: self.aside, drag: self.drag }
        };
        let motion = in_contact(&plan).map_err(Failure::input)?;
        let mut wall = RollerWall::new(plan.surface.center, plan.surface.normal, contact_point(robot.tool.as_ref()));
        wall.stiffness = self.stiffness;
        let feedback = match self.feedback {
            Which::Estimated => Feedback::Estimated,
            Which::Measured => Feedback::Measured,
        };
        let moment = match self.moment {
            Some(moment) => moment,
            None if self.no_moment => 0.0,
            None if self.paper => f64::INFINITY,
            None => roller_moment(robot.tool.as_ref(), self.force),
        };
        let task = RunTask {
            motion: &motion,
            wall,
            force: self.force,
            feedback,
            moment,
            law,
            corner: self.corner,
            settle: self.settle,
            learned: None,
            sensors: request.sensors,
            seed: self.seed,
        };
        let bar = if std::io::stderr().is_terminal() { ProgressBar::new(1000) } else { ProgressBar::hidden() };
        if let Ok(style) = ProgressStyle::with_template("painting [{bar:30}] {percent}% {eta}") {
            bar.set_style(style);
        }
        let (of, mut coats) = (f64::from(self.coats), Vec::new());
        let mut found = run(&known, &real, &task, &mut |share| bar.set_position((1000.0 * share / of) as u64));
        for coat in 1..self.coats {
            let Ok(before) = &found else { break };
            // A coat that did not end well gives no displacement for the next.
            let Some(learned) = before.learned.clone() else { break };
            coats.push(before.accuracy);
            let seed = self.seed.wrapping_add(1000 * u64::from(coat));
            let task = RunTask { learned: Some(&learned), seed, ..task.clone() };
            let done = f64::from(coat);
            found = run(&known, &real, &task, &mut |share| bar.set_position((1000.0 * (done + share) / of) as u64));
        }
        bar.finish_and_clear();
        let found = found.map_err(|e| match e {
            RunError::Simulate(_) => Failure::other(format!("{shown}: {e}")),
            _ => Failure::input(format!("{shown}: {e}")),
        })?;
        coats.push(found.accuracy);
        let painted = report::Painted {
            run: &found,
            plan: &plan,
            force: self.force,
            feedback,
            law,
            coats: &coats,
            warnings: &warnings,
        };
        self.deliver(&painted, &provenance.with("moment", format!("{moment} N m")))
    }

    fn deliver(&self, found: &report::Painted<'_>, provenance: &Provenance) -> Result<(), Failure> {
        deliver(provenance)
            .file(self.out.as_ref(), || report::paint_run_csv(found.run))?
            .file(self.report.as_ref(), || report::paint_run_html(found, &provenance.rows()))?
            .json(self.json.as_ref(), || report::paint_run_json(found))?
            .text(|| report::paint_run_text(found))?;
        match found.run.painted() {
            true => Ok(()),
            false => Err(Failure::other(format!("{}: it {}", self.plan.display(), report::paint_run_ended(found.run)))),
        }
    }

    /// Checks that the plan was made for this robot and this roller; for another one the wall or
    /// the lanes are elsewhere.
    fn made_for(&self, plan: &Plan, robot: &Robot) -> Result<(), Failure> {
        let shown = self.robot.display();
        if plan.motion.dof() != robot.dof() {
            return Err(Failure::input(format!(
                "{}: the plan has {} joints, {shown} has {}; take the plan that was made for this robot",
                self.plan.display(),
                plan.motion.dof(),
                robot.dof()
            )));
        }
        let planned = [plan.roller.length, plan.roller.width];
        let own = robot.tool.as_ref().and_then(|tool| tool.geometry).map(|g| [g.length, g.width]);
        if own.is_some_and(|own| own.iter().zip(planned).all(|(a, b)| (a - b).abs() < 1e-6)) {
            return Ok(());
        }
        let has = match own {
            Some([length, width]) => format!("the tool here is one of {length} m x {width} m"),
            None => "there is no roller here".into(),
        };
        Err(Failure::input(format!(
            "{}: the plan was made for a roller of {} m x {} m (length x width), and {has}; give the plan's --tool, or plan again",
            self.plan.display(),
            planned[0],
            planned[1]
        )))
    }

    fn plan(&self, path: &Path) -> Result<Plan, Failure> {
        let shown = path.display();
        let value = serde_json::from_str(&files::text(path)?).map_err(|e| {
            Failure::input(format!("{shown}: this is no JSON: {e}; write the plan with `denavit paint plan --plan`"))
        })?;
        report::plan_of_json(&value).map_err(|e| Failure::input(format!("{shown}: {e}")))
    }

    fn validate(&self) -> Result<(), Failure> {
        for (name, value, low, high) in [
            ("--force", self.force, 1.0, 1e4),
            ("--carry", self.carry, 0.0, 1.0),
            ("--feed", self.feed, 0.0, 1.0),
            ("--aside", self.aside, 0.0, 1.0),
            ("--drag", self.drag, 0.0, 1.0),
            ("--settle", self.settle, 0.0, 60.0),
            ("--corner", self.corner, 0.5, 200.0),
            ("--stiffness", self.stiffness, 100.0, 1e6),
            ("--doubt", self.doubt.unwrap_or(0.0), 0.0, f64::INFINITY),
            ("--moment", self.moment.unwrap_or(0.0), 0.0, f64::INFINITY),
        ] {
            if !(low..=high).contains(&value) {
                return Err(Failure::input(format!("{name} {value}: from {low} to {high}")));
            }
        }
        Ok(())
    }
}
