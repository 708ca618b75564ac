//! Interface of the control law to the robot.

use super::least::damped;

/// The tool frame at one position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tool<const N: usize> {
    /// Origin, m, world axes.
    pub origin: [f64; 3],
    /// Rotation from tool to world axes, rows.
    pub rotation: [[f64; 3]; 3],
    /// Jacobian of the origin in world axes, linear part first.
    pub jacobian: [[f64; N]; 6],
}

/// Functions of a robot with `N` joints that the two loops use.
pub trait Model<const N: usize> {
    /// Torques that hold the arm still, N m: the identified `G(q)`, the tool included.
    fn gravity(&mut self, q: &[f64; N]) -> [f64; N];

    /// Torques of a planned motion beyond gravity, N m: inertia, Coriolis, friction and other known
    /// torques of the drives, at the present posture with the planned velocity and acceleration.
    /// None by default: equation (13) of the paper.
    fn moving(&mut self, _q: &[f64; N], _dq: &[f64; N], _ddq: &[f64; N]) -> [f64; N] {
        [0.0; N]
    }

    /// Joint torques, N m, with which the tool exerts a force `along` (world axes, N): `J'` times
    /// it.
    fn pressing(&mut self, q: &[f64; N], along: &[f64; 3]) -> [f64; N];

    /// Frame and Jacobian of the point of contact; used where
    /// [`Settings::drag`](super::Settings::drag) is not 0. None by default: drag is not predicted.
    fn touch(&mut self, _q: &[f64; N]) -> Option<Tool<N>> {
        None
    }

    /// Posture whose tool has the orientation of `q`, displaced by `by` (m, world axes), with the
    /// redundancy of `q`; `near` is the last command. `None` if there is none.
    fn displaced(&mut self, q: &[f64; N], by: &[f64; 3], near: &[f64; N]) -> Option<[f64; N]>;
}

/// Functions of a robot with `N` joints that the force estimate uses.
pub trait Body<const N: usize> {
    /// Torques of the motion without contact, N m: bodies, tool and friction. `dt` (s) is the time
    /// since the previous call, for friction with memory.
    fn torques(&mut self, q: &[f64; N], dq: &[f64; N], ddq: &[f64; N], dt: f64) -> [f64; N];

    /// Possible deviation of each joint's friction from the last [`Body::torques`], N m, signed.
    /// After a reversal, friction takes an unknown travel to reverse. None by default.
    fn turning(&self) -> [f64; N] {
        [0.0; N]
    }

    /// Interval of each joint's friction about the last [`Body::torques`] if the joint stands,
    /// lower and upper deviation, N m. Static friction is anything within its breakaway level. None
    /// by default.
    fn static_friction(&self) -> [[f64; 2]; N] {
        [[0.0; 2]; N]
    }

    /// Frame and Jacobian of the point of contact.
    fn tool(&mut self, q: &[f64; N]) -> Tool<N>;
}

/// Computes [`Model::displaced`] from the Jacobian: Newton's method with least-norm joint steps,
/// from `q`. For arms without a closed form, and where the closed form has no solution.
pub fn moved<const N: usize>(
    q: &[f64; N],
    by: &[f64; 3],
    mut tool: impl FnMut(&[f64; N]) -> Tool<N>,
) -> Option<[f64; N]> {
    const STEPS: usize = 4;
    let start = tool(q);
    let mut at = *q;
    let mut here = start;
    for _ in 0..STEPS {
        let mut error = [0.0; 6];
        for k in 0..3 {
            error[k] = start.origin[k] + by[k] - here.origin[k];
        }
        // Half the sum of cross products of the axes: the remaining rotation, for small angles.
        for axis in 0..3 {
            let column = |r: &[[f64; 3]; 3]| [r[0][axis], r[1][axis], r[2][axis]];
            let (a, b) = (column(&here.rotation), column(&start.rotation));
            error[3] += 0.5 * (a[1] * b[2] - a[2] * b[1]);
            error[4] += 0.5 * (a[2] * b[0] - a[0] * b[2]);
            error[5] += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        }
        // J' (J J' + d)^-1 e with equal joint weights.
        let y = damped(&here.jacobian, &[1.0; N], &error, 1e-9)?;
        for j in 0..N {
            at[j] += (0..6).map(|i| here.jacobian[i][j] * y[i]).sum::<f64>();
        }
        here = tool(&at);
    }
    let missed = (0..3).fold(0.0_f64, |most, k| most.max((start.origin[k] + by[k] - here.origin[k]).abs()));
    (missed < 1e-5 && at.iter().all(|x| x.is_finite())).then_some(at)
}
