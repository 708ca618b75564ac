//! What the rooms that work on data see of a robot: a trait, never a file.

use crate::identify::PriorBody;

/// Joint motion of a block of samples, joint-major: sample `s` of joint `j` stands at `j * len + s`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct States {
    /// Number of samples.
    pub len: usize,
    /// Positions, rad or m, `dof * len`.
    pub q: Vec<f64>,
    /// Velocities, rad/s or m/s, `dof * len`.
    pub dq: Vec<f64>,
    /// Accelerations, rad/s^2 or m/s^2, `dof * len`.
    pub ddq: Vec<f64>,
}

/// A sum of two velocities: that of a motor that turns with two joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VelocitySum {
    /// Degrees of freedom.
    pub joints: [usize; 2],
    /// What the second one's velocity is multiplied by.
    pub ratio: f64,
}

impl VelocitySum {
    /// Of velocities by joint, rad/s; zero where there is no such joint.
    pub fn at<'a>(&self, dq: impl Fn(usize) -> Option<&'a [f64]>) -> Vec<f64> {
        let [a, b] = self.joints.map(dq);
        let len = a.or(b).map_or(0, <[f64]>::len);
        let of = |x: Option<&[f64]>, s: usize| x.map_or(0.0, |x| x[s]);
        (0..len).map(|s| of(a, s) + self.ratio * of(b, s)).collect()
    }
}

/// Entries of a regressor that are multiples of the sign of a sum of velocities.
#[derive(Debug, Clone, PartialEq)]
pub struct SummedSign {
    /// The sum.
    pub sum: VelocitySum,
    /// Index into [`Arm::base_pattern`], and factor.
    pub entries: Vec<(usize, f64)>,
}

/// A base parameter: an identifiable combination of standard parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseParameter {
    /// Name of its leader, with `R` where it groups others: `ZZ1R`, `MSY7`, `FC3`.
    pub name: String,
    /// `ZZ1R = ZZ1 + YY2 + ...`, in the constants of the robot file.
    pub grouping: String,
    /// Index into the standard parameters, and factor.
    pub coefficients: Vec<(usize, f64)>,
    /// Unit.
    pub unit: String,
}

/// What an arm's numbers stand for.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Description {
    /// The robot's name.
    pub name: String,
    /// Degrees of freedom, `n`.
    pub dof: usize,
    /// Names of the standard parameters, `P`, in the order of contract section 2.
    pub standard: Vec<String>,
    /// The base parameters, `B`, in the order of the base regressor's columns.
    pub base: Vec<BaseParameter>,
    /// Rows and columns of the base regressor's structural nonzeros, sorted by row, then column.
    pub pattern: Vec<(usize, usize)>,
}

/// An arm with `n` degrees of freedom, `P` standard and `B` base parameters.
///
/// Torques are those of the actuators on the links, N m (N for a prismatic joint), positive in the direction in which `q` grows.
pub trait Arm: Sync {
    /// Sizes, names and zeros.
    fn description(&self) -> &Description;

    /// The robot's name.
    fn name(&self) -> &str {
        &self.description().name
    }

    /// Degrees of freedom, `n`.
    fn dof(&self) -> usize {
        self.description().dof
    }

    /// Names of the standard parameters, `P`, in the order of contract section 2.
    fn standard_names(&self) -> &[String] {
        &self.description().standard
    }

    /// The base parameters, `B`, in the order of the base regressor's columns.
    fn base_parameters(&self) -> &[BaseParameter] {
        &self.description().base
    }

    /// Rows and columns of the base regressor's structural nonzeros, sorted by row, then column.
    fn base_pattern(&self) -> &[(usize, usize)] {
        &self.description().pattern
    }

    /// The base regressor at every sample: entry `k` of [`Arm::base_pattern`] at sample `s` goes to `out[k * len + s]`.
    /// `tau = W_b beta` (Khalil and Dombre, equation 12.21).
    fn base_regressor(&self, states: &States, out: &mut [f64]);

    /// Entries that have the sign of a sum of velocities in them, as the Coulomb columns have that of one velocity. Who filters a
    /// recording filters these signs too (see [`crate::signal::Prepare::sums`]).
    fn summed_signs(&self) -> Vec<SummedSign> {
        Vec::new()
    }

    /// Torques from standard parameters (`P`), joint-major like the states.
    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]);
}

/// An arm whose torque sensors can be foretold: bodies, drives, and every effect that is known of them.
///
/// Torques are what the sensors say, N m, joint-major like the states, `dof * len`.
pub trait Predicted: Sync {
    /// Degrees of freedom, `n`.
    fn dof(&self) -> usize;

    /// From the present state alone: friction with memory has slipped (`sign(dq)`), gears are warm, nothing is late.
    fn torques(&self, states: &States, out: &mut [f64]);

    /// Along recorded motion: `time` (s, one per sample; where it does not rise another recording begins) lets bristles bend, gears warm
    /// and torques be late; `temperature` (deg C, joint-major) may be empty.
    fn torques_along(&self, time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]);

    /// How late each joint's torque is, s.
    fn delays(&self) -> Vec<f64>;

    /// What each joint's sensor makes of its true torque: gain, and offset (N m) that is added. True torques, as a controller has to command
    /// them, are `(measured - offset) / gain`.
    fn sensors(&self) -> Vec<[f64; 2]>;

    /// Breakaway level of each joint's static friction, N m, where a law of its drive gives one.
    fn breakaways(&self) -> Vec<Option<f64>> {
        vec![None; self.dof()]
    }
}

/// A change of an arm that none of its parameters can express.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Change {
    /// The base is turned by `RotY(pitch) RotX(roll)`, rad, against where its file says it stands.
    Base {
        /// About x, rad.
        roll: f64,
        /// About y, rad.
        pitch: f64,
    },
    /// A row of the DH table is longer or more twisted than its file says.
    Row {
        /// Number of the row, from 0.
        row: usize,
        /// Added to `alpha`, rad.
        alpha: f64,
        /// Added to `d`, m.
        d: f64,
        /// Added to `theta`, rad.
        theta: f64,
        /// Added to `r`, m.
        r: f64,
    },
}

/// An arm whose geometry can be questioned: what a diagnosis needs beyond [`Arm`].
pub trait Plant: Arm {
    /// Row of each joint, from 0, base to tip.
    fn rows(&self) -> &[usize];

    /// Motor turns per joint turn, where the file tells.
    fn gear_ratios(&self) -> &[Option<f64>];

    /// Values of the standard parameters in the file (`P`); `None` where it has no links.
    fn given(&self) -> Option<&[f64]>;

    /// Value of a drive parameter (index into the standard parameters) in the file, whether or not it has links.
    fn given_drive(&self, index: usize) -> f64;

    /// Effects that the file knows beyond rotors, `FV`, `FC` and `FO`: identifier of contract section 5 and joint (from 0; `None`: the whole robot). Those of
    /// geometry and bodies are in the arm itself, delays in [`Plant::delays`], the rest in [`Plant::known`].
    fn effects(&self) -> Vec<(String, Option<usize>)> {
        Vec::new()
    }

    /// How late the file says each joint's torque is, s.
    fn delays(&self) -> Vec<f64> {
        vec![0.0; self.dof()]
    }

    /// What the file's effects add to the recorded torques beside the plain arm (which is as late), N m, joint-major like the states, along recorded motion as
    /// in [`Predicted::torques_along`]. `false`: nothing, and `out` is as it was.
    fn known(&self, _time: &[f64], _states: &States, _temperature: &[f64], _out: &mut [f64]) -> bool {
        false
    }

    /// By how much each joint has to travel, rad or m, until it does not matter in which state the file's friction with memory began.
    fn settling(&self) -> Vec<f64> {
        vec![0.0; self.dof()]
    }

    /// What the links' bodies are looked for near; `None` where nothing is known of their size.
    fn bodies(&self) -> Option<LikelyBodies> {
        None
    }

    /// The same arm whose file does not know some of its [`Plant::effects`].
    fn without(&self, _effects: &[(String, Option<usize>)]) -> Option<Box<dyn Plant>> {
        None
    }

    /// [`Arm::inverse_dynamics`] of the arm with a change: torques, N m (N for a prismatic joint), of all joints, joint-major like the states,
    /// from the standard parameters (`P`, SI) of the unchanged arm's frames.
    fn changed_dynamics(&self, change: &Change, states: &States, standard: &[f64], out: &mut [f64]);

    /// `J'`: the torque on joint `j` of a unit of component `c` (`fx fy fz mx my mz`, at the origin of the last frame, in its axes or in the
    /// base's) of a wrench on it at sample `s` goes to `out[(c * n + j) * len + s]`.
    fn wrench_columns(&self, states: &States, base: bool, out: &mut [f64]);
}

/// Bodies that an arm's links are likely to have.
#[derive(Debug, Clone, PartialEq)]
pub struct LikelyBodies {
    /// One per link, without what is fixed to it.
    pub prior: Vec<PriorBody>,
    /// Known bodies that are fixed to links (from 0), in the link's frame: a tool. The standard parameters contain them.
    pub carried: Vec<(usize, [f64; 10])>,
}

/// The tool frame of an arm at one position.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ToolState {
    /// Top three rows of its homogeneous matrix in base axes, row-major.
    pub pose: [f64; 12],
    /// Jacobian of its origin in base axes, linear part first, `6 x n`, row-major.
    pub jacobian: Vec<f64>,
}

/// The bodies of an arm with given inertial parameters, one state at a time: what a simulation needs. No drives: neither rotors nor
/// friction.
pub trait Dynamics {
    /// Degrees of freedom, `n`.
    fn dof(&self) -> usize;

    /// `M(q)`, `n x n`, row-major.
    fn mass_matrix(&mut self, q: &[f64], mass: &mut [f64]);

    /// `c(q, dq) + g(q)`, `n`.
    fn bias(&mut self, q: &[f64], dq: &[f64], bias: &mut [f64]);

    /// Frame and Jacobian of the tool, of the last frame where there is none.
    fn tool(&mut self, q: &[f64], tool: &mut ToolState);
}

/// An arm whose frames and Jacobian are asked for in batches: what it takes to plan a motion in space.
pub trait Placed: Arm {
    /// Number of frames: the rows of the DH table and, where there is a tool, its frame.
    fn frame_count(&self) -> usize;

    /// Top three rows of each frame's homogeneous matrix in the base frame, lengths in m: entry `(frame, row, column)` at
    /// `((frame * 3 + row) * 4 + column) * len + s`.
    fn frames(&self, states: &States, out: &mut [f64]);

    /// Jacobian of the last DH frame's origin in base axes, linear part first: entry `(row, joint)` at `(row * n + joint) * len + s`.
    fn jacobian(&self, states: &States, out: &mut [f64]);
}

/// Where the bodies of an arm are, roughly: what is known of them without any weighing.
pub trait Reach {
    /// For each link, in its own frame: where its body ends that begins at the frame's origin, m. The next joint for the modified
    /// convention, the joint before for the standard one, the tool (or the origin) for the last link.
    fn ends(&self) -> Vec<[f64; 3]>;

    /// Of each moving joint: least and largest position (half a turn, or half a metre, to both sides where the file has none), and
    /// largest speed (1 rad/s or m/s where the file has none).
    fn ranges(&self) -> Vec<[f64; 3]>;
}

/// An arm that can tell what a body in its hand adds to the torques.
pub trait Payload: Arm {
    /// Rows and columns of the structural nonzeros of the payload regressor, sorted by row, then column. Columns are the body's ten
    /// parameters `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin; in the last DH frame where the robot has
    /// no tool.
    fn payload_pattern(&self) -> &[(usize, usize)];

    /// The payload regressor at every sample: entry `k` of [`Payload::payload_pattern`] at sample `s` goes to `out[k * len + s]`.
    /// A body adds `W_L Phi_L` to the torques (the paper's equation 7).
    fn payload_regressor(&self, states: &States, out: &mut [f64]);
}

pub use dh_codegen::pullback::Gradient;

/// An [`Arm`] whose quantities can be differentiated, by products with the transposed Jacobian ("vector-Jacobian products"):
/// `seeds` has one weight per entry and sample, laid out like the quantity itself, and `d(sum of seeds * entries)` by `q`, `dq` and
/// `ddq` of each sample is *added* to a [`Gradient`] whose parts have `dof * len` entries.
pub trait Differentiable: Arm {
    /// Of [`Arm::base_regressor`]; seed of entry `k` of the pattern at sample `s` at `k * len + s`. A sign has derivative zero.
    fn base_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);

    /// Entries of the base pattern that are the sign of a joint's velocity and nothing else (Coulomb friction), and the joint.
    fn coulomb_entries(&self) -> &[(usize, usize)];

    /// Rows and columns of the structural nonzeros of [`Differentiable::payload_regressor`].
    fn payload_pattern(&self) -> &[(usize, usize)];

    /// Ten columns `M MSX .. YZ` of a body in the tool frame, `n x 10`, laid out like the base regressor.
    fn payload_regressor(&self, states: &States, out: &mut [f64]);

    /// Of [`Differentiable::payload_regressor`].
    fn payload_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);

    /// Of [`Arm::inverse_dynamics`].
    fn inverse_dynamics_vjp(&self, states: &States, standard: &[f64], seeds: &[f64], to: &mut Gradient);

    /// Number of frames: the rows of the DH table and, where there is a tool, its frame.
    fn frame_count(&self) -> usize;

    /// Top three rows of each frame's homogeneous matrix in the base frame, lengths in m: entry `(frame, row, column)` at
    /// `((frame * 3 + row) * 4 + column) * len + s`.
    fn frames(&self, states: &States, out: &mut [f64]);

    /// Of [`Differentiable::frames`].
    fn frames_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient);
}
