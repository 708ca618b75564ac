//! Joint velocities for a velocity of the last frame, within limits: damped least squares (Nakamura
//! and Hanafusa 1986) under bounds, by an active set. And the posture that is reached by such steps.

use super::arm::{Arm, checked, fitted};
use super::polish::{Rows, jacobian, remainder, sizes, slack, values};
use super::real::root;
use super::solution::{Branch, PoseError, Solution};

/// Options of [`Arm::velocities`] and [`Arm::approach`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Differential<const N: usize> {
    /// Largest speeds, rad/s or m/s; `None`: any.
    pub speeds: [Option<f64>; N],
    /// How long the velocities will be held, s: no joint passes a position limit of the arm within
    /// that time. Zero: position limits do not count.
    pub hold: f64,
    /// Velocities from which as little as possible is departed where the arm is redundant or damped,
    /// rad/s or m/s.
    pub preferred: [f64; N],
    /// Where damping begins: what of a joint's motion its neighbours cannot make, in rad and parts
    /// of a metre; the default is 0.03.
    pub near: f64,
    /// Damping at a singularity, in the same unit. A joint's speed there is at most that of the
    /// frame over twice the damping. The default is 0.03.
    pub damping: f64,
}

impl<const N: usize> Default for Differential<N> {
    fn default() -> Self {
        Self { speeds: [None; N], hold: 0.0, preferred: [0.0; N], near: 0.03, damping: 0.03 }
    }
}

/// Velocities that were found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Velocities<const N: usize> {
    /// rad/s or m/s, within the limits to the last bit.
    pub dq: [f64; N],
    /// Linear and angular part of the frame's velocity that they do not make, m/s and rad/s.
    pub left: [f64; 2],
    /// Bit `j`: joint `j` is at a limit.
    pub limited: u32,
}

/// Steps of [`Arm::approach`] at most, and the largest of a joint, rad or m.
const STEPS: usize = 200;
const STEP: f64 = 0.2;

/// Damping that only makes the solution unique: its square is well above what rounding leaves of the
/// equations, and what it takes from the frame's velocity is its square.
const LITTLE: f64 = 1e-5;

impl<const N: usize> Arm<N> {
    /// The arm whose last frame is a tool, given by its pose in the last DH frame: inverse, forward
    /// and differential kinematics are then the tool's.
    #[must_use]
    #[inline]
    pub fn with_tool(&self, tool: &super::Displacement) -> Self {
        Self { home: self.home.after(tool), ..*self }
    }

    /// Jacobian of the last frame's origin in world axes: rows 0-2 linear, 3-5 angular.
    pub fn jacobian(&self, q: &[f64; N]) -> [[f64; N]; 6] {
        let columns = jacobian(self, &values(self, q));
        let mut rows = [[0.0; N]; 6];
        for (k, column) in columns.iter().enumerate() {
            for (row, x) in rows.iter_mut().zip(column) {
                row[k] = *x;
            }
        }
        rows
    }

    /// Joint velocities that move the last frame's origin with `twist` (linear, m/s, then angular,
    /// rad/s, world axes): `|J dq - twist|^2 + l^2 |dq - preferred|^2` is the smallest that the
    /// limits allow. The damping `l` is nothing but beside a singularity.
    pub fn velocities(&self, q: &[f64; N], twist: &[f64; 6], options: &Differential<N>) -> Velocities<N> {
        let columns = jacobian(self, &values(self, q));
        let whole: [Rows; N] = columns.map(|[a, b, c, d, e, f]| [a, b, c, d, e, f, 0.0]);
        let regular = slack(&whole, 1.0, N.min(6)) / options.near.max(1e-150);
        let damping = if regular < 1.0 { options.damping * root(1.0 - regular * regular) } else { 0.0 };
        let (mut low, mut high) = ([f64::NEG_INFINITY; N], [f64::INFINITY; N]);
        for k in 0..N {
            let speed = options.speeds[k].map_or(f64::INFINITY, f64::abs);
            (low[k], high[k]) = (-speed, speed);
            if let (Some([from, to]), true) = (self.limits[k], options.hold > 0.0) {
                // From beyond a limit back to it.
                low[k] = ((from - q[k]) / options.hold).max(-speed).min(speed);
                high[k] = ((to - q[k]) / options.hold).max(-speed).min(speed).max(low[k]);
            }
        }
        let square = (damping * damping).max(LITTLE * LITTLE);
        let (mut matrix, mut right) = ([[0.0; N]; N], [0.0; N]);
        for i in 0..N {
            for j in 0..N {
                matrix[i][j] = product(&columns[i], &columns[j]);
            }
            matrix[i][i] += square;
            right[i] = product(&columns[i], twist) + square * options.preferred[i];
        }
        let (dq, limited) = bounded(&matrix, &right, &low, &high);
        let mut left = *twist;
        for (column, x) in columns.iter().zip(&dq) {
            for (l, c) in left.iter_mut().zip(column) {
                *l -= c * x;
            }
        }
        Velocities { dq, left: sizes(&left), limited }
    }

    /// The posture that small steps from `start` lead to: of a redundant arm near the nearest one,
    /// without a jump, and within the position limits all the way if `start` is. It is a solution if
    /// the pose was reached to `tolerance`, m and rad; the limits may be in the way, or the pose out
    /// of reach from there: then `None`.
    ///
    /// # Errors
    /// Like [`Arm::solve`].
    pub fn approach(
        &self,
        pose: &[[f64; 4]; 3],
        start: &[f64; N],
        tolerance: f64,
        options: &Differential<N>,
    ) -> Result<Option<Solution<N>>, PoseError> {
        let g = checked(pose)?.after(&self.home.inverse());
        if !start.iter().all(|x| x.is_finite()) {
            return Err(PoseError::NotFinite(3, 0));
        }
        let mut q = *start;
        let mut options = Differential { hold: 1.0, preferred: [0.0; N], ..*options };
        options.speeds = [Some(STEP); N];
        for _ in 0..STEPS {
            let left = remainder(self, &g, &values(self, &q));
            let [p, r] = sizes(&left);
            if p <= tolerance && r <= tolerance {
                let margin = q
                    .iter()
                    .zip(self.limits)
                    .fold(f64::INFINITY, |m, (q, limits)| m.min(fitted(*q, true, limits, None).1));
                let branch = Branch { numerical: true, root: 1, ..Branch::NONE };
                let found = Solution { q, branch, position_error: p, rotation_error: r, ..Solution::NONE };
                return Ok(Some(Solution { margin, within_limits: margin >= -1e-9, ..found }));
            }
            // What a step of the largest length can do.
            let much = (p.max(r) / 0.5).max(1.0);
            let found = self.velocities(&q, &left.map(|x| x / much), &options);
            let mut most = 0.0f64;
            for (q, d) in q.iter_mut().zip(found.dq) {
                *q += d;
                most = most.max(d.abs());
            }
            for (q, limits) in q.iter_mut().zip(self.limits) {
                // What rounding adds to a step that ends at a limit.
                if let Some([low, high]) = limits
                    && (low - 1e-9..=high + 1e-9).contains(q)
                {
                    *q = q.max(low).min(high);
                }
            }
            if most < 1e-15 {
                break;
            }
        }
        Ok(None)
    }

    /// The pose in single precision, for who holds it so; computed in double precision, as a closed
    /// form loses more digits beside a singularity than single precision has. The tolerance of the
    /// query is at least `1e-6`.
    ///
    /// # Errors
    /// Like [`Arm::solve`]; the rotation's defect must be below 1e-6, too.
    pub fn solve_f32(
        &self,
        pose: &[[f32; 4]; 3],
        query: &super::Query<'_, N>,
    ) -> Result<super::Solutions<N>, PoseError> {
        let pose = pose.map(|row| row.map(f64::from));
        self.solve(&pose, &super::Query { tolerance: query.tolerance.max(1e-6), ..*query })
    }
}

impl<const N: usize> Solution<N> {
    /// The positions in single precision.
    #[must_use]
    pub fn q_f32(&self) -> [f32; N] {
        self.q.map(|x| x as f32)
    }
}

fn product(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    a.iter().zip(b).fold(0.0, |s, (x, y)| s + x * y)
}

/// Where an entry is.
#[derive(Clone, Copy, PartialEq)]
enum At {
    Free,
    Low,
    High,
}

/// The smallest `x' A x / 2 - b' x` with `low <= x <= high`, `A` positive definite: a primal active
/// set (Nocedal and Wright, 16.5). Bits: entries at a bound.
fn bounded<const N: usize>(a: &[[f64; N]; N], b: &[f64; N], low: &[f64; N], high: &[f64; N]) -> ([f64; N], u32) {
    let mut x = [0.0; N];
    let mut at = [At::Free; N];
    for k in 0..N {
        x[k] = 0.0f64.max(low[k]).min(high[k]);
    }
    // Each round adds an entry to the bounds or lets one go; ties are cut short.
    for _ in 0..8 * N {
        let goal = free(a, b, &x, &at);
        let (mut part, mut stop) = (1.0, None);
        for k in 0..N {
            let way = goal[k] - x[k];
            if at[k] != At::Free || way == 0.0 {
                continue;
            }
            let (bound, side) = if way > 0.0 { (high[k], At::High) } else { (low[k], At::Low) };
            let reach = (bound - x[k]) / way;
            if reach < part {
                (part, stop) = (reach.max(0.0), Some((k, side, bound)));
            }
        }
        for k in 0..N {
            if at[k] == At::Free {
                x[k] = (x[k] + part * (goal[k] - x[k])).max(low[k]).min(high[k]);
            }
        }
        if let Some((k, side, bound)) = stop {
            if let (Some(place), Some(x)) = (at.get_mut(k), x.get_mut(k)) {
                (*place, *x) = (side, bound);
            }
            continue;
        }
        let (mut worst, mut release) = (1e-12, None);
        for k in 0..N {
            let slope = a[k].iter().zip(&x).fold(-b[k], |s, (a, x)| s + a * x);
            let pull = match at[k] {
                At::Free => 0.0,
                At::Low if low[k] < high[k] => -slope,
                At::High if low[k] < high[k] => slope,
                _ => 0.0,
            };
            if pull > worst {
                (worst, release) = (pull, Some(k));
            }
        }
        match release.and_then(|k| at.get_mut(k)) {
            Some(place) => *place = At::Free,
            None => break,
        }
    }
    let bits = at.iter().enumerate().fold(0, |bits, (k, at)| bits | u32::from(*at != At::Free) << (k & 31));
    (x, bits)
}

/// The smallest where entries at a bound stay, by Cholesky.
fn free<const N: usize>(a: &[[f64; N]; N], b: &[f64; N], x: &[f64; N], at: &[At; N]) -> [f64; N] {
    let (mut l, mut y) = ([[0.0; N]; N], [0.0; N]);
    for i in 0..N {
        let loose = at[i] == At::Free;
        y[i] = if loose { b[i] } else { x[i] };
        for j in 0..N {
            if loose && at[j] != At::Free {
                y[i] -= a[i][j] * x[j];
            }
            if j <= i {
                l[i][j] = if loose && at[j] == At::Free { a[i][j] } else { f64::from(u8::from(i == j)) };
            }
        }
    }
    for i in 0..N {
        for j in 0..=i {
            let mut sum = l[i][j];
            for k in 0..j {
                sum -= l[i][k] * l[j][k];
            }
            l[i][j] = if i == j { root(sum).max(1e-150) } else { sum / l[j][j] };
        }
        for k in 0..i {
            y[i] -= l[i][k] * y[k];
        }
        y[i] /= l[i][i];
    }
    for i in (0..N).rev() {
        for k in i + 1..N {
            y[i] -= l[k][i] * y[k];
        }
        y[i] /= l[i][i];
    }
    y
}
