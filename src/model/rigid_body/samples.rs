//! Well-known arms in code, for tests independent of the reader of robot files. Lengths in m; no
//! inertias, no drives.

use dh_codegen::robot::{Angle, Collision, Convention, Drive, Joint, JointKind, Length, Limits, Robot};

use crate::numerics::prng::Random;

/// Angle of `k` quarter turns.
fn turns(k: i64) -> Angle {
    Angle::pi_fraction(k, 2)
}

/// A robot whose rows are `(kind, alpha in quarter turns, d, r)`.
fn robot(name: &str, convention: Convention, rows: &[(JointKind, i64, f64, f64)]) -> Robot {
    let joints = rows.iter().enumerate().map(|(i, &(kind, alpha, d, r))| Joint {
        name: format!("joint{}", i + 1),
        kind,
        actuated: true,
        alpha: turns(alpha),
        d: Length::meters(d),
        theta: Angle::zero(),
        r: Length::meters(r),
        source: None,
        limits: Limits::default(),
        drive: Drive::default(),
    });
    Robot {
        name: name.to_string(),
        convention,
        constants: Vec::new(),
        gravity: [0.0, 0.0, -9.81],
        base: None,
        joints: joints.collect(),
        links: Vec::new(),
        tool: None,
        collision: Collision::default(),
        log: None,
        effects: Vec::new(),
    }
}

fn revolute(name: &str, convention: Convention, rows: &[(i64, f64, f64)]) -> Robot {
    let rows: Vec<_> = rows.iter().map(|&(alpha, d, r)| (JointKind::Revolute, alpha, d, r)).collect();
    robot(name, convention, &rows)
}

/// KUKA LWR IV+, modified (Gaz, Flacco and De Luca, ICRA 2014).
pub fn kuka_lwr4() -> Robot {
    let rows = [(0, 0., 0.3105), (1, 0., 0.), (-1, 0., 0.4), (-1, 0., 0.), (1, 0., 0.39), (1, 0., 0.), (-1, 0., 0.)];
    revolute("kuka-lwr4", Convention::Modified, &rows)
}

/// KUKA LBR iiwa 14, modified.
pub fn kuka_iiwa14() -> Robot {
    let rows = [(0, 0., 0.36), (-1, 0., 0.), (1, 0., 0.42), (1, 0., 0.), (-1, 0., 0.4), (-1, 0., 0.), (1, 0., 0.126)];
    revolute("kuka-iiwa14", Convention::Modified, &rows)
}

/// Franka Emika Panda, modified (Gaz et al., RA-L 2019).
pub fn franka_panda() -> Robot {
    let rows = [
        (0, 0., 0.333),
        (-1, 0., 0.),
        (1, 0., 0.316),
        (1, 0.0825, 0.),
        (-1, -0.0825, 0.384),
        (1, 0., 0.),
        (1, 0.088, 0.),
    ];
    revolute("franka-panda", Convention::Modified, &rows)
}

/// Kinova Gen3, 7 axes, modified.
pub fn kinova_gen3() -> Robot {
    let rows = [
        (2, 0., -0.28481),
        (1, 0., -0.01175),
        (-1, 0., -0.42076),
        (1, 0., -0.01275),
        (-1, 0., -0.31436),
        (1, 0., -0.00035),
        (-1, 0., -0.167455),
    ];
    revolute("kinova-gen3", Convention::Modified, &rows)
}

/// Unimation Puma 560, modified (Craig, *Introduction to Robotics*, section 3.7).
pub fn puma560() -> Robot {
    let rows = [(0, 0., 0.), (-1, 0., 0.), (0, 0.4318, 0.1501), (-1, 0.0203, 0.4331), (1, 0., 0.), (-1, 0., 0.)];
    revolute("puma560", Convention::Modified, &rows)
}

/// Universal Robots UR5e, standard (the manufacturer's table).
pub fn ur5e() -> Robot {
    let rows = [(1, 0., 0.1625), (0, -0.425, 0.), (0, -0.3922, 0.), (1, 0., 0.1333), (-1, 0., 0.0997), (0, 0., 0.0996)];
    revolute("ur5e", Convention::Standard, &rows)
}

/// Two parallel axes, links of 0.5 and 0.4 m; gravity along -y, in the plane of motion.
pub fn planar_2r() -> Robot {
    let mut arm = revolute("planar-2r", Convention::Modified, &[(0, 0., 0.), (0, 0.5, 0.)]);
    arm.gravity = [0.0, -9.81, 0.0];
    arm
}

/// RRPR with four parallel axes, gravity along them.
pub fn scara() -> Robot {
    use JointKind::{Prismatic, Revolute};
    let rows = [(Revolute, 0, 0., 0.4), (Revolute, 0, 0.325, 0.), (Prismatic, 2, 0.275, 0.), (Revolute, 0, 0., 0.)];
    robot("scara", Convention::Modified, &rows)
}

/// The robot with a rotor inertia on every joint, kg m^2 or kg.
pub fn with_rotors(mut robot: Robot) -> Robot {
    for joint in robot.joints.iter_mut().filter(|j| j.kind != JointKind::Fixed) {
        joint.drive.rotor_inertia = Some(0.3);
    }
    robot
}

/// The robot with viscous and Coulomb friction and an offset on every joint.
pub fn with_friction(mut robot: Robot) -> Robot {
    for joint in robot.joints.iter_mut().filter(|j| j.kind != JointKind::Fixed) {
        joint.drive.viscous_friction = Some(2.0);
        joint.drive.coulomb_friction = Some(1.5);
        joint.drive.offset = Some(0.1);
    }
    robot
}

/// The robot on a base tilted about two axes: gravity of 9.81 m/s^2 in a generic direction.
pub fn tilted(mut robot: Robot) -> Robot {
    let (x, y): (f64, f64) = (0.3, -0.2);
    robot.gravity = [x, y, -(1.0 - x * x - y * y).sqrt()].map(|g| 9.81 * g);
    robot
}

/// The robot with random bodies for links.
pub fn with_inertias(mut robot: Robot, seed: u64) -> Robot {
    let mut random = Random::new(seed);
    robot.links = robot.joints.iter().map(|_| Some(random.inertia())).collect();
    robot
}
