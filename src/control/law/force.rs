//! The outer loop, equation (15): `dP = Kp (F_d - F) + Ki integral (F_d - F)`, along the normal,
//! with limits of place and speed. What is known to be needed anyway is added to it.

/// Gains and limits of the force loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceSettings {
    /// `Kp`, m/N.
    pub kp: f64,
    /// `Ki`, m/(N s).
    pub ki: f64,
    /// Least (away from the wall, not above 0) and largest displacement (not below 0), m.
    pub range: [f64; 2],
    /// Largest speed of the displacement, m/s: how fast the tool meets the wall at most.
    pub rate: f64,
}

/// Proportional-integral control of the force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceLoop {
    settings: ForceSettings,
    integral: f64,
    displacement: f64,
}

impl ForceLoop {
    /// At rest, nothing displaced.
    pub fn new(settings: ForceSettings) -> Self {
        Self { settings, integral: 0.0, displacement: 0.0 }
    }

    /// Last command, m.
    pub fn displacement(&self) -> f64 {
        self.displacement
    }

    /// Restarts.
    pub fn reset(&mut self) {
        (self.integral, self.displacement) = (0.0, 0.0);
    }

    /// Presses. Arguments are the error of the force (desired less actual, N), the time since the
    /// step before (s), a limit of the displacement besides its range, and the addition to the
    /// loop's own displacement (m; all limits hold for the sum). The integral stands still while
    /// the displacement is held by a limit and the error pushes against it.
    pub fn press(&mut self, error: f64, dt: f64, ceiling: f64, ahead: f64) -> f64 {
        let ForceSettings { kp, ki, range, rate } = self.settings;
        // So large that it is a limit anyway, and small enough never to overflow.
        let error = error.clamp(-1e9, 1e9);
        let step = rate * dt;
        let top = range[1].min(ceiling.max(range[0])).min(self.displacement + step);
        let bottom = range[0].max(self.displacement - step).min(top);
        let integral = self.integral + ki * error * dt;
        let wanted = kp * error + integral + ahead;
        self.displacement = wanted.clamp(bottom, top);
        let pushes_out = (wanted > top && error > 0.0) || (wanted < bottom && error < 0.0);
        if !pushes_out {
            self.integral = integral.clamp(range[0], range[1]);
        }
        self.displacement
    }

    /// Goes to a displacement at the largest speed, without looking at the force; the integral goes
    /// along, so that pressing begins without a jump.
    pub fn go(&mut self, to: f64, dt: f64) -> f64 {
        let ForceSettings { range, rate, .. } = self.settings;
        let step = rate * dt;
        let to = to.clamp(range[0], range[1]);
        self.displacement = to.clamp(self.displacement - step, self.displacement + step);
        self.integral = self.displacement;
        self.displacement
    }
}
