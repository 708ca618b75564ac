//! What a crate with effects has beside its functions: constants of the drives, and their state.

use core::fmt::Write;

use crate::arm::Model;

impl crate::robot::Laws {
    /// What its drive remembers by.
    pub fn memory(&self) -> crate::drive::Memory {
        let travel = self.hysteresis.map_or(0.0, |[_, travel]| travel);
        let [cold, time, per_kelvin, reference] =
            self.drift.map_or([0.0; 4], |d| [d.cold, d.time, d.per_kelvin, d.reference]);
        crate::drive::Memory { travel, cold, time, per_kelvin, reference }
    }
}

/// Constants, and `Drive`.
pub(super) fn print(model: &Model) -> String {
    let mut t = String::new();
    let delays: Vec<String> = model.laws().iter().map(|l| format!("{:?}", l.delay)).collect();
    let _ = writeln!(
        t,
        "/// How late each joint's torque is, s: what is measured at `t` belongs to the motion at `t - TIME_DELAY`. Of a negative entry it is\n/// early. No function here waits.\npub const TIME_DELAY: [f64; DOF] = [{}];\n",
        delays.join(", ")
    );
    let memory: String = model
        .laws()
        .iter()
        .map(|l| {
            let m = l.memory();
            format!(
                "    drive::Memory {{ travel: {:?}, cold: {:?}, time: {:?}, per_kelvin: {:?}, reference: {:?} }},\n",
                m.travel, m.cold, m.time, m.per_kelvin, m.reference
            )
        })
        .collect();
    let _ = writeln!(
        t,
        "/// What each joint's drive remembers by; zeros: nothing.\npub const DRIVE_MEMORY: [drive::Memory; DOF] = [\n{memory}];\n"
    );
    t += r#"/// Torques at the sensors along a motion, with what the drives remember: bent bristles near reversals, gears that warm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive<S> {
    /// Where the joints were last, rad or m.
    pub q: [S; DOF],
    /// What stands for the sign of each velocity in friction with memory, in [-1, 1].
    pub bristle: [S; DOF],
    /// Time since the start, s.
    pub since: S,
    /// Temperatures, degrees C; those at which nothing changes unless they are set.
    pub temperature: [S; DOF],
}

impl<S: Real> Drive<S> {
    /// At the start of a motion: bristles are bent the way the joints go.
    #[must_use]
    pub fn new(q: &[S; DOF], dq: &[S; DOF]) -> Self {
        Self {
            q: *q,
            bristle: dq.map(|v| v.sign()),
            since: S::default(),
            temperature: DRIVE_MEMORY.map(|m| S::constant(m.reference)),
        }
    }

    /// Factor of each joint's friction now.
    #[must_use]
    pub fn warmth(&self) -> [S; DOF] {
        core::array::from_fn(|k| DRIVE_MEMORY[k].warmth(self.since, self.temperature[k]))
    }

    /// Goes on by `dt`, s, to this state of motion, and gives the torques there, N m.
    pub fn step(&mut self, dt: S, q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD]) -> [S; DOF] {
        let (old, bent) = (self.q, self.bristle);
        self.bristle = core::array::from_fn(|k| DRIVE_MEMORY[k].bent(bent[k], q[k] - old[k]));
        (self.q, self.since) = (*q, self.since + dt);
        self.torques(dq, ddq, phi)
    }

    /// Torques where the joints are, N m.
    #[must_use]
    pub fn torques(&self, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD]) -> [S; DOF] {
        drive_torques(&self.q, dq, ddq, phi, &self.bristle, &self.warmth())
    }
}

"#;
    t
}
