//! The loop that makes the arm follow the motion.

/// Control of the arm.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Mode {
    /// Feedforward of the given model along the motion, and proportional-derivative feedback. The
    /// drive itself is ideal, and the loop is continuous: sampling would shift torque against
    /// motion by half a period.
    #[default]
    Position,
    /// Proportional-derivative feedback and the given model's gravity at the desired position.
    Pd,
    /// The torques of the trajectory's `tau` columns, no feedback.
    Torque,
    /// No torque: a free swing from the motion's first point.
    Free,
    /// No loop: the links follow the motion exactly, and torques follow from the laws. Fast, and
    /// free of transients.
    Exact,
}

impl Mode {
    /// All, with their names.
    pub const ALL: [(&'static str, Self); 5] = [
        ("position", Self::Position),
        ("pd", Self::Pd),
        ("torque", Self::Torque),
        ("free", Self::Free),
        ("exact", Self::Exact),
    ];
}

/// Settings of the loop.
#[derive(Debug, Clone, PartialEq)]
pub struct Control {
    /// Control of the arm.
    pub mode: Mode,
    /// Bandwidth that default gains are made for, rad/s.
    pub bandwidth: f64,
    /// Damping ratio that default gains are made for.
    pub damping: f64,
    /// N m/rad, one for each joint; default: bandwidth squared times the joint's inertia, and that
    /// of a rotor as large as the drive.
    pub kp: Option<Vec<f64>>,
    /// N m s/rad, one for each joint.
    pub kd: Option<Vec<f64>>,
}

impl Default for Control {
    fn default() -> Self {
        // 10 Hz: of the order that position loops of light-weight arms reach; our choice.
        Self { mode: Mode::Position, bandwidth: 63.0, damping: 0.7, kp: None, kd: None }
    }
}

/// Values at evenly spaced times, joint-major, with a cubic through the four nearest.
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
        // Catmull and Rom's cubic.
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
