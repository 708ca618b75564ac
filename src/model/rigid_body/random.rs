//! Seeded random robots, parameters and states for property tests.

use crate::numerics::prng::Random;
use dh_codegen::arm::param;

use dh_codegen::robot::{
    Angle, Collision, Convention, Drive, Inertia, Joint, JointKind, Length, Limits, Polynomial, Pose, Robot, Tool,
};

/// Distribution of random robots. Probabilities are per robot or per row, as stated.
#[derive(Debug, Clone, PartialEq)]
pub struct Family {
    /// Least and largest number of rows; at least one of them moves.
    pub rows: [usize; 2],
    /// Probability that a row is prismatic.
    pub prismatic: f64,
    /// Probability that a row is fixed.
    pub fixed: f64,
    /// Probability of a robot with quarter turns and many zero lengths only, as real arms have;
    /// otherwise all values are generic.
    pub exact: f64,
    /// Probability of the standard convention.
    pub standard: f64,
    /// Probability that gravity is along the base's z, downwards; otherwise in any direction,
    /// sometimes zero.
    pub upright: f64,
    /// Probability that a robot has drives; then each row has each term with probability 3/4.
    pub drives: f64,
    /// Probability of a tool, with or without an inertia.
    pub tool: f64,
    /// Probability that frame 0 differs from the world frame.
    pub base: f64,
}

impl Default for Family {
    fn default() -> Self {
        Self {
            rows: [1, 8],
            prismatic: 0.2,
            fixed: 0.1,
            exact: 0.5,
            standard: 0.4,
            upright: 0.5,
            drives: 0.5,
            tool: 0.4,
            base: 0.0,
        }
    }
}

/// One state of a robot's joints, `n` entries each.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Positions, rad or m.
    pub q: Vec<f64>,
    /// Velocities, rad/s or m/s.
    pub dq: Vec<f64>,
    /// Accelerations, rad/s^2 or m/s^2.
    pub ddq: Vec<f64>,
}

impl Random {
    /// A state with `q` in a full turn (or 1 m either way), `|dq| <= 2`, `|ddq| <= 6`.
    pub fn state(&mut self, robot: &Robot) -> State {
        let rows = robot.moving();
        let q = rows.iter().map(|&row| match robot.joints[row].kind {
            JointKind::Prismatic => self.uniform(-1.0, 1.0),
            _ => self.uniform(-core::f64::consts::PI, core::f64::consts::PI),
        });
        let q = q.collect();
        let mut entries = |bound: f64| rows.iter().map(|_| self.uniform(-bound, bound)).collect();
        State { q, dq: entries(2.0), ddq: entries(6.0) }
    }

    /// A body of at least six point masses within 0.3 m of a centre within 0.2 m of the origin:
    /// consistent by construction.
    pub fn inertia(&mut self) -> Inertia {
        let center: [f64; 3] = core::array::from_fn(|_| self.uniform(-0.2, 0.2));
        (0..6).fold(Inertia::default(), |sum, _| {
            let m = self.uniform(0.1, 1.0);
            let [x, y, z] = center.map(|c| c + self.uniform(-0.3, 0.3));
            let i = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
            sum.plus(&Inertia { m, ms: [m * x, m * y, m * z], i: i.map(|v| m * v) })
        })
    }

    /// Standard parameters, `P` values in the order of `param::standard`: the robot's own if its
    /// links are known, otherwise random bodies with the file's drives.
    pub fn phi(&mut self, robot: &Robot) -> Vec<f64> {
        if let Some(known) = param::standard_values(robot) {
            return known;
        }
        let mut filled = robot.clone();
        filled.links = robot.joints.iter().map(|_| Some(self.inertia())).collect();
        param::standard_values(&filled).unwrap_or_default()
    }

    /// A random robot of the family, with inertias of all links.
    pub fn robot(&mut self, family: &Family) -> Robot {
        let [fewest, most] = family.rows;
        let count = fewest.max(1) + self.below((most + 1).saturating_sub(fewest.max(1)));
        let exact = self.chance(family.exact);
        let named = self.chance(0.5);
        let driven = self.chance(family.drives);
        let mut constants = Vec::new();
        let mut joints: Vec<Joint> = (0..count)
            .map(|row| {
                let kind = match self.uniform(0.0, 1.0) {
                    u if u < family.fixed => JointKind::Fixed,
                    u if u < family.fixed + family.prismatic => JointKind::Prismatic,
                    _ => JointKind::Revolute,
                };
                Joint {
                    name: format!("joint{}", row + 1),
                    kind,
                    actuated: true,
                    alpha: self.angle(exact),
                    d: self.length(exact, named, &mut constants),
                    theta: if self.chance(0.5) { Angle::zero() } else { self.angle(exact) },
                    r: self.length(exact, named, &mut constants),
                    source: None,
                    limits: Limits::default(),
                    drive: Drive::default(),
                }
            })
            .collect();
        if joints.iter().all(|j| j.kind == JointKind::Fixed) {
            joints[count - 1].kind = JointKind::Revolute;
        }
        for joint in joints.iter_mut().filter(|j| driven && j.kind != JointKind::Fixed) {
            joint.drive = self.drive();
        }
        let convention = if self.chance(family.standard) { Convention::Standard } else { Convention::Modified };
        let robot = Robot {
            name: "random".to_string(),
            convention,
            constants,
            gravity: self.gravity(family),
            base: None,
            links: joints.iter().map(|_| Some(self.inertia())).collect(),
            joints,
            tool: if self.chance(family.tool) { Some(self.tool(exact)) } else { None },
            collision: Collision::default(),
            log: None,
            effects: Vec::new(),
        };
        // Drawn last, and only on demand, so that robots of other families do not change.
        let base = (family.base > 0.0 && self.chance(family.base)).then(|| Pose {
            xyz: core::array::from_fn(|_| self.uniform(-1.0, 1.0)),
            rpy: core::array::from_fn(|_| self.angle(exact)),
        });
        Robot { base, ..robot }
    }

    fn angle(&mut self, exact: bool) -> Angle {
        match exact {
            true => Angle::pi_fraction(self.below(4) as i64 - 1, 2),
            false => Angle::radians(self.uniform(-3.0, 3.0)),
        }
    }

    /// A length: zero half of the time in an exact robot; a new constant if the robot names them.
    fn length(&mut self, exact: bool, named: bool, constants: &mut Vec<(String, f64)>) -> Length {
        if exact && self.chance(0.5) {
            return Length::zero();
        }
        // In millimetres, as on a drawing; never zero by accident.
        let sign = if self.chance(0.3) { -1.0 } else { 1.0 };
        let value = sign * (50 + self.below(450)) as f64 / 1000.0;
        if !named {
            return Length::meters(value);
        }
        let index = constants.len();
        let name = format!("L{}", index + 1);
        constants.push((name.clone(), value));
        Length { value, closed_form: Polynomial::constant(index), text: name }
    }

    fn drive(&mut self) -> Drive {
        let mut term = |high: f64| if self.chance(0.75) { Some(self.uniform(0.05, high)) } else { None };
        Drive {
            rotor_inertia: term(0.5),
            viscous_friction: term(4.0),
            coulomb_friction: term(3.0),
            offset: term(1.0),
            ..Drive::default()
        }
    }

    fn gravity(&mut self, family: &Family) -> [f64; 3] {
        if self.chance(family.upright) {
            return [0.0, 0.0, -9.81];
        }
        match self.below(5) {
            0 => [0.0; 3],
            1 => [0.0, -9.81, 0.0],
            2 => [9.81, 0.0, 0.0],
            _ => core::array::from_fn(|_| self.uniform(-6.0, 6.0)),
        }
    }

    fn tool(&mut self, exact: bool) -> Tool {
        Tool {
            name: "tool".to_string(),
            xyz: core::array::from_fn(|_| self.uniform(-0.2, 0.2)),
            rpy: core::array::from_fn(|_| self.angle(exact)),
            inertia: if self.chance(0.7) { Some(self.inertia()) } else { None },
            geometry: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix4;

    #[test]
    fn splitmix_is_the_published_one() {
        // First outputs for seed 1234567, S. Vigna's splitmix64.c.
        let mut r = Random::new(1234567);
        assert_eq!(r.bits(), 6457827717110365317);
        assert_eq!(r.bits(), 3203168211198807973);
    }

    #[test]
    fn bodies_are_physically_consistent() {
        let mut r = Random::new(101);
        for _ in 0..200 {
            let Inertia { m, ms: [hx, hy, hz], i: [xx, yy, zz, xy, xz, yz] } = r.inertia();
            let half = (xx + yy + zz) / 2.0;
            // The pseudo-inertia of P. Wensing, S. Kim and J.-J. Slotine, RA-L 3(1), 2018.
            let pseudo = Matrix4::new(
                half - xx,
                -xy,
                -xz,
                hx, //
                -xy,
                half - yy,
                -yz,
                hy, //
                -xz,
                -yz,
                half - zz,
                hz, //
                hx,
                hy,
                hz,
                m,
            );
            assert!(pseudo.cholesky().is_some());
        }
    }

    #[test]
    fn robots_cover_their_family() {
        let mut r = Random::new(102);
        let robots: Vec<Robot> = (0..300).map(|_| r.robot(&Family::default())).collect();
        let some = |test: &dyn Fn(&Robot) -> bool| assert!(robots.iter().filter(|r| test(r)).count() > 20);
        some(&|r| r.convention == Convention::Standard);
        some(&|r| r.joints.iter().any(|j| j.kind == JointKind::Prismatic));
        some(&|r| r.joints.iter().any(|j| j.kind == JointKind::Fixed));
        some(&|r| r.joints.iter().all(|j| j.alpha.quarter_turns().is_some()));
        some(&|r| !r.constants.is_empty());
        some(&|r| r.tool.is_some());
        some(&|r| r.joints.len() == 1);
        some(&|r| r.joints.len() == 8);
        some(&|r| r.gravity[0] != 0.0);
        assert!(robots.iter().all(|r| r.dof() > 0));
        assert_eq!(Random::new(7).robot(&Family::default()), Random::new(7).robot(&Family::default()));
    }
}
