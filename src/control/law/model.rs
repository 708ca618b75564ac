//! The law's view of the robot.

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

/// Functions that the two loops need of a robot with `N` joints.
pub trait Model<const N: usize> {
    /// Torques that hold the arm still, N m: the identified `G(q)`, the tool included.
    fn gravity(&mut self, q: &[f64; N]) -> [f64; N];

    /// Torques of a planned motion beyond gravity, N m: inertia, Coriolis, friction and other known
    /// torques of the drives, at the present posture with the planned velocity and acceleration.
    /// None by default: equation (13) of the paper.
    fn moving(&mut self, _q: &[f64; N], _dq: &[f64; N], _ddq: &[f64; N]) -> [f64; N] {
        [0.0; N]
    }

    /// Torques with which the tool presses by a force (world axes, N): `J'` times it.
    fn pressing(&mut self, q: &[f64; N], along: &[f64; 3]) -> [f64; N];

    /// Frame and Jacobian of the point that touches; read where
    /// [`Settings::drag`](super::Settings::drag) is not 0. None by default: drag is not predicted.
    fn touch(&mut self, _q: &[f64; N]) -> Option<Tool<N>> {
        None
    }

    /// A posture whose tool has the orientation of `q`, moved by `by` (m, world axes), with the
    /// arm's redundancy of `q`; `near` is the last command. `None` where there is none.
    fn displaced(&mut self, q: &[f64; N], by: &[f64; 3], near: &[f64; N]) -> Option<[f64; N]>;
}

/// Functions that the force estimate needs of it.
pub trait Body<const N: usize> {
    /// Torques of the motion without contact, N m: bodies, tool and friction; `dt` (s) since the
    /// call before, for friction with memory.
    fn torques(&mut self, q: &[f64; N], dq: &[f64; N], ddq: &[f64; N], dt: f64) -> [f64; N];

    /// Possible deviation of the friction of each joint from the last [`Body::torques`], N m, less
    /// where negative. Friction takes an unknown way to turn round with its joint. None by default.
    fn turning(&self) -> [f64; N] {
        [0.0; N]
    }

    /// Interval of the friction of each joint about the last [`Body::torques`], less and more, N m,
    /// if the joint stands: static friction is anything within its breakaway level. None by
    /// default.
    fn static_friction(&self) -> [[f64; 2]; N] {
        [[0.0; 2]; N]
    }

    /// Frame and Jacobian of the point where contact is.
    fn tool(&mut self, q: &[f64; N]) -> Tool<N>;
}

/// [`Model::displaced`] by the Jacobian: Newton's steps with the least joint motion, from `q`. For
/// arms without a closed form, and where the closed form finds nothing.
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
        // Half the sum of cross products of the axes: the rotation that is left, for small angles.
        for axis in 0..3 {
            let column = |r: &[[f64; 3]; 3]| [r[0][axis], r[1][axis], r[2][axis]];
            let (a, b) = (column(&here.rotation), column(&start.rotation));
            error[3] += 0.5 * (a[1] * b[2] - a[2] * b[1]);
            error[4] += 0.5 * (a[2] * b[0] - a[0] * b[2]);
            error[5] += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        }
        // J' (J J' + d)^-1 e: joints weigh the same.
        let y = damped(&here.jacobian, &[1.0; N], &error, 1e-9)?;
        for j in 0..N {
            at[j] += (0..6).map(|i| here.jacobian[i][j] * y[i]).sum::<f64>();
        }
        here = tool(&at);
    }
    let missed = (0..3).fold(0.0_f64, |most, k| most.max((start.origin[k] + by[k] - here.origin[k]).abs()));
    (missed < 1e-5 && at.iter().all(|x| x.is_finite())).then_some(at)
}
