//! `denavit ik`: computes all postures for given poses.

use std::path::PathBuf;

use clap::Args;
use dh_codegen::arm::Model;
use dh_codegen::ik::{Displacement, Family, Reference};
use dh_codegen::robot::Robot;
use indicatif::ProgressBar;

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::provenance::Provenance;
use super::table::Table;
use crate::model::inverse_kinematics::{Answer, Ask, Kinematics, MOST, PoseError, SwivelRange};
use crate::numerics::parallel::{parallel, threads};
use crate::report;

const ENTRIES: [&str; 12] = ["r11", "r12", "r13", "px", "r21", "r22", "r23", "py", "r31", "r32", "r33", "pz"];

/// Find the postures that bring the arm to given poses: all of them in closed form where the arm
/// has one.
///
/// Six joints without one (class `none`) are solved by elimination, all postures too, and so are
/// seven of which one is given. An arm that nearly has one is refined from a nominal arm, and the
/// rest is searched numerically. These two print `exact: false`. All three print for each pose
/// whether postures may be missing.
///
/// A pose is that of the last DH frame in the world frame, m, as `denavit eval --quantity
/// forward_kinematics` prints it. Its columns are `r11 r12 r13 px r21 r22 r23 py r31 r32 r33 pz`.
/// The tool of the robot file does not count, unless `--tool` is given: then poses are those of its
/// tool frame.
///
/// A redundant arm needs a column `swivel`, rad. It is the angle of the elbow about the line from
/// shoulder to wrist, from the plane of the reference vector (`--reference`), or the position of
/// the joint that is locked (`denavit check` names it). Without it: that of the posture `q1..qn`
/// where there is one, else that at which some posture stays farthest from its limits (zero where
/// none respects them). The result says which it was. Of an arm with a swivel angle it also says in
/// which intervals of it each branch respects the limits, and where it stays farthest from them; of
/// one with a locked joint, at which positions of the joint some posture does.
///
/// Poses are spread over all cores; the result does not depend on their number.
///
/// Columns `q1..qn`, if there are any, are a posture near which to choose. Its solutions stand
/// first, and where the arm is singular the free joints keep their positions of that posture.
#[derive(Args)]
#[command(after_help = "Example:\n  denavit ik robots/ur10e.yaml --poses poses.csv --json -")]
pub(super) struct Ik {
    /// Robot file.
    robot: PathBuf,
    /// Poses, CSV with a header, one per row.
    #[arg(long, value_name = "CSV")]
    poses: PathBuf,
    /// Poses are those of the tool frame.
    #[arg(long)]
    tool: bool,
    /// The vector `b` of the swivel angle, in world axes: at zero the elbow lies on its side of the
    /// line from shoulder to wrist.
    #[arg(
        long,
        value_name = "X,Y,Z",
        value_delimiter = ',',
        num_args = 1,
        allow_hyphen_values = true,
        default_value = "0,0,1"
    )]
    reference: Vec<f64>,
    /// Substitute where it is parallel to that line.
    #[arg(
        long,
        value_name = "X,Y,Z",
        value_delimiter = ',',
        num_args = 1,
        allow_hyphen_values = true,
        default_value = "1,0,0"
    )]
    second_reference: Vec<f64>,
    /// Tolerated pose error, m and rad. An arm with fewer than six joints reaches rounded poses
    /// only nearly: give more.
    #[arg(long, value_name = "SIZE", default_value_t = 1e-12, allow_hyphen_values = true)]
    tolerance: f64,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

impl Ik {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let file = files::robot(&self.robot)?;
        files::check_outputs(&[("--json", &self.json)], file.read.iter().chain([&self.poses]))?;
        // Effects of geometry (zeros, lengths) are part of the arm, as in its generated
        // code.
        let robot = &file.robot.effective();
        let reference = Reference {
            b: vector("--reference", &self.reference)?,
            second: vector("--second-reference", &self.second_reference)?,
        };
        if !(self.tolerance > 0.0 && self.tolerance.is_finite()) {
            return Err(Failure::input("--tolerance must be a positive number, in m and rad; 1e-12 is rounding"));
        }
        let tool = self.tool_frame(robot)?;
        let model = Model::new(robot);
        let kinematics = Kinematics::new(robot, &model).ok_or_else(|| {
            Failure::input(format!(
                "{}: the robot has {} joints; postures are found for up to {MOST}",
                self.robot.display(),
                robot.dof()
            ))
        })?;
        let redundant = kinematics.inverse().is_redundant();
        let swivels = matches!(kinematics.inverse().family, Family::Swivel(_));
        let why = "the arm has no swivel angle";
        provenance.refuse_idle(&[("--reference", swivels, why), ("--second-reference", swivels, why)])?;
        let table = Table::read(&self.poses)?;
        if !redundant && table.has("swivel") && table.column("swivel")?.iter().any(|s| *s != 0.0) {
            return Err(Failure::input(format!(
                "{}, line 1: there is a column swivel, and the arm is not redundant; delete the column",
                table.file
            )));
        }
        let poses = self.solve(&table, robot.dof(), &kinematics, reference, tool)?;
        deliver(&provenance.robot(&self.robot, &file))
            .json(self.json.as_ref(), || report::ik_json(&robot.name, kinematics.inverse(), redundant, &poses))?
            .text(|| report::ik_text(&robot.name, kinematics.inverse(), &poses))
    }

    /// Displacement from the poses' tool frame to the last frame, if `--tool` is given.
    fn tool_frame(&self, robot: &Robot) -> Result<Option<Displacement>, Failure> {
        Ok(match (self.tool, &robot.tool) {
            (false, _) => None,
            (true, Some(t)) => Some(Displacement { rotation: t.rotation(), shift: t.xyz }.inverse()),
            (true, None) => {
                return Err(Failure::input(format!(
                    "{}: there is no `tool:`, so --tool says nothing; leave it out, or add the tool's pose to the file",
                    self.robot.display()
                )));
            }
        })
    }

    fn solve(
        &self,
        table: &Table,
        n: usize,
        kinematics: &Kinematics,
        reference: Reference,
        tool: Option<Displacement>,
    ) -> Result<Vec<Answer>, Failure> {
        let file = &table.file;
        let mut entries = Vec::with_capacity(12);
        for name in ENTRIES {
            if !table.has(name) {
                return Err(Failure::input(format!(
                    "{file}, line 1: there is no column {name}; a pose has the columns {}",
                    ENTRIES.join(" ")
                )));
            }
            entries.push(table.column(name)?);
        }
        if table.len == 0 {
            return Err(Failure::input(format!("{file} has a header and no pose; write one per row below it")));
        }
        let swivel = if table.has("swivel") { Some(table.column("swivel")?) } else { None };
        let near = if table.has("q1") { Some(table.joints("q", n)?) } else { None };
        let bar = if table.len > 10_000 { ProgressBar::new(table.len as u64) } else { ProgressBar::hidden() };
        let answer = |row: usize| -> Result<Answer, PoseError> {
            let given: [[f64; 4]; 3] = core::array::from_fn(|i| core::array::from_fn(|j| entries[4 * i + j][row]));
            let pose = match &tool {
                Some(back) => rows(&Displacement::from_rows(&given).after(back)),
                None => given,
            };
            let near: Option<Vec<f64>> = near.as_ref().map(|q| (0..n).map(|j| q[j * table.len + row]).collect());
            let ranges = kinematics.swivel_ranges(&pose, &reference)?;
            let locked = kinematics.locked_range(&pose)?;
            let redundancy = match (swivel, &near) {
                (Some(s), _) => s[row],
                (None, Some(q)) => kinematics.redundancy(q, &reference),
                (None, None) => {
                    let at = locked.as_ref().and_then(|l| l.best).map(|(at, _)| at);
                    at.or(ranges.as_deref().and_then(best)).unwrap_or(0.0)
                }
            };
            let ask = Ask { redundancy, reference, near, tolerance: self.tolerance, ..Ask::default() };
            Ok(Answer { postures: kinematics.solve(&pose, &ask)?, swivel: ranges, locked })
        };
        let blocks = parallel(threads(), table.len.div_ceil(BLOCK), |k| {
            let rows = k * BLOCK..table.len.min((k + 1) * BLOCK);
            bar.inc(rows.len() as u64);
            rows.map(&answer).collect::<Vec<_>>()
        });
        bar.finish_and_clear();
        let mut poses = Vec::with_capacity(table.len);
        for (row, found) in blocks.into_iter().flatten().enumerate() {
            poses.push(found.map_err(|e| refused(file, row, e))?);
        }
        Ok(poses)
    }
}

/// Describes what is wrong with a pose, and how to correct it.
fn refused(file: &str, row: usize, e: PoseError) -> Failure {
    let mend = match e {
        PoseError::NotARotation(_) => {
            "; a rotation has orthogonal columns of length one, to 1e-6: give at least seven decimals"
        }
        PoseError::Reflection => "; a rotation has +1: turn one column about",
        PoseError::NotFinite(..) => "; give a number",
    };
    Failure::input(format!("{file}, pose {} (line {}): {e}{mend}", row + 1, row + 2))
}

/// Number of poses that a thread processes at a time.
const BLOCK: usize = 32;

/// Swivel angle at which some branch is farthest from its limits.
fn best(ranges: &[SwivelRange]) -> Option<f64> {
    let most = |a: (f64, f64), b: (f64, f64)| if b.1 > a.1 { b } else { a };
    ranges.iter().filter_map(|r| r.best).reduce(most).map(|(at, _)| at)
}

fn rows(t: &Displacement) -> [[f64; 4]; 3] {
    core::array::from_fn(|i| {
        let [x, y, z] = t.rotation[i];
        [x, y, z, t.shift[i]]
    })
}

fn vector(option: &str, numbers: &[f64]) -> Result<[f64; 3], Failure> {
    let vector: Option<[f64; 3]> = numbers.try_into().ok();
    vector
        .filter(|v| v.iter().all(|x| x.is_finite()) && v.iter().any(|x| x.abs() > 1e-9))
        .ok_or_else(|| Failure::input(format!("{option} takes three numbers, not all zero, with commas: 0,0,1")))
}
