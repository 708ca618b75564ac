//! Inverse kinematics of any robot file without compiling: the source text of the generated crates,
//! run by the interpreter.

use dh_codegen::arm::{Inverse, Model};
use dh_codegen::ik::{Arm, Branch, Query, Reference, Status};
use dh_codegen::robot::Robot;

pub use dh_codegen::ik::PoseError;

/// One posture.
#[derive(Debug, Clone, PartialEq)]
pub struct Posture {
    /// Positions, rad or m, `dof` entries.
    pub q: Vec<f64>,
    /// Branch of the posture.
    pub branch: Branch,
    /// Distance of the last frame's origin from the pose's, m.
    pub position_error: f64,
    /// Angle between the last frame and the pose, rad.
    pub rotation_error: f64,
    /// Whether it respects the limits.
    pub within_limits: bool,
    /// Distance to the nearest limit, rad or m; infinite where no joint has one.
    pub margin: f64,
    /// Joints, from 0, that can move together without changing the pose.
    pub free: Vec<usize>,
}

/// All postures of one pose.
#[derive(Debug, Clone, PartialEq)]
pub struct Postures {
    /// Outcome for the pose.
    pub status: Status,
    /// Postures in the order of their branches, or by distance from the near posture.
    pub list: Vec<Posture>,
    /// For an unreachable pose: error of the nearest posture found, m and rad.
    pub distance: [f64; 2],
    /// Number of branches missing relative to the nominal arm; at least one if the number found is
    /// odd.
    pub lost: u32,
    /// Whether further ones may be missing: some posture of an arm that only nearly belongs to its
    /// family is close to a singularity.
    pub uncertain: bool,
    /// The swivel angle, rad, or position of the locked joint that was used.
    pub redundancy: f64,
    /// Whether the second reference plane was used.
    pub second_plane: bool,
}

/// Intervals of the swivel angle of one branch.
#[derive(Debug, Clone, PartialEq)]
pub struct SwivelRange {
    /// Branch, one of eight.
    pub branch: Branch,
    /// From and to, rad, ascending within `[-pi, pi]`; an interval across pi is split in two.
    pub intervals: Vec<[f64; 2]>,
    /// The angle with the largest distance from the joint limits, and that distance, rad.
    pub best: Option<(f64, f64)>,
}

/// Options of a query in addition to the pose.
#[derive(Debug, Clone, PartialEq)]
pub struct Ask {
    /// For a redundant arm: swivel angle, rad, or position of the locked joint, rad or m.
    pub redundancy: f64,
    /// Reference of the swivel angle.
    pub reference: Reference,
    /// A posture near which free joints and whole turns are chosen; nearest solutions come first.
    pub near: Option<Vec<f64>>,
    /// Tolerated pose error, m and rad.
    pub tolerance: f64,
    /// Maximum number of Newton steps on a branch that is not exact at first: see [`Query::steps`].
    pub steps: usize,
}

impl Default for Ask {
    fn default() -> Self {
        let Query { redundancy, reference, tolerance, steps, .. } = Query::<1>::default();
        Self { redundancy, reference, near: None, tolerance, steps }
    }
}

/// Positions of a locked joint at which some posture respects the limits.
#[derive(Debug, Clone, PartialEq)]
pub struct LockedRange {
    /// From and to, rad or m, ascending.
    pub intervals: Vec<[f64; 2]>,
    /// The position with the largest distance from the joint limits, and that distance, rad or m.
    pub best: Option<(f64, f64)>,
}

/// Postures of a pose, and the admissible ranges of the redundancy.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Postures at one value of the redundancy.
    pub postures: Postures,
    /// Ranges of an arm with a swivel angle.
    pub swivel: Option<Vec<SwivelRange>>,
    /// Ranges of an arm with a locked joint.
    pub locked: Option<LockedRange>,
}

/// Solvers of all joint numbers behind one type.
trait Solver: Send + Sync {
    fn solve(&self, pose: &[[f64; 4]; 3], ask: &Ask) -> Result<Postures, PoseError>;
    fn redundancy(&self, q: &[f64], reference: &Reference) -> f64;
    fn locked_range(&self, pose: &[[f64; 4]; 3]) -> Result<Option<LockedRange>, PoseError>;
    fn swivel_ranges(&self, pose: &[[f64; 4]; 3], reference: &Reference)
    -> Result<Option<Vec<SwivelRange>>, PoseError>;
}

impl<const N: usize> Solver for Arm<N> {
    fn solve(&self, pose: &[[f64; 4]; 3], ask: &Ask) -> Result<Postures, PoseError> {
        let near: Option<[f64; N]> = ask.near.as_ref().and_then(|q| q.as_slice().try_into().ok());
        let query = Query {
            redundancy: ask.redundancy,
            reference: ask.reference,
            near: near.as_ref(),
            tolerance: ask.tolerance,
            steps: ask.steps,
        };
        let found = Arm::solve(self, pose, &query)?;
        let list = found.as_slice().iter().map(|s| Posture {
            q: s.q.to_vec(),
            branch: s.branch,
            position_error: s.position_error,
            rotation_error: s.rotation_error,
            within_limits: s.within_limits,
            margin: s.margin,
            free: (0..N).filter(|j| s.free >> j & 1 == 1).collect(),
        });
        Ok(Postures {
            status: found.status,
            list: list.collect(),
            distance: found.distance,
            lost: found.lost,
            uncertain: found.uncertain,
            redundancy: found.redundancy,
            second_plane: found.second_plane,
        })
    }

    fn redundancy(&self, q: &[f64], reference: &Reference) -> f64 {
        q.try_into().map_or(0.0, |q| Arm::redundancy(self, q, reference))
    }

    fn locked_range(&self, pose: &[[f64; 4]; 3]) -> Result<Option<LockedRange>, PoseError> {
        let ranges = self.locked_ranges(pose)?;
        Ok(ranges.map(|r| LockedRange { intervals: r.list.iter().copied().collect(), best: r.best }))
    }

    fn swivel_ranges(
        &self,
        pose: &[[f64; 4]; 3],
        reference: &Reference,
    ) -> Result<Option<Vec<SwivelRange>>, PoseError> {
        let mut ranges = Vec::with_capacity(8);
        // In the order of the solutions.
        for k in 0..8 {
            let sign = |bit: usize| if k >> bit & 1 == 0 { 1 } else { -1 };
            let (shoulder, elbow, wrist) = (sign(1), sign(2), sign(0));
            let branch = Branch { shoulder, elbow, wrist, root: 0, numerical: false };
            let Some(intervals) = self.swivel_intervals(pose, branch, reference)? else { return Ok(None) };
            let intervals = intervals.iter().map(|i| [i.from, i.to]).collect();
            ranges.push(SwivelRange { branch, intervals, best: self.best_swivel(pose, branch, reference)? });
        }
        Ok(Some(ranges))
    }
}

/// Inverse kinematics of one robot.
pub struct Kinematics {
    inverse: Inverse,
    solver: Box<dyn Solver>,
}

/// Maximum number of joints.
pub const MOST: usize = 8;

impl Kinematics {
    /// The inverse of a robot; `None` if it has more than [`MOST`] joints.
    pub fn new(robot: &Robot, model: &Model) -> Option<Self> {
        let inverse = Inverse::new(model.chain());
        let limits: Vec<_> = robot.moving().iter().map(|&i| robot.joints[i].limits.position).collect();
        fn boxed<const N: usize>(inverse: &Inverse, limits: &[Option<[f64; 2]>]) -> Option<Box<dyn Solver>> {
            Some(Box::new(inverse.arm::<N>(limits)?))
        }
        let solver = match limits.len() {
            1 => boxed::<1>(&inverse, &limits),
            2 => boxed::<2>(&inverse, &limits),
            3 => boxed::<3>(&inverse, &limits),
            4 => boxed::<4>(&inverse, &limits),
            5 => boxed::<5>(&inverse, &limits),
            6 => boxed::<6>(&inverse, &limits),
            7 => boxed::<7>(&inverse, &limits),
            8 => boxed::<MOST>(&inverse, &limits),
            _ => None,
        }?;
        Some(Self { inverse, solver })
    }

    /// Kinematic class, and the reason for it.
    pub fn inverse(&self) -> &Inverse {
        &self.inverse
    }

    /// All postures that bring the last DH frame to a pose: the top three rows of its homogeneous
    /// matrix, m.
    ///
    /// # Errors
    /// If an entry is not finite or the rotation is not a rotation matrix.
    pub fn solve(&self, pose: &[[f64; 4]; 3], ask: &Ask) -> Result<Postures, PoseError> {
        self.solver.solve(pose, ask)
    }

    /// Swivel angle or locked joint of a posture; zero for an arm that is not redundant.
    pub fn redundancy(&self, q: &[f64], reference: &Reference) -> f64 {
        self.solver.redundancy(q, reference)
    }

    /// Positions of the locked joint at which some posture respects the limits; `None` for an arm
    /// without one. See [`Arm::locked_ranges`] for narrow ranges.
    ///
    /// # Errors
    /// Like [`Kinematics::solve`].
    pub fn locked_range(&self, pose: &[[f64; 4]; 3]) -> Result<Option<LockedRange>, PoseError> {
        self.solver.locked_range(pose)
    }

    /// Intervals of the swivel angle of each of the eight branches under the joint limits, and its
    /// best value; `None` for an arm without one. For an arm that only nearly belongs to the
    /// family: those of the nominal arm.
    ///
    /// # Errors
    /// Like [`Kinematics::solve`].
    pub fn swivel_ranges(
        &self,
        pose: &[[f64; 4]; 3],
        reference: &Reference,
    ) -> Result<Option<Vec<SwivelRange>>, PoseError> {
        self.solver.swivel_ranges(pose, reference)
    }
}
