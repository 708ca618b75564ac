//! Random arms and states for tests, from a seed: the same on every machine and in every version (so no crate's generator).

use dh_codegen::robot::{Angle, Collision, Convention, Drive, Inertia, Joint, JointKind, Length, Limits, Robot, Tool};

/// splitmix64 (Steele, Lea and Flood 2014).
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// From a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Evenly between `-size` and `size`.
    pub fn even(&mut self, size: f64) -> f64 {
        ((self.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0) * size
    }

    /// One of `n`.
    pub fn pick(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// Several numbers.
    pub fn vector(&mut self, len: usize, size: f64) -> Vec<f64> {
        (0..len).map(|_| self.even(size)).collect()
    }

    /// A body made of points: always physically possible.
    pub fn inertia(&mut self) -> Inertia {
        (0..5).fold(Inertia::default(), |sum, _| {
            let m = 0.2 + self.even(0.15).abs();
            let [x, y, z] = [self.even(0.3), self.even(0.3), self.even(0.3)];
            let i = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z].map(|v| m * v);
            sum.plus(&Inertia { m, ms: [m * x, m * y, m * z], i })
        })
    }
}

/// A chain of `rows` rows: mostly right angles and some generic ones, both conventions, prismatic and fixed rows, offsets, any
/// gravity, sometimes drives and a tool.
pub fn random_robot(seed: u64, rows: usize) -> Robot {
    let mut random = Random::new(seed);
    let nice = random.pick(3) > 0;
    let angle = |random: &mut Random| {
        if nice || random.pick(2) == 0 {
            Angle::pi_fraction(random.pick(4) as i64 - 1, 2)
        } else {
            Angle::radians(random.even(3.0))
        }
    };
    let length =
        |random: &mut Random| if random.pick(2) == 0 { Length::zero() } else { Length::meters(random.even(0.6)) };
    let joints = (0..rows)
        .map(|row| {
            let kind = match random.pick(8) {
                0 | 1 => JointKind::Prismatic,
                2 if rows > 1 => JointKind::Fixed,
                _ => JointKind::Revolute,
            };
            let mut drive = Drive::default();
            if kind != JointKind::Fixed {
                let some = |random: &mut Random| (random.pick(2) == 0).then(|| random.even(1.0).abs());
                drive.rotor_inertia = some(&mut random);
                drive.viscous_friction = some(&mut random);
                drive.coulomb_friction = some(&mut random);
                drive.offset = some(&mut random);
            }
            Joint {
                name: format!("joint{}", row + 1),
                kind,
                actuated: true,
                alpha: angle(&mut random),
                d: length(&mut random),
                theta: angle(&mut random),
                r: length(&mut random),
                limits: Limits::default(),
                drive,
            }
        })
        .collect();
    let gravity = match random.pick(3) {
        0 => [0.0, 0.0, -9.81],
        1 => [9.81, 0.0, 0.0],
        _ => [random.even(9.0), random.even(9.0), random.even(9.0)],
    };
    let links = (0..rows).map(|_| Some(random.inertia())).collect();
    let tool = (random.pick(3) == 0).then(|| Tool {
        name: "tool".into(),
        xyz: [random.even(0.2), 0.0, random.even(0.3)],
        rpy: [angle(&mut random), Angle::zero(), angle(&mut random)],
        inertia: Some(random.inertia()),
        geometry: None,
    });
    Robot {
        name: format!("random-{seed}"),
        convention: if random.pick(2) == 0 { Convention::Modified } else { Convention::Standard },
        constants: Vec::new(),
        gravity,
        joints,
        links,
        tool,
        collision: Collision::default(),
        effects: Vec::new(),
    }
}
