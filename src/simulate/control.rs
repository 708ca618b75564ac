//! Control loop that makes the arm follow the motion: modes, gains, feedforward table.

/// Control mode.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Mode {
    /// Feedforward of the given model along the motion, and proportional-derivative feedback. The
    /// drive is ideal and the loop continuous: a sampled loop would shift torque against motion by
    /// half a period.
    #[default]
    Position,
    /// Proportional-derivative feedback, and gravity of the given model at the desired position.
    Pd,
    /// The torques of the trajectory's `tau` columns, no feedback.
    Torque,
    /// No torque: a free swing from the motion's first point.
    Free,
    /// No loop: the links follow the motion exactly, and torques follow from the laws. Fast, and
    /// without transients.
    Exact,
}

impl Mode {
    /// All modes with their names.
    pub const ALL: [(&'static str, Self); 5] = [
        ("position", Self::Position),
        ("pd", Self::Pd),
        ("torque", Self::Torque),
        ("free", Self::Free),
        ("exact", Self::Exact),
    ];
}

/// Settings of the control loop.
#[derive(Debug, Clone, PartialEq)]
pub struct Control {
    /// Control mode.
    pub mode: Mode,
    /// Bandwidth for which default gains are computed, rad/s.
    pub bandwidth: f64,
    /// Damping ratio for which default gains are computed.
    pub damping: f64,
    /// Position gains, N m/rad: one value, or one per joint. Default: bandwidth squared times the
    /// joint's inertia plus that of a rotor in proportion to the rated torque.
    pub kp: Option<Vec<f64>>,
    /// Velocity gains, N m s/rad: one value, or one per joint. Default: from `kp` and the damping
    /// ratio.
    pub kd: Option<Vec<f64>>,
}

impl Default for Control {
    fn default() -> Self {
        // 10 Hz, the order of the position loops of light-weight arms; our choice.
        Self { mode: Mode::Position, bandwidth: 63.0, damping: 0.7, kp: None, kd: None }
    }
}

/// Values at evenly spaced times, joint-major, interpolated by a cubic through the four nearest.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Table {
    pub start: f64,
    pub step: f64,
    pub len: usize,
    pub values: Vec<f64>,
}

impl Table {
    pub fn at(&self, t: f64, out: &mut [f64]) {
        if self.len == 0 {
            out.fill(0.0);
            return;
        }
        let place = ((t - self.start) / self.step).clamp(0.0, (self.len - 1) as f64);
        let k = (place as usize).min(self.len.saturating_sub(2));
        let s = place - k as f64;
        // Cubic of Catmull and Rom.
        let weights = [
            s * (-0.5 + s * (1.0 - 0.5 * s)),
            1.0 + s * s * (-2.5 + 1.5 * s),
            s * (0.5 + s * (2.0 - 1.5 * s)),
            s * s * (-0.5 + 0.5 * s),
        ];
        let last = self.len - 1;
        for (j, out) in out.iter_mut().enumerate() {
            let row = &self.values[j * self.len..(j + 1) * self.len];
            let knots = [row[k.saturating_sub(1)], row[k], row[(k + 1).min(last)], row[(k + 2).min(last)]];
            *out = weights.iter().zip(knots).map(|(w, v)| w * v).sum();
        }
    }
}
