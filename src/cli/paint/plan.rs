//! `denavit paint plan`: the motion of equation (12).

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use dh_codegen::robot::{Robot, Tool};

use crate::cli::{Failure, files};
use crate::paint::{Pattern, Roller, Strokes, Surface};

/// Plan the motion that paints a wall with a roller, inside every limit (the paper's section IV).
///
/// The roller's axis lies along x of the tool frame and what touches the wall is the tool's `length` along z; it is held perpendicular to the
/// wall, and strokes run across its axis. The defaults are the paper's wall.
#[derive(Args)]
#[command(
    after_help = "Example:\n  denavit paint plan robots/kuka-lwr4.yaml --tool robots/tools/large-roller.yaml --out motion.csv --report paint.html"
)]
pub(super) struct Plan {
    /// Robot file.
    robot: PathBuf,
    #[command(flatten)]
    task: Where,
}

/// Wall and roller: what the motion is about.
#[derive(Args)]
pub(super) struct Where {
    /// Tool file with `geometry`, in place of the robot file's tool.
    #[arg(long, value_name = "FILE")]
    tool: Option<PathBuf>,
    /// Where the tool's frame sits in the robot's last DH frame, m, in place of the `xyz` of the tool's file.
    #[arg(long, value_delimiter = ',', num_args = 1, value_name = "X,Y,Z", allow_hyphen_values = true)]
    mount: Option<Vec<f64>>,
    /// Middle of the wall, m, base axes.
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

/// The robot with the tool in its hand, the wall, and the roller.
pub(super) struct Site {
    pub robot: Robot,
    pub surface: Surface,
    pub roller: Roller,
    pub pattern: Pattern,
    pub lanes: usize,
    pub standoff: f64,
    /// Text of the robot's file.
    pub text: String,
}

impl Where {
    /// Reads and checks all of it.
    pub(super) fn site(&self, path: &Path) -> Result<Site, Failure> {
        let file = files::robot(path)?;
        let mut robot = file.robot;
        if let Some(path) = &self.tool {
            robot.tool = Some(tool(path)?);
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
                "{lanes} lanes of {} m: from 1 to 200 are planned; paint a narrower wall, or name --lanes",
                geometry.width
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
            text: file.text,
            robot,
        })
    }
}

fn tool(path: &Path) -> Result<Tool, Failure> {
    let shown = path.display().to_string();
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let (tool, notes) = Tool::from_yaml(&files::text(path)?, &stem)
        .map_err(|problems| Failure::input(format!("{shown} can't be used:\n{}", problems.in_file(&shown))))?;
    notes.iter().for_each(|note| eprintln!("{shown}: note: {note}"));
    Ok(tool)
}

fn vector(option: &str, numbers: &[f64]) -> Result<[f64; 3], Failure> {
    let vector: Option<[f64; 3]> = numbers.try_into().ok();
    vector
        .filter(|v| v.iter().all(|x| x.is_finite()))
        .ok_or_else(|| Failure::input(format!("{option} takes three numbers with commas: 0,0,1")))
}

impl Plan {
    pub(super) fn run(self) -> Result<(), Failure> {
        let site = self.task.site(&self.robot)?;
        let ([left, right], [low, high]) = (site.surface.sides(), site.surface.ends());
        let half = 0.5 * site.roller.width.min(site.surface.width);
        let step = if site.lanes > 1 { (right - left - 2.0 * half) / (site.lanes - 1) as f64 } else { 0.0 };
        let strokes =
            Strokes { upper: high, lower: low, first: left + half, step, lanes: site.lanes, pattern: site.pattern };
        for leg in strokes.legs(site.standoff) {
            let [y, z, off] = leg.to;
            files::print(&format!("{}: to y {y:.3}, z {z:.3}, {off:.3} m before the wall\n", leg.phase.name()))?;
        }
        Ok(())
    }
}
