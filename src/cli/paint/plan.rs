//! `denavit paint plan`: plans the motion of equation (12).

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::{Args, ValueEnum};
use dh_codegen::robot::{Robot, Tool};
use indicatif::{ProgressBar, ProgressStyle};

use crate::apps::painting::{Cover, Infeasible, Pattern, Roller, Strokes, Surface, Swivel, Task, Weights, plan};
use crate::cli::delivery::deliver;
use crate::cli::provenance::Provenance;
use crate::cli::{Failure, files, motors, terminal};
use crate::model::FrameKinematics;
use crate::model::interpreted::Interpreted;
use crate::model::inverse_kinematics::{Kinematics, MOST};
use crate::report;
use crate::report::Warnings;

/// Plan the motion that paints a wall with a roller, inside every limit (the paper's section IV).
///
/// The roller's axis lies along x of the tool frame and its line of contact is the tool's `length`
/// along z. It is held perpendicular to the wall, and strokes run across its axis. The defaults are
/// the paper's wall.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit paint plan robots/kuka-lwr4.yaml --tool robots/tools/large-roller.yaml --out motion.csv --report paint.html"
)]
pub(super) struct Plan {
    /// Robot file.
    robot: PathBuf,
    #[command(flatten)]
    task: Where,
    /// All of the wall must be painted. Without it the area stands in the cost, as in equation
    /// (12), and the limits decide.
    #[arg(long)]
    whole: bool,
    /// Time in contact, s (T_C of equation (12)); default: what costs least.
    #[arg(long, value_name = "SECONDS")]
    duration: Option<f64>,
    /// Weight of the integral of the squared joint jerks in the cost, s per rad^2/s^5.
    #[arg(long, default_value_t = 1.0, value_name = "W")]
    jerk_weight: f64,
    /// Weight of one over the area (Z_u - Z_l) dY in the cost, s m^2.
    #[arg(long, default_value_t = 100.0, value_name = "W")]
    area_weight: f64,
    /// One swivel angle for the whole motion, as in equation (12), instead of one per way point.
    #[arg(long)]
    constant_swivel: bool,
    /// The vector `b` of the swivel angle, world axes.
    #[arg(
        long,
        value_delimiter = ',',
        num_args = 1,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        default_value = "0,0,1"
    )]
    reference: Vec<f64>,
    /// Force on the wall, N: what it asks of the joints counts against their torque limits.
    #[arg(long, default_value_t = 30.0, value_name = "N")]
    force: f64,
    /// Share of velocity, acceleration and jerk limits to use, percent.
    #[arg(long, default_value_t = 100.0, value_name = "PERCENT")]
    speed: f64,
    /// Time in which a joint without `acceleration` limit may reach its speed, s.
    #[arg(long, default_value_t = 0.5, value_name = "SECONDS")]
    acceleration_time: f64,
    /// Lowest z of frames and tool, m, in place of the robot file's ground.
    #[arg(long, value_name = "Z", allow_hyphen_values = true)]
    ground: Option<f64>,
    /// Joint motion to write: CSV with t, q.., dq.., ddq...
    #[arg(long, value_name = "CSV")]
    out: Option<PathBuf>,
    /// Path of the roller to write: CSV with t, x y z of its face, wall coordinates, velocity, tool
    /// pose, swivel, phase.
    #[arg(long, value_name = "CSV")]
    path: Option<PathBuf>,
    /// Samples per second of both.
    #[arg(long, default_value_t = 100.0, value_name = "HZ")]
    rate: f64,
    /// The plan as spline knots (JSON), to be run or evaluated at any time.
    #[arg(long, value_name = "FILE")]
    plan: Option<PathBuf>,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a page with the wall, the path, the moving arm and the joints against their limits.
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
}

/// Wall and roller: what the motion is about.
#[derive(Args)]
pub(super) struct Where {
    /// Tool file with `geometry`, in place of the robot file's tool.
    #[arg(long, value_name = "FILE")]
    tool: Option<PathBuf>,
    /// Origin of the tool's frame in the robot's last DH frame, m, in place of the `xyz` of the
    /// tool's file.
    #[arg(long, value_delimiter = ',', num_args = 1, value_name = "X,Y,Z", allow_hyphen_values = true)]
    mount: Option<Vec<f64>>,
    /// Middle of the wall, m, world axes.
    #[arg(
        long,
        value_delimiter = ',',
        num_args = 1,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        default_value = "-0.8,0.3,0.4"
    )]
    center: Vec<f64>,
    /// Normal of the wall, towards the robot.
    #[arg(
        long,
        value_delimiter = ',',
        num_args = 1,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        default_value = "1,0,0"
    )]
    normal: Vec<f64>,
    /// Direction of the strokes, upwards.
    #[arg(
        long,
        value_delimiter = ',',
        num_args = 1,
        value_name = "X,Y,Z",
        allow_hyphen_values = true,
        default_value = "0,0,1"
    )]
    up: Vec<f64>,
    /// Extent of the wall across the strokes, m.
    #[arg(long, default_value_t = 0.6, value_name = "M")]
    width: f64,
    /// Extent of the wall along the strokes, m.
    #[arg(long, default_value_t = 0.8, value_name = "M")]
    height: f64,
    /// In what order: down and up on each lane (the paper's), or down one and up the next.
    #[arg(long, value_enum, default_value_t = Order::Cycle)]
    pattern: Order,
    /// Number of lanes; default: the fewest that cover the wall.
    #[arg(long)]
    lanes: Option<usize>,
    /// From where the roller comes: distance before the wall, m.
    #[arg(long, default_value_t = 0.05, value_name = "M")]
    standoff: f64,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Order {
    Cycle,
    Snake,
}

/// The robot with its tool, the wall, and the roller.
pub(super) struct Site {
    pub robot: Robot,
    pub surface: Surface,
    pub roller: Roller,
    pub pattern: Pattern,
    pub lanes: usize,
    pub standoff: f64,
    /// File of the robot.
    pub file: files::RobotFile,
    /// Notes on the tool's file.
    pub warnings: Warnings,
}

impl Where {
    /// Reads and checks all files.
    pub(super) fn site(&self, path: &Path) -> Result<Site, Failure> {
        let file = files::robot(path)?;
        motors::on_every_joint(path, &file.robot, "painting drives every joint")?;
        let (mut robot, mut warnings) = (file.robot.clone(), Warnings::default());
        if let Some(path) = &self.tool {
            robot.tool = Some(tool(path, &mut warnings)?);
        }
        let Some(tool) = &mut robot.tool else {
            return Err(Failure::input(format!(
                "{}: the robot has no tool; name a tool file with --tool, or write `tool:` in the robot file",
                path.display()
            )));
        };
        if let Some(mount) = &self.mount {
            tool.xyz = vector("--mount", mount)?;
        }
        let Some(geometry) = tool.geometry else {
            return Err(Failure::input(format!(
                "tool {}: it has no `geometry: {{ length: .., width: .. }}`; a roller's size is needed to paint with it",
                tool.name
            )));
        };
        let [center, normal, up] = [("--center", &self.center), ("--normal", &self.normal), ("--up", &self.up)]
            .map(|(name, v)| vector(name, v));
        let surface = Surface::new(center?, normal?, up?, self.width, self.height).map_err(Failure::input)?;
        if !(geometry.width > 1e-3 && geometry.length > 0.0) {
            return Err(Failure::input(format!(
                "tool {}: a width of {} m and a length of {} m are no roller's",
                tool.name, geometry.width, geometry.length
            )));
        }
        if !(0.0..=1.0).contains(&self.standoff) {
            return Err(Failure::input(format!("--standoff {}: from 0 to 1 m", self.standoff)));
        }
        let lanes = self.lanes.unwrap_or_else(|| Strokes::fewest(&surface, geometry.width));
        if !(1..=200).contains(&lanes) {
            return Err(Failure::input(format!(
                "{lanes} lanes of {} m: from 1 to 200 are planned; {}",
                geometry.width,
                if self.lanes.is_some() {
                    "name fewer or more --lanes"
                } else {
                    "paint a narrower wall, or name --lanes"
                }
            )));
        }
        Ok(Site {
            surface,
            roller: Roller { length: geometry.length, width: geometry.width, turned: false },
            pattern: match self.pattern {
                Order::Cycle => Pattern::Cycle,
                Order::Snake => Pattern::Snake,
            },
            lanes,
            standoff: self.standoff,
            file,
            robot,
            warnings,
        })
    }
}

/// Reads a tool file; its notes become warnings.
pub(super) fn tool(path: &Path, warnings: &mut Warnings) -> Result<Tool, Failure> {
    let shown = path.display().to_string();
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let (tool, notes) = Tool::from_yaml(&files::text(path)?, &stem)
        .map_err(|problems| Failure::input(format!("{shown} can't be used:\n{}", problems.in_file(&shown))))?;
    notes.iter().for_each(|note| terminal::warn(warnings, &shown, &note.to_string()));
    Ok(tool)
}

fn vector(option: &str, numbers: &[f64]) -> Result<[f64; 3], Failure> {
    let vector: Option<[f64; 3]> = numbers.try_into().ok();
    vector
        .filter(|v| v.iter().all(|x| x.is_finite()))
        .ok_or_else(|| Failure::input(format!("{option} takes three numbers with commas: 0,0,1")))
}

impl Plan {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        self.validate()?;
        provenance.refuse_idle(&[(
            "--rate",
            self.out.is_some() || self.path.is_some(),
            "it is that of --out and --path",
        )])?;
        let site = self.task.site(&self.robot)?;
        files::check_outputs(
            &[
                ("--out", &self.out),
                ("--path", &self.path),
                ("--plan", &self.plan),
                ("--report", &self.report),
                ("--json", &self.json),
            ],
            site.file.read.iter().chain(&self.task.tool),
        )?;
        let provenance = provenance.robot(&self.robot, &site.file).with("lanes", site.lanes);
        let begun = Instant::now();
        let arm = Interpreted::new(&site.robot, &Interpreted::PLACED);
        let shown = self.robot.display();
        let inverse = Kinematics::new(&site.robot, arm.model()).ok_or_else(|| {
            Failure::input(format!(
                "{shown}: the robot has {} joints; postures are found for up to {MOST}",
                site.robot.dof()
            ))
        })?;
        let mut task = Task::new(&arm, &inverse, &site.robot, site.surface, site.roller, self.acceleration_time)
            .map_err(|e| Failure::input(format!("{shown}: {e}")))?;
        (task.pattern, task.lanes, task.standoff) = (site.pattern, site.lanes, site.standoff);
        task.cover = if self.whole { Cover::Whole } else { Cover::Most };
        task.swivel = if self.constant_swivel { Swivel::Constant } else { Swivel::Spline };
        let why = "the arm has no redundancy that a swivel angle would settle";
        let redundant = task.redundancy().is_some();
        provenance.refuse_idle(&[("--reference", redundant, why), ("--constant-swivel", redundant, why)])?;
        task.reference.b = vector("--reference", &self.reference)?;
        if task.reference.b.iter().all(|x| x.abs() < 1e-9) {
            return Err(Failure::input("--reference takes three numbers, not all zero: 0,0,1"));
        }
        task.weights = Weights { jerk: self.jerk_weight, area: self.area_weight };
        task.duration = self.duration;
        task.force = self.force;
        task.share = self.speed / 100.0;
        match (self.ground, &mut task.bodies.ground) {
            (Some(z), Some(ground)) => ground.0 = z,
            (Some(z), none) => *none = Some((z, (0..arm.frame_count()).collect())),
            _ => {}
        }
        let mut warnings = site.warnings;
        for line in report::missing_text(&task.missing) {
            terminal::warn(&mut warnings, &shown.to_string(), &line);
        }
        let bar = ProgressBar::new(1000);
        if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} {bar:30} {msg}") {
            bar.set_style(style);
        }
        let found = plan(&task, &|what, share| {
            bar.set_message(what);
            bar.set_position((1000.0 * share) as u64);
        });
        bar.finish_and_clear();
        let found = found.map_err(|e| {
            Failure::other(format!("{shown}: no plan keeps every limit; closest to one: {e}. {}", self.advice(&e)))
        })?;
        let planned =
            report::Planned { task: &task, plan: &found, seconds: begun.elapsed().as_secs_f64(), warnings: &warnings };
        self.deliver(&planned, &provenance)
    }

    fn deliver(&self, planned: &report::Planned<'_>, provenance: &Provenance) -> Result<(), Failure> {
        deliver(provenance)
            .file(self.out.as_ref(), || report::paint_csv(planned.plan, self.rate))?
            .file(self.path.as_ref(), || report::paint_path_csv(planned.plan, self.rate))?
            .file(self.plan.as_ref(), || format!("{}\n", report::plan_json(planned.plan)))?
            .file(self.report.as_ref(), || report::paint_html(planned, &provenance.rows()))?
            .json(self.json.as_ref(), || report::paint_json(planned))?
            .text(|| report::paint_text(planned))
    }

    fn validate(&self) -> Result<(), Failure> {
        let ranges = [
            ("--rate", self.rate, 1.0, 10_000.0),
            ("--duration", self.duration.unwrap_or(1.0), 0.1, 1e4),
            ("--jerk-weight", self.jerk_weight, 0.0, 1e9),
            ("--area-weight", self.area_weight, 0.0, 1e9),
            ("--force", self.force, 0.0, 1e4),
            ("--speed", self.speed, 1.0, 100.0),
            ("--acceleration-time", self.acceleration_time, 1e-3, 100.0),
            ("--ground", self.ground.unwrap_or(0.0), -100.0, 100.0),
        ];
        for (name, value, low, high) in ranges {
            if !(low..=high).contains(&value) {
                return Err(Failure::input(format!("{name} {value}: from {low} to {high}")));
            }
        }
        Ok(())
    }

    fn advice(&self, infeasible: &Infeasible) -> &'static str {
        if infeasible.too_weak {
            "Press with less --force, or move the wall to where the arm stands better"
        } else if self.whole && self.duration.is_some() {
            "Give it a longer --duration, or leave that or --whole out"
        } else if self.whole {
            "Leave --whole out to paint as much as can be painted, or move the wall"
        } else if self.duration.is_some() {
            "Give it a longer --duration, or leave that out"
        } else {
            "Move the wall to where the arm reaches it with the roller held perpendicular"
        }
    }
}
