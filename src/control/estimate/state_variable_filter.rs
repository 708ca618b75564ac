//! Velocity and acceleration computed online, sample by sample, and torques with the same delay.

use crate::control::estimate::small_matrix::times;

/// A third-order Butterworth low-pass whose states are the signal and its first two derivatives
/// ("state-variable filter"). Positions and torques pass through the same filter, so that all have
/// the same delay: `2 / (2 pi cutoff)` for slow signals.
#[derive(Debug, Clone, PartialEq)]
pub struct StateVariableFilter<const N: usize> {
    /// Exact transition over one period. With it, `rise`: the increment for an input that rises by
    /// 1 on a straight line. A staircase input would leave ripples on the acceleration of a fast
    /// motion.
    step: [[f64; 3]; 3],
    rise: [f64; 3],
    motion: [Channel; N],
    torque: [Channel; N],
    begun: bool,
}

/// State (signal, first and second derivative) and the previous input.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Channel {
    state: [f64; 3],
    input: f64,
}

impl<const N: usize> StateVariableFilter<N> {
    /// Creates a filter with this cutoff frequency, Hz, for samples every `period` s.
    pub fn new(cutoff: f64, period: f64) -> Self {
        let w = 2.0 * core::f64::consts::PI * cutoff;
        // x''' = w^3 (u - x) - 2 w^2 x' - 2 w x'', u' = s, s' = 0: matrix exponential of the five
        // by five, by squaring a short Taylor series.
        let mut a = [[0.0; 5]; 5];
        (a[0][1], a[1][2], a[3][4]) = (1.0, 1.0, 1.0);
        a[2] = [-w * w * w, -2.0 * w * w, -2.0 * w, w * w * w, 0.0];
        let mut exp = taylor(&a, period / 64.0);
        for _ in 0..6 {
            exp = product(&exp, &exp);
        }
        Self {
            step: core::array::from_fn(|i| core::array::from_fn(|j| exp[i][j])),
            rise: core::array::from_fn(|i| exp[i][4] / period),
            motion: [Channel::default(); N],
            torque: [Channel::default(); N],
            begun: false,
        }
    }

    /// Processes a sample; the arm is assumed to be at rest at the first one.
    pub fn push(&mut self, q: &[f64; N], tau: &[f64; N]) {
        for j in 0..N {
            for (channel, input) in [(&mut self.motion[j], q[j]), (&mut self.torque[j], tau[j])] {
                if !input.is_finite() {
                    continue;
                }
                if !self.begun {
                    *channel = Channel { state: [input, 0.0, 0.0], input };
                }
                // Relative to the previous input, so that a constant signal stays exact.
                let Channel { state: [x, dx, ddx], input: before } = *channel;
                let next = times(&self.step, &[x - before, dx, ddx]);
                let climbed: [f64; 3] = core::array::from_fn(|i| next[i] + self.rise[i] * (input - before));
                *channel = Channel { state: [climbed[0] + before, climbed[1], climbed[2]], input };
            }
        }
        self.begun = true;
    }

    /// Filtered positions, rad.
    pub fn q(&self) -> [f64; N] {
        self.motion.map(|c| c.state[0])
    }

    /// Velocities, rad/s.
    pub fn dq(&self) -> [f64; N] {
        self.motion.map(|c| c.state[1])
    }

    /// Accelerations, rad/s^2.
    pub fn ddq(&self) -> [f64; N] {
        self.motion.map(|c| c.state[2])
    }

    /// Filtered torques, N m.
    pub fn tau(&self) -> [f64; N] {
        self.torque.map(|c| c.state[0])
    }

    /// Standard deviations of the filtered signal, its velocity and its acceleration for white
    /// input noise of standard deviation 1.
    pub fn noise_gain(&self) -> [f64; 3] {
        // Response to an impulse: up by 1, down again, then free.
        let (mut state, mut squares) = (self.rise, [0.0; 3]);
        for k in 0..100_000 {
            (0..3).for_each(|i| squares[i] += state[i] * state[i]);
            let next = times(&self.step, &if k == 0 { [state[0] - 1.0, state[1], state[2]] } else { state });
            state = if k == 0 { core::array::from_fn(|i| next[i] - self.rise[i]) } else { next };
            if k == 0 {
                state[0] += 1.0;
            }
            if (0..3).all(|i| state[i] * state[i] < 1e-14 * squares[i]) {
                break;
            }
        }
        squares.map(libm::sqrt)
    }
}

/// Matrix of the exponential.
type Square = [[f64; 5]; 5];

fn product(a: &Square, b: &Square) -> Square {
    core::array::from_fn(|i| core::array::from_fn(|j| (0..5).map(|k| a[i][k] * b[k][j]).sum()))
}

/// `exp(a h)` for a small step.
fn taylor(a: &Square, h: f64) -> Square {
    let one: Square = core::array::from_fn(|i| core::array::from_fn(|j| f64::from(u8::from(i == j))));
    let (mut sum, mut term) = (one, one);
    for k in 1..16 {
        term = product(&term, a).map(|row| row.map(|x| x * h / f64::from(k)));
        for i in 0..5 {
            for j in 0..5 {
                sum[i][j] += term[i][j];
            }
        }
    }
    sum
}
