//! The arm as a data-driven method sees it: its regressor and its torques.

use dh_codegen::arm::param::DriveTerm;

use super::parameter::StandardParameter;

/// Joint motion of a block of samples, joint-major: sample `s` of joint `j` is at index `j * len +
/// s`.
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

impl States {
    /// All zero: `dof` joints, `len` samples.
    pub fn zeros(dof: usize, len: usize) -> Self {
        Self { len, q: vec![0.0; dof * len], dq: vec![0.0; dof * len], ddq: vec![0.0; dof * len] }
    }

    /// Positions, velocities and accelerations of each joint, base to tip, `len` samples each.
    pub fn by_joint(&self) -> Vec<[&[f64]; 3]> {
        let row = |j: usize| [&self.q, &self.dq, &self.ddq].map(|x| &x[j * self.len..(j + 1) * self.len]);
        (0..self.q.len().checked_div(self.len).unwrap_or(0)).map(row).collect()
    }

    /// The samples with these indices.
    #[must_use]
    pub fn gather(&self, picks: &[usize]) -> Self {
        let of =
            |all: &[f64]| all.chunks_exact(self.len.max(1)).flat_map(|row| picks.iter().map(|&s| row[s])).collect();
        Self { len: picks.len(), q: of(&self.q), dq: of(&self.dq), ddq: of(&self.ddq) }
    }

    /// Samples `from..to`; empty parts stay empty.
    #[must_use]
    pub fn part(&self, from: usize, to: usize) -> Self {
        let of = |all: &[f64]| part(all, self.len, from, to);
        Self { len: to - from, q: of(&self.q), dq: of(&self.dq), ddq: of(&self.ddq) }
    }
}

/// Samples `from..to` of each row of `len`.
pub(super) fn part(all: &[f64], len: usize, from: usize, to: usize) -> Vec<f64> {
    all.chunks_exact(len.max(1)).map(|row| &row[from..to]).collect::<Vec<_>>().concat()
}

/// A weighted sum of two joint velocities: that of a motor coupled to two joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VelocitySum {
    /// Degrees of freedom.
    pub joints: [usize; 2],
    /// Factor of the second joint's velocity.
    pub ratio: f64,
}

impl VelocitySum {
    /// The sum for velocities by joint, rad/s; a missing joint counts as zero.
    pub fn at<'a>(&self, dq: impl Fn(usize) -> Option<&'a [f64]>) -> Vec<f64> {
        let [a, b] = self.joints.map(dq);
        let len = a.or(b).map_or(0, <[f64]>::len);
        let of = |x: Option<&[f64]>, s: usize| x.map_or(0.0, |x| x[s]);
        (0..len).map(|s| of(a, s) + self.ratio * of(b, s)).collect()
    }
}

/// Entries of a regressor that are proportional to the sign of a sum of velocities.
#[derive(Debug, Clone, PartialEq)]
pub struct SummedSign {
    /// The sum of velocities.
    pub sum: VelocitySum,
    /// Index into [`Arm::base_pattern`], and factor, of each entry.
    pub entries: Vec<(usize, f64)>,
}

/// A base parameter: an identifiable combination of standard parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseParameter {
    /// The standard parameter whose column it keeps.
    pub leader: StandardParameter,
    /// Name of its leader, with `R` where it groups others: `ZZ1R`, `MSY7`, `FC3`.
    pub name: String,
    /// `ZZ1R = ZZ1 + YY2 + ...`, in the constants of the robot file.
    pub grouping: String,
    /// Index into the standard parameters, and factor.
    pub coefficients: Vec<(usize, f64)>,
    /// Unit of its value.
    pub unit: String,
}

impl BaseParameter {
    /// Whether it is a drive parameter of this kind. Its column then has entries in the row of its
    /// own joint only.
    pub fn is_drive_term(&self, term: DriveTerm) -> bool {
        matches!(self.leader, StandardParameter::Drive(_, own) if own == term)
    }
}

/// Sizes, names and structural zeros of an arm.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Description {
    /// The robot's name.
    pub name: String,
    /// Degrees of freedom, `n`.
    pub dof: usize,
    /// The standard parameters, `P`, in the order of robots/README.md.
    pub standard: Vec<StandardParameter>,
    /// The base parameters, `B`, in the order of the base regressor's columns.
    pub base: Vec<BaseParameter>,
    /// Rows and columns of the base regressor's structural nonzeros, sorted by row, then column.
    pub pattern: Vec<(usize, usize)>,
}

/// An arm with `n` degrees of freedom, `P` standard and `B` base parameters.
///
/// Torques are those of the actuators on the links, N m (N for a prismatic joint), positive in the
/// direction in which `q` grows.
pub trait Arm: Sync {
    /// Sizes, names and structural zeros.
    fn description(&self) -> &Description;

    /// The robot's name.
    fn name(&self) -> &str {
        &self.description().name
    }

    /// Degrees of freedom, `n`.
    fn dof(&self) -> usize {
        self.description().dof
    }

    /// The standard parameters, `P`, in the order of robots/README.md.
    fn standard_parameters(&self) -> &[StandardParameter] {
        &self.description().standard
    }

    /// Names of the standard parameters.
    fn standard_names(&self) -> Vec<String> {
        self.standard_parameters().iter().map(StandardParameter::to_string).collect()
    }

    /// The base parameters, `B`, in the order of the base regressor's columns.
    fn base_parameters(&self) -> &[BaseParameter] {
        &self.description().base
    }

    /// Rows and columns of the base regressor's structural nonzeros, sorted by row, then column.
    fn base_pattern(&self) -> &[(usize, usize)] {
        &self.description().pattern
    }

    /// The base regressor at every sample: entry `k` of [`Arm::base_pattern`] at sample `s` goes to
    /// `out[k * len + s]`. `tau = W_b beta` (Khalil and Dombre, equation 12.21).
    fn base_regressor(&self, states: &States, out: &mut [f64]);

    /// Torques from base parameters (`B`), N m (N for a prismatic joint), joint-major like the
    /// states: `W_b beta` (Khalil and Dombre, equation 12.21).
    fn base_torques(&self, states: &States, base: &[f64], out: &mut [f64]) {
        let pattern = self.base_pattern();
        let mut entries = vec![0.0; pattern.len() * states.len];
        self.base_regressor(states, &mut entries);
        out.fill(0.0);
        for (entry, &(row, column)) in entries.chunks_exact(states.len.max(1)).zip(pattern) {
            let to = &mut out[row * states.len..(row + 1) * states.len];
            to.iter_mut().zip(entry).for_each(|(t, w)| *t += w * base[column]);
        }
    }

    /// Entries that contain the sign of a sum of velocities, as the Coulomb columns contain that of
    /// one velocity. A filtered recording must filter these signs too (see
    /// [`crate::data::signal::Prepare::sums`]).
    fn summed_signs(&self) -> Vec<SummedSign> {
        Vec::new()
    }

    /// Torques from standard parameters (`P`), joint-major like the states.
    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]);
}
