//! Plan of the motion on the wall by equation (12), and the same motion in the air.

use dh_codegen::robot::Robot;

use super::super::Watch;
use super::super::motions::ACCELERATION_TIME;
use super::super::{DesignObstacle, ReproduceError};
use super::rig::{CENTER, NORMAL};
use crate::apps::painting::run::SETTLE;
use crate::apps::painting::{Cover, Plan, Roller, Surface, Swivel, Task, plan};
use crate::control::law::Model;
use crate::control::robot::RobotModel;
use crate::model::interpreted::Interpreted;
use crate::model::inverse_kinematics::Kinematics;
use crate::simulate::{SimulateError, Trajectory};

/// Extent of the painting.
#[derive(Debug, Clone, Copy)]
pub struct Extent {
    /// Width and height of the wall, m.
    size: [f64; 2],
    /// Duration for each roller, s; the number of entries is the number of rollers.
    pub seconds: &'static [f64],
    /// Whether to use one swivel angle and to require the whole wall.
    plain: bool,
    /// Time of pressing before painting begins, s.
    pub settle: f64,
}

impl Extent {
    /// The paper's wall and durations.
    pub const PAPER: Self = Self { size: [0.6, 0.8], seconds: &super::PAPER_SECONDS, plain: false, settle: SETTLE };
    /// A hand's breadth of wall.
    pub const QUICK: Self = Self { size: [0.2, 0.15], seconds: &[2.0], plain: true, settle: 3.0 };
}

/// Number of the arm's joints.
const N: usize = 7;
/// Distance of the planned surface behind the wall, m: room for the force loop to push, and a
/// margin from the stretched arm.
pub const ROOM: f64 = 0.04;

/// Plans for the robot's tool, in the paper's time.
pub fn planned(
    robot: &Robot,
    standard: &[f64],
    force: f64,
    extent: &Extent,
    seconds: f64,
    tell: Watch<'_>,
) -> Result<Plan, DesignObstacle> {
    let geometry = robot.tool.as_ref().and_then(|t| t.geometry).ok_or(DesignObstacle::ToolSize)?;
    let arm = Interpreted::new(robot, &Interpreted::PLACED);
    let inverse = Kinematics::new(robot, arm.model()).ok_or(DesignObstacle::TooManyJoints)?;
    let center = [0, 1, 2].map(|k| CENTER[k] - ROOM * NORMAL[k]);
    let surface = Surface::new(center, NORMAL, [0.0, 0.0, 1.0], extent.size[0], extent.size[1])?;
    let roller = Roller { length: geometry.length, width: geometry.width, turned: false };
    let mut task = Task::new(&arm, &inverse, robot, surface, roller, ACCELERATION_TIME)?;
    task.standard = Some(standard.to_vec());
    task.duration = Some(seconds);
    if extent.plain {
        (task.cover, task.swivel) = (Cover::Whole, Swivel::Constant);
    }
    task.force = force;
    Ok(plan(&task, &|what, share| tell(what, share))?)
}

/// Shifts a motion by `off`, m, along the normal of the wall.
pub fn in_the_air(model: &mut RobotModel<'_>, motion: &Trajectory, off: f64) -> Result<Trajectory, ReproduceError> {
    let span = motion.span();
    let count = ((span.end - span.start) * 50.0).ceil() as usize;
    let by = NORMAL.map(|n| off * n);
    let (mut t, mut rows, mut hint, mut points) = (Vec::new(), Vec::new(), 0, vec![[0.0; 3]; N]);
    let mut near: Option<[f64; N]> = None;
    for k in 0..=count {
        let at = span.start + (span.end - span.start) * k as f64 / count as f64;
        motion.at(at, &mut hint, &mut points);
        let q: [f64; N] = std::array::from_fn(|j| points[j][0]);
        let moved = model
            .displaced(&q, &by, &near.unwrap_or(q))
            .ok_or_else(|| ReproduceError::design("the dry run")(DesignObstacle::OutOfReach))?;
        near = Some(moved);
        t.push(at);
        rows.push(moved.to_vec());
    }
    let q = joint_major(&rows, |row: &Vec<f64>| row);
    Ok(Trajectory::new(N, t, q, None, None).map_err(SimulateError::from)?)
}

fn joint_major<R>(rows: &[R], of: impl Fn(&R) -> &Vec<f64>) -> Vec<f64> {
    let dof = rows.first().map_or(0, |r| of(r).len());
    (0..dof).flat_map(|j| rows.iter().map(move |r| (r, j))).map(|(r, j)| of(r)[j]).collect()
}
