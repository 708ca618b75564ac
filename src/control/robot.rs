//! Adapts a robot file to the control law: bodies by the interpreter, closed-form inverse
//! kinematics, friction and effects by the laws of the file.

use dh_codegen::ik::Reference;
use dh_codegen::robot::{Robot, Tool as RobotTool};

use super::estimate::stiction::breakaway;
use super::law::{Body, Model, Tool, moved};
use crate::model::inverse_kinematics::{Ask, Kinematics};
use crate::model::{Dynamics, ToolState};
use crate::simulate::Drive;

/// A robot with its tool; the contact is at the tool's point of contact.
pub struct RobotModel<'a> {
    bodies: Box<dyn Dynamics + 'a>,
    kinematics: Option<&'a Kinematics>,
    /// Rotation (rows) and origin of the tool in the last frame.
    mount: ([[f64; 3]; 3], [f64; 3]),
    /// Point of contact in the tool frame, m.
    point: [f64; 3],
    drives: Vec<Drive>,
    /// Bristle states of each joint: one that replaces the sign of the velocity, that of the
    /// hysteresis, and that of the slowest possible friction reversal.
    memory: Vec<[f64; 3]>,
    turning: Vec<f64>,
    /// Lower and upper deviation of the friction where a joint stands, N m.
    at_rest: Vec<[f64; 2]>,
    /// Torque limits, N m; infinite where unknown.
    limits: Vec<f64>,
    before: Vec<f64>,
    state: ToolState,
    /// Posture of the tool's state; `rested` is that of the torques at rest.
    placed: Vec<f64>,
    rested: Vec<f64>,
    still: Vec<f64>,
    mass: Vec<f64>,
    bias: Vec<f64>,
    clock: f64,
}

/// Travel of the bristle that replaces the sign of the velocity, rad: some encoder steps, so that
/// noise does not reverse it.
const TRAVEL: f64 = 5e-5;

/// Longest travel in which friction reverses, to `1 - 2/e`, rad. Gears need some milliradians
/// (`presliding_hysteresis` has 2 by default), and a file with Coulomb friction alone gives no
/// travel.
const TURNED: f64 = 3e-3;

/// Travel within which a joint stands, rad: twice that of the bristle.
pub const STANDING: f64 = 1e-4;

/// Planned speed, rad/s, at which fed-forward friction reaches 70 % of its level.
const SLOW: f64 = 0.01;

/// Point of contact in the tool frame, m: the far end of a tool with a length, else the origin.
pub fn contact_point(tool: Option<&RobotTool>) -> [f64; 3] {
    [0.0, 0.0, tool.and_then(|t| t.geometry).map_or(0.0, |g| g.length)]
}

impl<'a> RobotModel<'a> {
    /// Creates the adapter. `bodies` carry the known inertial parameters, tool included; `drives`
    /// the known friction and effects.
    pub fn new(
        robot: &Robot,
        bodies: Box<dyn Dynamics + 'a>,
        kinematics: Option<&'a Kinematics>,
        drives: Vec<Drive>,
    ) -> Self {
        let n = bodies.dof();
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mount = robot.tool.as_ref().map_or((unit, [0.0; 3]), |t| (t.rotation(), t.xyz));
        Self {
            bodies,
            kinematics,
            mount,
            point: contact_point(robot.tool.as_ref()),
            memory: vec![[0.0; 3]; n],
            turning: vec![0.0; n],
            at_rest: vec![[0.0; 2]; n],
            limits: robot
                .moving()
                .iter()
                .map(|&row| robot.joints[row].limits.torque.unwrap_or(f64::INFINITY))
                .collect(),
            before: Vec::new(),
            state: ToolState::default(),
            placed: Vec::new(),
            rested: Vec::new(),
            still: vec![0.0; n],
            mass: vec![0.0; n * n],
            bias: vec![0.0; n],
            drives,
            clock: 0.0,
        }
    }

    /// Frame and Jacobian of the point of contact.
    pub fn contact<const N: usize>(&mut self, q: &[f64; N]) -> Tool<N> {
        if self.placed != q {
            self.bodies.tool(q, &mut self.state);
            self.placed = q.to_vec();
        }
        let pose = &self.state.pose;
        let rotation: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|k| pose[4 * i + k]));
        let arm: [f64; 3] = std::array::from_fn(|i| (0..3).map(|k| rotation[i][k] * self.point[k]).sum());
        let mut jacobian: [[f64; N]; 6] =
            std::array::from_fn(|i| std::array::from_fn(|j| self.state.jacobian[i * N + j]));
        for j in 0..N {
            let w = [jacobian[3][j], jacobian[4][j], jacobian[5][j]];
            jacobian[0][j] += w[1] * arm[2] - w[2] * arm[1];
            jacobian[1][j] += w[2] * arm[0] - w[0] * arm[2];
            jacobian[2][j] += w[0] * arm[1] - w[1] * arm[0];
        }
        Tool { origin: std::array::from_fn(|i| pose[4 * i + 3] + arm[i]), rotation, jacobian }
    }

    /// Torques of the bodies at rest, N m.
    fn resting<const N: usize>(&mut self, q: &[f64; N]) -> [f64; N] {
        if self.rested != q {
            self.bodies.bias(q, &[0.0; N], &mut self.still);
            self.rested = q.to_vec();
        }
        std::array::from_fn(|j| self.still[j])
    }

    /// Mass matrix including rotors, `n x n`, row-major, kg m^2.
    pub fn mass(&mut self, q: &[f64]) -> Vec<f64> {
        let n = self.drives.len();
        self.bodies.mass_matrix(q, &mut self.mass);
        let mut mass = self.mass.clone();
        self.drives.iter().enumerate().for_each(|(j, d)| mass[j * n + j] += d.rotor);
        mass
    }

    /// Pose of the last frame at posture `q`, displaced by `by`, m, in world axes.
    fn last_pose<const N: usize>(&mut self, q: &[f64; N], by: &[f64; 3]) -> [[f64; 4]; 3] {
        let Tool { origin, rotation, .. } = self.contact(q);
        let (turn, offset) = &self.mount;
        // R_last = R_tool R_mount'; the point is R_mount p + offset in the last frame.
        let last: [[f64; 3]; 3] =
            std::array::from_fn(|i| std::array::from_fn(|k| (0..3).map(|m| rotation[i][m] * turn[k][m]).sum()));
        let point: [f64; 3] =
            std::array::from_fn(|k| offset[k] + (0..3).map(|m| turn[k][m] * self.point[m]).sum::<f64>());
        std::array::from_fn(|i| {
            let place = origin[i] + by[i] - (0..3).map(|k| last[i][k] * point[k]).sum::<f64>();
            [last[i][0], last[i][1], last[i][2], place]
        })
    }
}

impl<const N: usize> Model<N> for RobotModel<'_> {
    fn gravity(&mut self, q: &[f64; N]) -> [f64; N] {
        let still = self.resting(q);
        std::array::from_fn(|j| still[j] + self.drives[j].plain.offset)
    }

    fn moving(&mut self, q: &[f64; N], dq: &[f64; N], ddq: &[f64; N]) -> [f64; N] {
        self.bodies.mass_matrix(q, &mut self.mass);
        let still = self.resting(q);
        self.bodies.bias(q, dq, &mut self.bias);
        std::array::from_fn(|j| {
            let drive = &self.drives[j];
            let inertial: f64 = (0..N).map(|k| self.mass[j * N + k] * ddq[k]).sum::<f64>() + drive.rotor * ddq[j];
            // Smoothed sign of the planned velocity: a torque step at the start of a leg would only
            // excite the arm.
            let sign = dq[j] / libm::sqrt(dq[j] * dq[j] + SLOW * SLOW);
            let mut friction = drive.friction(q[j], dq[j], sign, sign);
            if let Some(load) = drive.load {
                friction += load.level(self.bias[j] + inertial, dq[j]) * sign;
            }
            let spring = drive.spring.map_or(0.0, |s| s.torque(q[j]));
            inertial + self.bias[j] - still[j] + friction + drive.ripple(q[j]) + spring
        })
    }

    fn pressing(&mut self, q: &[f64; N], along: &[f64; 3]) -> [f64; N] {
        let jacobian = self.contact(q).jacobian;
        std::array::from_fn(|j| (0..3).map(|k| jacobian[k][j] * along[k]).sum())
    }

    fn touch(&mut self, q: &[f64; N]) -> Option<Tool<N>> {
        Some(self.contact(q))
    }

    fn displaced(&mut self, q: &[f64; N], by: &[f64; 3], near: &[f64; N]) -> Option<[f64; N]> {
        if let Some(kinematics) = self.kinematics {
            let pose = self.last_pose(q, by);
            let reference = Reference::UP;
            let ask = Ask {
                redundancy: kinematics.redundancy(q, &reference),
                reference,
                near: Some(near.to_vec()),
                // No Newton steps on each branch: a controller has no time for them, and where they
                // are needed `moved` takes its own.
                steps: 0,
                tolerance: 1e-9,
            };
            let found = kinematics.solve(&pose, &ask).ok()?;
            let best = found.list.first().filter(|p| p.position_error < 1e-6 && p.rotation_error < 1e-5);
            if let Some(best) = best.and_then(|p| <[f64; N]>::try_from(p.q.as_slice()).ok()) {
                return Some(best);
            }
        }
        moved(q, by, |q| self.contact(q))
    }
}

impl<const N: usize> Body<N> for RobotModel<'_> {
    fn torques(&mut self, q: &[f64; N], dq: &[f64; N], ddq: &[f64; N], dt: f64) -> [f64; N] {
        if self.before.is_empty() {
            self.before = q.to_vec();
        }
        self.clock += dt;
        self.bodies.mass_matrix(q, &mut self.mass);
        self.bodies.bias(q, dq, &mut self.bias);
        std::array::from_fn(|j| {
            let inertial: f64 = (0..N).map(|k| self.mass[j * N + k] * ddq[k]).sum();
            let drive = &self.drives[j];
            let step = q[j] - self.before[j];
            self.before[j] = q[j];
            // Exact step of dz = (dx - |dx| z) / X.
            let bend = |z: f64, travel: f64| {
                let side = if step > 0.0 { 1.0 } else { -1.0 };
                if step == 0.0 { z } else { side + (z - side) * libm::exp(-step.abs() / travel) }
            };
            let [sign, hysteresis, slow] = &mut self.memory[j];
            *sign = bend(*sign, TRAVEL);
            *hysteresis = bend(*hysteresis, drive.hysteresis.map_or(1.0, |h| h.travel));
            *slow = bend(*slow, TURNED);
            let bodies = inertial + self.bias[j];
            let mut later = drive.friction(q[j], dq[j], *slow, *hysteresis);
            let mut friction = drive.friction(q[j], dq[j], *sign, *hysteresis);
            if let Some(load) = drive.load {
                let level = load.level(bodies, dq[j]);
                friction += level * *sign;
                later += level * *slow;
            }
            self.turning[j] = drive.warmth(self.clock) * (later - friction);
            let level = static_level(drive, self.limits[j], q[j], bodies);
            let dry = friction - drive.friction(q[j], dq[j], 0.0, 0.0);
            self.at_rest[j] = [-level - dry, level - dry].map(|by| drive.warmth(self.clock) * by);
            bodies
                + drive.rotor * ddq[j]
                + drive.warmth(self.clock) * friction
                + drive.plain.offset
                + drive.ripple(q[j])
                + drive.spring.map_or(0.0, |s| s.torque(q[j]))
        })
    }

    fn turning(&self) -> [f64; N] {
        std::array::from_fn(|j| self.turning[j])
    }

    fn static_friction(&self) -> [[f64; 2]; N] {
        std::array::from_fn(|j| self.at_rest[j])
    }

    fn tool(&mut self, q: &[f64; N]) -> Tool<N> {
        self.contact(q)
    }
}

/// Largest static friction of a drive with this torque limit (N m) at angle `q`, while its gear
/// transmits `load`, N m. A friction law without a dry part means that there is none: holding a
/// contact for friction that is not there would let the force loop push on.
fn static_level(drive: &Drive, limit: f64, q: f64, load: f64) -> f64 {
    let hysteresis = drive.hysteresis.map_or(0.0, |h| h.level);
    let loaded = drive.load.map_or(0.0, |l| l.level(load, load).max(l.level(load, -load)));
    let other = hysteresis + loaded + drive.position.map_or(0.0, |p| p.excess(q));
    let coulomb = drive.plain.level + drive.asymmetric.map_or(0.0, |a| a.level.abs()) + other;
    let viscous_alone = coulomb == 0.0 && drive.plain.viscous > 0.0;
    let stated = drive.stribeck.map(|s| s.breakaway + other);
    breakaway(coulomb, stated.or(viscous_alone.then_some(0.0)), limit)
}
