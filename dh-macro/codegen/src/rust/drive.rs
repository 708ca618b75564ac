//! Prints the additional items of a crate with effects: constants and state of the drives.

use core::fmt::Write;

use crate::arm::Model;
use crate::arm::param::Parameter;

impl crate::robot::Laws {
    /// Constants of the drive's states (bristle and warmth).
    pub fn memory(&self) -> crate::drive::Memory {
        let travel = self.hysteresis.map_or(0.0, |law| law.travel());
        let [cold, time, per_kelvin, reference] =
            self.drift.map_or([0.0, 0.0, 0.0, self.reference], |d| [d.cold(), d.time(), d.per_kelvin(), d.reference()]);
        crate::drive::Memory { travel, cold, time, per_kelvin, reference }
    }

    /// Elasticity of the gear, and the torque gain.
    pub fn gear(&self) -> crate::drive::Spring {
        let damping = self.elasticity.map_or(0.0, |spring| spring.damping());
        crate::drive::Spring { stiffness: self.stiffness().unwrap_or(0.0), damping, gain: self.gain }
    }
}

/// Text of `src/joint_drives.rs`.
pub(super) fn file(model: &Model) -> String {
    let springs = if model.laws().iter().any(|l| l.elasticity.is_some()) { ", rigid_dynamics" } else { "" };
    format!(
        "//! Drives of the joints: constants of their laws, and their state.\n\nuse super::elementary::Real;\nuse super::{{{}DOF, STANDARD, drive{}{springs}}};\n\n{}",
        if model.reads_clock() { "clocked_drive_torques, " } else { "" },
        if model.reads_clock() { "" } else { ", drive_torques" },
        print(model)
    )
}

/// Text of the constants and of `Drive`.
fn print(model: &Model) -> String {
    let mut t = String::new();
    let delays: Vec<String> = model.laws().iter().map(|l| format!("{:?}", l.delay)).collect();
    let _ = writeln!(
        t,
        "/// Delay of each joint's torque, s: the torque measured at `t` belongs to the motion at `t - TIME_DELAY`.\n/// A negative entry is an early torque. No function here waits.\npub const TIME_DELAY: [f64; DOF] = [{}];\n",
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
        "/// Constants of the memory of each joint's drive; zeros: none.\npub const DRIVE_MEMORY: [drive::Memory; DOF] = [\n{memory}];\n"
    );
    let swings = model.laws().iter().any(|l| l.elasticity.is_some());
    if swings {
        springs(model, &mut t);
    }
    let with = |text: &'static str| if swings { text } else { "" };
    let [torques, clock] = match model.reads_clock() {
        true => [CLOCKED, CLOCK],
        false => ["drive_torques(&self.q, dq, ddq, phi, &self.bristle, &self.warmth())", ""],
    };
    t += &DRIVE
        .replace("@FIELDS", with(FIELDS))
        .replace("@NEW", with("            deflection: None,\n            swings: false,\n"))
        .replace("@STEP", with(STEP))
        .replace("@CLOCK", clock)
        .replace("@TORQUES", if swings { TORQUES } else { "        @STATIC" })
        .replace("@STATIC", torques);
    t
}

const DRIVE: &str = r#"/// Torques at the sensors along a motion, with the memory of the drives: bent bristles, warming gears.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive<S> {
    /// Positions of the joints at the last step, rad or m.
    pub q: [S; DOF],
    /// Substitute for the sign of each velocity in friction with memory, in [-1, 1].
    pub bristle: [S; DOF],
    /// Time since the start, s.
    pub since: S,
    /// Temperatures, degrees C; those at which nothing changes unless they are set.
    pub temperature: [S; DOF],
@FIELDS}

impl<S: Real> Drive<S> {
    /// At the start of a motion: bristles are bent the way the joints go.
    #[must_use]
    pub fn new(q: &[S; DOF], dq: &[S; DOF]) -> Self {
        Self {
            q: *q,
            bristle: dq.map(|v| v.sign()),
            since: S::default(),
            temperature: DRIVE_MEMORY.map(|m| S::constant(m.reference)),
@NEW        }
    }

    /// Factor of each joint's friction now.
    #[must_use]
    pub fn warmth(&self) -> [S; DOF] {
        core::array::from_fn(|k| DRIVE_MEMORY[k].warmth(self.since, self.temperature[k]))
    }

@CLOCK    /// Advances by `dt`, s, to this state of motion, and returns the torques there, N m.
    pub fn step(&mut self, dt: S, q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD]) -> [S; DOF] {
        let (old, bent) = (self.q, self.bristle);
        self.bristle = core::array::from_fn(|k| DRIVE_MEMORY[k].bent(bent[k], q[k] - old[k]));
        (self.q, self.since) = (*q, self.since + dt);
@STEP        self.torques(dq, ddq, phi)
    }

    /// Torques at the present positions, N m.
    #[must_use]
    pub fn torques(&self, dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD]) -> [S; DOF] {
@TORQUES
    }
}

"#;

const FIELDS: &str = "    /// Deflections of the links; `None` before the first step, and quasi-static then.
    pub deflection: Option<[drive::Deflection<S>; DOF]>,
    /// Whether the links swing: from the second step on.
    pub swings: bool,
";

const STEP: &str =
    "        let mut bodies = |deflection: &[drive::Deflection<S>], out: &mut [S]| bodies(q, dq, ddq, phi, deflection, out);
        let mut scratch = [S::default(); DOF * (DOF + 2)];
        let mut deflection = self.deflection.unwrap_or_default();
        match self.deflection {
            None => drive::quasi_static(&SPRINGS, &mut deflection, &mut scratch[..DOF], &mut bodies),
            Some(_) if self.swings => drive::swing(&SPRINGS, dt, &mut deflection, &mut scratch, &mut bodies),
            Some(_) => drive::start_swing(&SPRINGS, dt, &mut deflection, &mut scratch[..2 * DOF], &mut bodies),
        }
        (self.swings, self.deflection) = (self.deflection.is_some(), Some(deflection));
";

/// Expression of the torques without elastic links, if a law depends on time or temperature.
const CLOCKED: &str = "clocked_drive_torques(&self.q, dq, ddq, phi, &self.bristle, &self.warmth(), &self.clock())";

const CLOCK: &str = "    /// Time since the start, s, then the temperatures, degrees C.
    #[must_use]
    pub fn clock(&self) -> [S; DOF + 1] {
        core::array::from_fn(|k| if k == 0 { self.since } else { self.temperature[k - 1] })
    }

";

const TORQUES: &str = "        let mut torques = @STATIC;
        if let Some(deflection) = &self.deflection {
            let mut bodies = |deflection: &[drive::Deflection<S>], out: &mut [S]| bodies(&self.q, dq, ddq, phi, deflection, out);
            let (mut still, mut scratch) = ([[S::default(); 3]; DOF], [S::default(); 2 * DOF]);
            drive::elastic_torque(&SPRINGS, deflection, &mut still, &mut scratch, &mut torques, &mut bodies);
        }
        torques";

/// Prints the constants of the elasticities, and the torques of the arm behind them.
fn springs(model: &Model, t: &mut String) {
    let springs: String = model
        .laws()
        .iter()
        .map(|l| {
            let s = l.gear();
            format!(
                "    drive::Spring {{ stiffness: {:?}, damping: {:?}, gain: {:?} }},\n",
                s.stiffness, s.damping, s.gain
            )
        })
        .collect();
    let of_drives = model.standard().iter().enumerate().filter(|(_, p)| matches!(p, Parameter::Drive(..)));
    let of_drives: Vec<String> = of_drives.map(|(k, _)| k.to_string()).collect();
    let _ = writeln!(
        t,
        "/// Springs between motors and links.\npub const SPRINGS: [drive::Spring; DOF] = [\n{springs}];\n"
    );
    let _ = writeln!(
        t,
        "/// Torques of the bodies alone, with deflected links.\nfn bodies<S: Real>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD], deflection: &[drive::Deflection<S>], out: &mut [S]) {{\n    let mut links = *phi;\n    for k in [{}] {{\n        links[k] = S::default();\n    }}\n    let less = |x: &[S; DOF], which: usize| -> [S; DOF] {{ core::array::from_fn(|k| x[k] - deflection[k][which]) }};\n    out.copy_from_slice(&rigid_dynamics(&less(q, 0), &less(dq, 1), &less(ddq, 2), &links));\n}}\n",
        of_drives.join(", ")
    );
}
