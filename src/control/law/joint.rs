//! The inner loop, equation (13): `Gamma_d = Kp (q_d - q) + Kd (dq_d - dq) + G(q)`, velocities by
//! first-order backward differences.

/// Proportional-derivative control of the joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointLoop<const N: usize> {
    /// `Kp`, N m/rad.
    pub kp: [f64; N],
    /// `Kd`, N m s/rad.
    pub kd: [f64; N],
}

impl<const N: usize> JointLoop<N> {
    /// Torques for desired and measured positions, now and `dt` seconds ago.
    pub fn torques(
        &self,
        [desired, desired_before]: [&[f64; N]; 2],
        [q, before]: [&[f64; N]; 2],
        dt: f64,
        gravity: &[f64; N],
    ) -> [f64; N] {
        core::array::from_fn(|j| {
            let speed = ((desired[j] - desired_before[j]) - (q[j] - before[j])) / dt;
            self.kp[j] * (desired[j] - q[j]) + self.kd[j] * speed + gravity[j]
        })
    }

    /// Torques that bring the arm to rest wherever it is: damping and gravity.
    pub fn rest(&self, [q, before]: [&[f64; N]; 2], dt: f64, gravity: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|j| gravity[j] - self.kd[j] * (q[j] - before[j]) / dt)
    }
}
