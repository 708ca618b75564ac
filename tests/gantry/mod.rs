//! A gantry of unit masses before a wall, with exactly known dynamics.

#![allow(dead_code, reason = "each test takes the part that it needs")]

use denavit::control::law::{
    Body, Command, Controller, ForceSettings, JointLoop, Limits, Model, Sample, Settings, Target, Tool, moved,
};

pub const T: f64 = 1e-3;

/// Three prismatic joints along the axes and three revolute ones about them, of unit mass, with
/// exactly known dynamics.
#[derive(Clone, Default)]
pub struct Gantry {
    /// Returns no posture and no point of contact.
    pub lost: bool,
    /// Returns NaN for gravity.
    pub dumb: bool,
    /// Returns gravity that no drive could hold.
    pub wild: bool,
    /// Returns another branch of the inverse kinematics: joint 4 turned by half a turn.
    pub flipped: bool,
}

impl Gantry {
    pub fn tool(q: &[f64; 6]) -> Tool<6> {
        let mut jacobian = [[0.0; 6]; 6];
        (0..6).for_each(|k| jacobian[k][k] = 1.0);
        Tool { origin: [q[0], q[1], q[2]], rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], jacobian }
    }
}

impl Model<6> for Gantry {
    fn gravity(&mut self, _: &[f64; 6]) -> [f64; 6] {
        let gravity = if self.wild { 1e6 } else { 9.81 };
        if self.dumb { [f64::NAN; 6] } else { [0.0, 0.0, gravity, 0.0, 0.0, 0.0] }
    }

    fn moving(&mut self, _: &[f64; 6], dq: &[f64; 6], ddq: &[f64; 6]) -> [f64; 6] {
        std::array::from_fn(|j| ddq[j] + 0.0 * dq[j])
    }

    fn pressing(&mut self, _: &[f64; 6], along: &[f64; 3]) -> [f64; 6] {
        [along[0], along[1], along[2], 0.0, 0.0, 0.0]
    }

    fn touch(&mut self, q: &[f64; 6]) -> Option<Tool<6>> {
        (!self.lost).then(|| Self::tool(q))
    }

    fn displaced(&mut self, q: &[f64; 6], by: &[f64; 3], _: &[f64; 6]) -> Option<[f64; 6]> {
        let mut found = moved(q, by, Self::tool).filter(|_| !self.lost)?;
        found[3] += if self.flipped { std::f64::consts::PI } else { 0.0 };
        Some(found)
    }
}

impl Body<6> for Gantry {
    fn torques(&mut self, _: &[f64; 6], _: &[f64; 6], ddq: &[f64; 6], _: f64) -> [f64; 6] {
        std::array::from_fn(|j| ddq[j] + if j == 2 { 9.81 } else { 0.0 })
    }

    fn tool(&mut self, q: &[f64; 6]) -> Tool<6> {
        Self::tool(q)
    }
}

pub fn settings() -> Settings<6> {
    Settings {
        period: T,
        joints: JointLoop { kp: [400.0; 6], kd: [40.0; 6] },
        force: ForceSettings { kp: 0.0, ki: 0.01, range: [-0.02, 0.2], rate: 0.1 },
        torque: [100.0; 6],
        velocity: [1.0; 6],
        patience: 5,
        contact: 2.0,
        lost_after: 0.02,
        regain: 0.01,
        give_up: 0.5,
        most: 80.0,
        carry: 0.0,
        feed: 0.0,
        aside: 0.0,
        aside_pole: 20.0,
        drag: 0.0,
        corner: 10.0,
        limits: Limits {
            position: [[-10.0, 10.0]; 6],
            acceleration: [10.0; 6],
            jerk: [1e3; 6],
            tool: [2.0, 20.0, 2e3],
            force_rate: 1e3,
            torque_rate: [1e5; 6],
            saturated: 0.1,
            // 10 N of the spring of the joint loop.
            frozen: [0.025; 6],
            stuck: [2e-3, 0.2],
        },
        stop: 0.25,
    }
}

/// The gantry before a wall at x = 0 of 5 kN/m, integrated in 20 small steps per period.
pub struct World {
    pub q: [f64; 6],
    pub v: [f64; 6],
    pub t: f64,
    pub wall: bool,
    /// Force that resists the tool along y, N.
    pub drag: f64,
}

impl World {
    pub fn new() -> Self {
        Self { q: [-0.01, 0.0, 0.0, 0.0, 0.0, 0.0], v: [0.0; 6], t: 0.0, wall: true, drag: 0.0 }
    }

    pub fn force(&self) -> f64 {
        if self.wall { (5e3 * self.q[0]).max(0.0) } else { 0.0 }
    }

    /// Force of the tool on the wall and on any other obstacle, N.
    pub fn push(&self) -> [f64; 3] {
        [self.force(), self.drag, 0.0]
    }

    pub fn sample(&self) -> Sample<6> {
        Sample { t: self.t, q: self.q, force: self.force(), push: self.push() }
    }

    pub fn run(&mut self, command: &Command<6>) {
        for _ in 0..20 {
            for j in 0..6 {
                let mut a = command.torque[j] - if j == 2 { 9.81 } else { 0.0 };
                a -= self.push().get(j).copied().unwrap_or(0.0);
                self.v[j] += a * T / 20.0;
                self.q[j] += self.v[j] * T / 20.0;
            }
        }
        self.t += T;
    }
}

pub fn target() -> Target<6> {
    Target::at([0.0; 6], [1.0, 0.0, 0.0], Some(30.0))
}

pub fn pressing() -> (Controller<Gantry, 6>, World) {
    let mut controller = Controller::new(Gantry::default(), settings()).unwrap();
    let mut world = World::new();
    for _ in 0..6000 {
        let command = controller.step(&target(), &world.sample());
        world.run(&command);
    }
    (controller, world)
}
