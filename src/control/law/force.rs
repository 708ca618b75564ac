//! The outer loop, equation (15): `dP = Kp (F_d - F) + Ki integral (F_d - F)`, along the normal,
//! with limits of place, speed, acceleration and jerk. What is known to be needed anyway is added
//! to it.

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
    /// Its largest acceleration, m/s^2.
    pub acceleration: f64,
    /// Its largest jerk, m/s^3.
    pub jerk: f64,
}

/// Proportional-integral control of the force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceLoop {
    settings: ForceSettings,
    integral: f64,
    displacement: f64,
    /// Its speed and acceleration.
    speed: f64,
    acceleration: f64,
}

impl ForceLoop {
    /// At rest, nothing displaced.
    pub fn new(settings: ForceSettings) -> Self {
        Self { settings, integral: 0.0, displacement: 0.0, speed: 0.0, acceleration: 0.0 }
    }

    /// Last command, m.
    pub fn displacement(&self) -> f64 {
        self.displacement
    }

    /// Restarts.
    pub fn reset(&mut self) {
        *self = Self::new(self.settings);
    }

    /// Presses. Arguments are the error of the force (desired less actual, N), the time since the
    /// step before (s), a limit of the displacement besides its range, and the addition to the
    /// loop's own displacement (m; all limits hold for the sum). The integral stands still while
    /// the displacement is held by a limit and the error pushes against it.
    pub fn press(&mut self, error: f64, dt: f64, ceiling: f64, ahead: f64) -> f64 {
        let ForceSettings { kp, ki, range, rate, .. } = self.settings;
        // So large that it is a limit anyway, and small enough never to overflow.
        let error = error.clamp(-1e9, 1e9);
        let top = range[1].min(ceiling.max(range[0]));
        let integral = self.integral + ki * error * dt;
        let wanted = kp * error + integral + ahead;
        let arrives = self.follow(wanted.clamp(range[0], top), dt);
        // A displacement that lags behind needs a way on which to keep its speed, and no more.
        let lead = if arrives { f64::INFINITY } else { 2.0 * rate * dt };
        let rest = self.displacement + self.stopping_distance(self.speed, self.acceleration);
        let (most, least) = (top.min(rest + lead), range[0].max(rest - lead));
        let pushes_out = (wanted > most && error > 0.0) || (wanted < least && error < 0.0);
        if !pushes_out {
            self.integral = integral.clamp(range[0], range[1]);
        }
        self.displacement
    }

    /// Goes to a displacement as fast as its limits allow, without looking at the force; the
    /// integral goes along, so that pressing begins without a jump.
    pub fn go(&mut self, to: f64, dt: f64) -> f64 {
        let [low, high] = self.settings.range;
        self.follow(to.clamp(low, high), dt);
        self.integral = self.displacement;
        self.displacement
    }

    /// Moves the displacement to a value within its range, at once where the limits of its motion
    /// allow that, else as fast as it may with the way left on which it can stop. Whether it has
    /// arrived.
    fn follow(&mut self, to: f64, dt: f64) -> bool {
        let ForceSettings { range: [low, high], rate, acceleration: most, jerk, .. } = self.settings;
        let Self { displacement: x, speed: v, acceleration: a, .. } = *self;
        let (hardest, softest) = ((a - jerk * dt).max(-most), (a + jerk * dt).min(most));
        let speed = (to - x) / dt;
        let exact = (speed - v) / dt;
        let end = to + self.stopping_distance(speed, exact);
        // The range is not left afterwards either; what a step stops needs no way.
        let stops = (low..=high).contains(&end) || 2.0 * speed.abs() <= most.min(jerk * dt) * dt;
        if (hardest..=softest).contains(&exact) && speed.abs() <= rate && stops {
            (self.displacement, self.speed, self.acceleration) = (to, speed, exact);
            return true;
        }
        let short = |a: f64| {
            let speed = v + a * dt;
            let steady = speed + 0.5 * a * a.abs() / jerk;
            let end = x + speed * dt + self.stopping_distance(speed, a);
            (end <= to && steady <= rate) || steady < -rate
        };
        // The largest acceleration that falls short; all below it do.
        const HALVINGS: usize = 20;
        let (mut under, mut over) = (hardest, softest);
        if short(over) {
            under = over;
        } else if short(under) {
            for _ in 0..HALVINGS {
                let middle = 0.5 * (under + over);
                (under, over) = if short(middle) { (middle, over) } else { (under, middle) };
            }
        }
        let next = (x + (v + under * dt) * dt).clamp(low, high);
        let speed = (next - x) / dt;
        (self.displacement, self.speed, self.acceleration) = (next, speed, ((speed - v) / dt).clamp(-most, most));
        false
    }

    /// A way on which a motion comes to rest within its limits of acceleration and jerk, m, with
    /// its sign: not less than the shortest, and without its square root.
    fn stopping_distance(&self, speed: f64, a: f64) -> f64 {
        let ForceSettings { acceleration: most, jerk, .. } = self.settings;
        // Jerk to the full deceleration and from it, between them the deceleration. Slow motions
        // don't come to it: sqrt(v / J) is at most half the sum of v / A and A / J.
        let from = |v: f64| 0.5 * v * (most / jerk + v.abs() / most);
        // What the acceleration adds until it has ended.
        let steady = speed + 0.5 * a * a.abs() / jerk;
        let brakes = speed * a < 0.0 && steady * speed >= 0.0;
        if brakes { from(speed) } else { speed * a.abs() / jerk + a * a * a / (3.0 * jerk * jerk) + from(steady) }
    }
}
