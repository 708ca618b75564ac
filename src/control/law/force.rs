//! The outer loop, equation (15): `dP = Kp (F_d - F) + Ki integral (F_d - F)`, along the normal,
//! with limits of position and speed. A feed-forward displacement is added to it. Without contact
//! it also has limits of acceleration and jerk; in contact they would reduce its margins.

/// Gains and limits of the force loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceSettings {
    /// `Kp`, m/N.
    pub kp: f64,
    /// `Ki`, m/(N s).
    pub ki: f64,
    /// Smallest (away from the wall, not above 0) and largest (not below 0) displacement, m.
    pub range: [f64; 2],
    /// Largest speed of the displacement, m/s: the largest impact speed on the wall.
    pub rate: f64,
}

/// Proportional-integral control of the force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceLoop {
    settings: ForceSettings,
    integral: f64,
    way: Way,
}

impl ForceLoop {
    /// Creates a loop at rest with zero displacement, without limits of acceleration and jerk.
    pub fn new(settings: ForceSettings) -> Self {
        Self { settings, integral: 0.0, way: Way::new(f64::INFINITY, 1) }
    }

    /// Adds limits of acceleration (m/s^2) and jerk (m/s^3), for steps of a period (s).
    #[must_use]
    pub fn within(self, [acceleration, jerk]: [f64; 2], period: f64) -> Self {
        // A mean over this many steps changes between accelerations within the jerk limit.
        let change = jerk * period;
        let most = acceleration.min(0.5 * change * SMOOTHED as f64);
        let count = if change.is_finite() { (1..SMOOTHED).find(|n| *n as f64 * change >= 2.0 * most) } else { Some(1) };
        Self { way: Way::new(most, count.unwrap_or(SMOOTHED)), ..self }
    }

    /// Last commanded displacement, m.
    pub fn displacement(&self) -> f64 {
        self.way.mean
    }

    /// Resets the loop to zero displacement.
    pub fn reset(&mut self) {
        self.integral = 0.0;
        self.way.stand(0.0);
    }

    /// Stops the displacement at its present value.
    pub fn hold(&mut self) {
        self.way.stand(self.way.mean);
    }

    /// Presses, and returns the displacement, m. `error` is the force error (desired minus actual,
    /// N), `dt` the time since the previous step (s), and `ceiling` a further upper limit of the
    /// displacement (m). `ahead` is added to the loop's own displacement (m; all limits hold for
    /// the sum). The integral is held while a limit holds the displacement and the error pushes
    /// against it.
    pub fn press(&mut self, error: f64, dt: f64, ceiling: f64, ahead: f64) -> f64 {
        self.follow(error, dt, ceiling, ahead, false)
    }

    /// Does the same without contact, within the limits of acceleration and jerk. The integral is
    /// held while the displacement lags by more than its braking distance.
    pub fn approach(&mut self, error: f64, dt: f64, ceiling: f64, ahead: f64) -> f64 {
        self.follow(error, dt, ceiling, ahead, true)
    }

    fn follow(&mut self, error: f64, dt: f64, ceiling: f64, ahead: f64, gently: bool) -> f64 {
        let ForceSettings { kp, ki, range, rate } = self.settings;
        // Large enough to reach a limit anyway, and small enough never to overflow.
        let error = error.clamp(-1e9, 1e9);
        let top = range[1].min(ceiling.max(range[0]));
        let integral = self.integral + ki * error * dt;
        let wanted = kp * error + integral + ahead;
        if gently {
            self.way.go(wanted, [range[0], top], rate, dt);
        } else {
            self.way.leap(wanted.clamp(range[0], top), rate, dt);
        }
        let (at, room) = if gently { (self.way.at, self.way.brakes_within(dt)) } else { (self.way.mean, 0.0) };
        let behind = wanted - at;
        let pushes_out = behind * error > 0.0 && behind.abs() > room;
        if !pushes_out {
            self.integral = integral.clamp(range[0], range[1]);
        }
        self.way.mean
    }

    /// Moves to a displacement at the largest speed, ignoring the force. Motion in the opposite
    /// direction stops at once: a tool that is to leave the wall does not go deeper first. The
    /// integral follows, so that pressing begins without a jump.
    pub fn go(&mut self, to: f64, dt: f64) -> f64 {
        let ForceSettings { range, rate, .. } = self.settings;
        if (to - self.way.at) * self.way.speed < 0.0 {
            self.way.stand(self.way.mean);
        }
        self.way.go(to, range, rate, dt);
        self.integral = self.way.at;
        self.way.mean
    }

    /// Time that the limits of acceleration and jerk add to a move, s.
    pub(super) fn delay(&self, period: f64) -> f64 {
        self.settings.rate / self.way.acceleration + self.way.count as f64 * period
    }
}

/// Largest number of steps over which the displacement is smoothed.
const SMOOTHED: usize = 32;

/// Motion along the normal with limits of speed, acceleration and jerk.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Way {
    acceleration: f64,
    /// Position (m) and `speed` (m/s), within the limits of speed and acceleration.
    at: f64,
    speed: f64,
    /// Ring buffer of the last `count` positions, m; their `mean` also keeps the limit of jerk.
    last: [f64; SMOOTHED],
    count: usize,
    next: usize,
    mean: f64,
}

impl Way {
    fn new(acceleration: f64, count: usize) -> Self {
        Self { acceleration, at: 0.0, speed: 0.0, last: [0.0; SMOOTHED], count, next: 0, mean: 0.0 }
    }

    fn stand(&mut self, at: f64) {
        *self = Self { at, mean: at, last: [at; SMOOTHED], ..Self::new(self.acceleration, self.count) };
    }

    /// Braking distance from a speed that is one step's acceleration higher, m.
    fn brakes_within(&self, dt: f64) -> f64 {
        let change = self.acceleration * dt;
        let speed = self.speed.abs() + 1.5 * change;
        if change.is_finite() { 0.5 * speed * speed / self.acceleration } else { 0.0 }
    }

    /// Moves to a position within one step, limited only in speed. The ring buffer is filled with a
    /// motion at this speed, so that a smooth motion can continue from it.
    fn leap(&mut self, to: f64, rate: f64, dt: f64) {
        let (before, step) = (self.mean, rate * dt);
        let now = to.clamp(before - step, before + step);
        let middle = 0.5 * (self.count - 1) as f64;
        for (k, place) in self.last[..self.count].iter_mut().enumerate() {
            *place = now + (now - before) * (k as f64 - middle);
        }
        (self.at, self.speed) = (now + (now - before) * middle, (now - before) / dt);
        (self.mean, self.next) = (now, 0);
    }

    /// Moves towards a position within bounds for one step, no faster than `rate`.
    fn go(&mut self, to: f64, [low, high]: [f64; 2], rate: f64, dt: f64) {
        let way = to.clamp(low, high) - self.at;
        let side = if way < 0.0 { -1.0 } else { 1.0 };
        let speed =
            if self.acceleration.is_finite() { self.speed_for(way.abs(), side * self.speed, rate, dt) } else { rate };
        // Goes to the position itself if it is that close and the speed allows a stop.
        let least = side * self.speed - self.acceleration * dt;
        let by = if speed * dt < way.abs() { side * speed * dt } else { side * way.abs().max(least * dt) };
        let now = if by == way { to.clamp(low, high) } else { (self.at + by).clamp(low, high) };
        (self.speed, self.at) = ((now - self.at) / dt, now);
        self.last[self.next] = now;
        self.next = (self.next + 1) % self.count;
        let last = &self.last[..self.count];
        // No overshoot by rounding, nor beyond the bounds after a faster motion.
        let [least, most] = last.iter().fold([now; 2], |[least, most], x| [least.min(*x), most.max(*x)]);
        self.mean = (last.iter().sum::<f64>() / self.count as f64).clamp(least, most).clamp(low, high);
    }

    /// Largest speed following `speed` from which the motion can still stop within a distance
    /// `way`, m, braking in steps. If there is none, the lowest speed that the acceleration allows.
    fn speed_for(&self, way: f64, speed: f64, rate: f64, dt: f64) -> f64 {
        let change = self.acceleration * dt;
        let fastest = (speed + change).min(rate);
        // Braking in steps takes at most `(v + change / 2)^2 / 2 a`; below one change, one step.
        // Newton's method from above replaces the square root.
        let room = 2.0 * self.acceleration * way;
        let mut root = fastest.max(0.0) + 0.5 * change;
        for _ in 0..16 {
            if root * root <= room {
                break;
            }
            root = 0.5 * (root + room / root);
        }
        let v = fastest.min((root - 0.5 * change).max((way / dt).min(change)));
        v.max(speed - change)
    }
}
