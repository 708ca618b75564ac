//! Inverse kinematics of random members of each family: the posture that made a pose is among its
//! solutions, at random, at nice angles, and at and beside singularities.

use core::f64::consts::{PI, TAU};

use dh_codegen::arm::{Inverse, Model};
use dh_codegen::ik::{Arm, Query, Reference, Status};
use dh_codegen::robot::{Angle, Convention, JointKind, Length, Robot, no_files};

struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }
    fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }
    fn one_of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len() as u64) as usize]
    }
}

/// A row in the modified convention: twist, d, offset, r; the letters say what may be there.
/// `+` a quarter turn either way or an oblique one, `0` parallel, `|` exactly square.
#[derive(Clone, Copy)]
struct Row(char, char, f64, f64);

/// `kinds`, `twists`, which `d` and which `r` are not zero.
fn rows(random: &mut Random, kinds: &str, twists: &str, d: &str, r: &str) -> Vec<Row> {
    let pick = |random: &mut Random, c: char| {
        if c == '0' { 0.0 } else { random.one_of(&[1.0, -1.0]) * random.uniform(0.1, 0.6) }
    };
    kinds
        .chars()
        .zip(twists.chars())
        .zip(d.chars().zip(r.chars()))
        .map(|((k, t), (d, r))| Row(k, t, pick(random, d), pick(random, r)))
        .collect()
}

/// As a robot of either convention; a standard row takes twist and d of the row after it.
fn robot(random: &mut Random, rows: &[Row], oblique: bool) -> Robot {
    let standard = random.below(2) == 1;
    let text = "name: x\nconvention: modified\njoints: [ { type: revolute } ]\n";
    let mut robot = Robot::from_yaml(text, &no_files).unwrap().robot;
    let template = robot.joints[0].clone();
    let twist = |random: &mut Random, c: char| match c {
        '0' => Angle::pi_fraction(random.below(2) as i64, 1),
        '+' if oblique => Angle::radians(random.one_of(&[1.0, -1.0]) * random.uniform(0.6, 1.4)),
        _ => Angle::pi_fraction(random.one_of(&[1, -1]), 2),
    };
    let made: Vec<(Angle, f64)> = rows.iter().map(|row| (twist(random, row.1), row.2)).collect();
    robot.joints = (0..rows.len())
        .map(|i| {
            let mut joint = template.clone();
            joint.name = format!("j{i}");
            joint.kind = if rows[i].0 == 'P' { JointKind::Prismatic } else { JointKind::Revolute };
            let (alpha, d) = match standard {
                false => made[i].clone(),
                true => made.get(i + 1).cloned().unwrap_or((Angle::pi_fraction(random.below(4) as i64, 2), 0.07)),
            };
            (joint.alpha, joint.d, joint.r) = (alpha, Length::meters(d), Length::meters(rows[i].3));
            joint.theta = match random.below(3) {
                0 => Angle::zero(),
                1 => Angle::pi_fraction(random.below(4) as i64, 2),
                _ => Angle::radians(random.uniform(-3.0, 3.0)),
            };
            joint
        })
        .collect();
    robot.convention = if standard { Convention::Standard } else { Convention::Modified };
    robot
}

/// Figures of one family.
#[derive(Default, Debug)]
struct Figures {
    arms: usize,
    unknown: usize,
    postures: usize,
    missed: usize,
    /// Neither found nor said to be singular when it is not named as near.
    unmarked: usize,
    worst: f64,
}

fn examine<const N: usize>(inverse: &Inverse, random: &mut Random, postures: usize, figures: &mut Figures, name: &str) {
    let arm: Arm<N> = inverse.arm(&[None; N]).unwrap();
    for k in 0..postures {
        let kind = k % 4;
        let step = random.one_of(&[15.0, 30.0, 45.0, 90.0]) * PI / 180.0;
        let small = random.one_of(&[0.0, 0.0, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12]);
        let q: [f64; N] = core::array::from_fn(|i| {
            if arm.axes[i].slides {
                return if kind == 1 { random.one_of(&[0.1, 0.25, 0.5]) } else { random.uniform(0.1, 0.9) };
            }
            let any = random.uniform(-PI, PI);
            let nice = (any / step).round() * step;
            match kind {
                0 => any,
                1 => nice,
                _ if random.below(2) == 0 => any,
                _ => nice + small * random.uniform(-1.0, 1.0),
            }
        });
        let redundancy = arm.redundancy(&q, &Reference::UP);
        let pose = arm.forward(&q);
        let query = Query { redundancy, near: Some(&q), ..Query::default() };
        let solutions = arm.solve(&pose, &query).unwrap();
        let mut nearest = f64::INFINITY;
        for s in solutions.as_slice() {
            let again = arm.forward(&s.q);
            for (a, b) in again.as_flattened().iter().zip(pose.as_flattened()) {
                figures.worst = figures.worst.max((a - b).abs());
            }
            let far = (0..N).fold(0.0f64, |m, i| {
                let d = s.q[i] - q[i];
                m.max(if arm.axes[i].slides { d } else { d - TAU * (d / TAU).round() }.abs())
            });
            nearest = nearest.min(far);
        }
        // Not named as near, it is there too, or some joint is said to be free.
        let blind = arm.solve(&pose, &Query { redundancy, ..Query::default() }).unwrap();
        let far = |s: &[f64; N]| {
            (0..N).fold(0.0f64, |m, i| {
                let d = s[i] - q[i];
                m.max(if arm.axes[i].slides { d } else { d - TAU * (d / TAU).round() }.abs())
            })
        };
        let own = blind.as_slice().iter().any(|s| far(&s.q) < 1e-4);
        if !own && blind.status != Status::Singular && !blind.uncertain {
            figures.unmarked += 1;
            if figures.unmarked < 6 {
                let n = blind.as_slice().len();
                eprintln!(
                    "{name}: unmarked, kind {kind} small {small:e} q {q:?}: {:?} {n}, {}",
                    blind.status, inverse.reason
                );
            }
        }
        figures.postures += 1;
        if nearest.is_nan() || nearest >= 1e-5 {
            figures.missed += 1;
            if figures.missed < 6 {
                eprintln!(
                    "{name}: kind {kind} small {small:e} {:?} q {q:?}: {nearest:e} of {} {:?}, {}",
                    solutions.status,
                    solutions.as_slice().len(),
                    solutions.distance,
                    inverse.reason
                );
                if solutions.as_slice().is_empty() {
                    eprintln!("   lost {}", solutions.lost);
                }
            }
        }
    }
}

/// Can a joint move and nothing else with it, in every posture? Then the arm belongs to no family.
fn degenerate(inverse: &Inverse) -> bool {
    fn rank<const N: usize>(inverse: &Inverse) -> bool {
        let arm: Arm<N> = inverse.arm(&[None; N]).unwrap();
        let q: [f64; N] = core::array::from_fn(|i| 0.3 + 0.37 * i as f64);
        let columns: Vec<[f64; 12]> = (0..N)
            .map(|i| {
                let (mut up, mut down) = (q, q);
                up[i] += 1e-5;
                down[i] -= 1e-5;
                let (a, b) = (arm.forward(&up), arm.forward(&down));
                core::array::from_fn(|k| (a.as_flattened()[k] - b.as_flattened()[k]) / 2e-5)
            })
            .collect();
        // Gram-Schmidt.
        let mut basis: Vec<Vec<f64>> = Vec::new();
        for c in &columns {
            let mut v = c.to_vec();
            for b in &basis {
                let d: f64 = v.iter().zip(b).map(|(x, y)| x * y).sum();
                v.iter_mut().zip(b).for_each(|(x, y)| *x -= d * y);
            }
            let n = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            if n > 1e-6 {
                basis.push(v.iter().map(|x| x / n).collect());
            }
        }
        basis.len() < N.min(6)
    }
    match inverse.axes.len() {
        1 => rank::<1>(inverse),
        2 => rank::<2>(inverse),
        3 => rank::<3>(inverse),
        4 => rank::<4>(inverse),
        5 => rank::<5>(inverse),
        6 => rank::<6>(inverse),
        _ => rank::<7>(inverse),
    }
}

fn family(name: &str, class: &str, shapes: &[[&str; 4]], oblique: bool) -> Figures {
    let arms: usize = std::env::var("DENAVIT_IK_ARMS").ok().and_then(|n| n.parse().ok()).unwrap_or(6);
    let postures: usize = std::env::var("DENAVIT_IK_MEMBER_POSTURES").ok().and_then(|n| n.parse().ok()).unwrap_or(40);
    let mut figures = Figures::default();
    let mut random = Random(name.bytes().fold(11u64, |s, b| s.wrapping_mul(31).wrapping_add(u64::from(b))));
    for k in 0..arms.max(shapes.len()) {
        let [kinds, twists, d, r] = shapes[k % shapes.len()];
        let rows = rows(&mut random, kinds, twists, d, r);
        let robot = robot(&mut random, &rows, oblique);
        let inverse = Inverse::new(Model::new(&robot).chain());
        if degenerate(&inverse) {
            continue;
        }
        figures.arms += 1;
        if !class.split('|').any(|c| c == inverse.class) || !inverse.exact {
            figures.unknown += 1;
            eprintln!("{name}: {kinds} {twists} {d} {r}: {} {}", inverse.class, inverse.reason);
            continue;
        }
        match rows.len() {
            1 => examine::<1>(&inverse, &mut random, postures, &mut figures, name),
            2 => examine::<2>(&inverse, &mut random, postures, &mut figures, name),
            3 => examine::<3>(&inverse, &mut random, postures, &mut figures, name),
            4 => examine::<4>(&inverse, &mut random, postures, &mut figures, name),
            5 => examine::<5>(&inverse, &mut random, postures, &mut figures, name),
            6 => examine::<6>(&inverse, &mut random, postures, &mut figures, name),
            _ => examine::<7>(&inverse, &mut random, postures, &mut figures, name),
        }
    }
    eprintln!("{name}: {figures:?}");
    figures
}

macro_rules! family {
    ($test:ident, $class:literal, $oblique:literal, $missed:literal, $($shape:expr),+ $(,)?) => {
        #[test]
        fn $test() {
            let figures = family(stringify!($test), $class, &[$($shape),+], $oblique);
            assert_eq!(figures.unknown, 0);
            assert!(figures.worst < 1e-12, "{figures:?}");
            assert!(figures.missed as f64 <= $missed * figures.postures as f64, "{figures:?}");
            assert!(figures.unmarked as f64 <= $missed * figures.postures as f64, "{figures:?}");
        }
    };
}

family!(
    swivel,
    "srs",
    false,
    0.0,
    ["RRRRRRR", "+||||||", "d000000", "r0r0r0r"],
    ["RRRRRRR", "0||||||", "0000000", "r0r0r00"]
);
family!(general, "none", true, 0.0, ["RRRRRR", "++++++", "dddddd", "rrrrrr"]);
family!(general_square, "none", false, 0.0, ["RRRRRR", "+|||||", "dddddd", "rrrrrr"]);
family!(
    general_offset_wrist,
    "none",
    false,
    0.0,
    ["RRRRRR", "+|0|||", "00d000", "r00rrr"],
    ["RRRRRR", "+|0|||", "00dd0d", "r00r0r"]
);
family!(general_seven, "none", true, 0.0, ["RRRRRRR", "+++++++", "ddddddd", "rrrrrrr"]);
family!(swivel_oblique, "srs", true, 0.0, ["RRRRRRR", "+++||++", "d000000", "r0r0r0r"]);
family!(
    panda_like,
    "7r-offset",
    false,
    0.0,
    ["RRRRRRR", "+||||||", "0000dd0", "r0r0r0r"],
    ["RRRRRRR", "+||||||", "000dd0d", "r0r0r00"]
);
family!(
    puma_like,
    "6r-spherical-wrist",
    false,
    0.0,
    ["RRRRRR", "+|0|||", "0ddd00", "rrrr0r"],
    ["RRRRRR", "+|0|||", "00dd00", "r00r0r"]
);
family!(
    wrist_meet,
    "6r-spherical-wrist",
    false,
    0.0,
    ["RRRRRR", "+|||||", "d0dd00", "r0rr0r"],
    ["RRRRRR", "+|||||", "dd0d00", "rr0r0r"]
);
family!(wrist_parallel, "6r-spherical-wrist", false, 0.0, ["RRRRRR", "+0||||", "dddd00", "rrrr0r"]);
family!(
    wrist_oblique,
    "6r-spherical-wrist",
    true,
    0.0,
    ["RRRRRR", "++0+++", "dddd00", "rrrr0r"],
    ["RRRRRR", "++++++", "d0dd00", "r0rr0r"]
);
family!(wrist_general, "6r-spherical-wrist", true, 0.0, ["RRRRRR", "++++++", "dddd00", "rrrr0r"]);
family!(
    shoulder,
    "6r-spherical-wrist",
    false,
    0.0,
    ["RRRRRR", "+||0||", "d00ddd", "r0rrrr"],
    ["RRRRRR", "+|||||", "d00d0d", "r0rr0r"]
);
family!(
    ur_like,
    "6r-three-parallel",
    false,
    0.0,
    ["RRRRRR", "+|00||", "d0dd00", "rrrrrr"],
    ["RRRRRR", "+|00||", "dddd00", "rrrrrr"]
);
family!(ur_oblique, "6r-three-parallel", true, 0.0, ["RRRRRR", "++00++", "dddd00", "rrrrrr"]);
family!(three_parallel_general, "6r-three-parallel", true, 0.002, ["RRRRRR", "++00++", "dddddd", "rrrrrr"]);
family!(
    stanford_like,
    "stanford",
    false,
    0.0,
    ["RRPRRR", "+||0||", "000000", "rrr00r"],
    ["RRPRRR", "+||+||", "d0d000", "rrrr0r"]
);
family!(
    sliding,
    "6-spherical-wrist|stanford",
    false,
    0.002,
    ["PRRRRR", "++0|||", "dddd00", "rrrr0r"],
    ["RPRRRR", "+|||||", "dddd00", "rrrr0r"],
    ["RRPRRR", "++++||", "dddd00", "rrrr0r"],
    ["RPPRRR", "++||||", "dddd00", "rrrr0r"],
    ["PPRRRR", "++||||", "dddd00", "rrrr0r"],
    ["PRPRRR", "++||||", "dddd00", "rrrr0r"],
    ["PPPRRR", "+|||||", "dddd00", "rrrr0r"]
);
family!(
    scara_like,
    "scara",
    false,
    0.0,
    ["RRPR", "+000", "dddd", "rrrr"],
    ["RRRP", "+000", "dddd", "rrrr"],
    ["PRRR", "+000", "dddd", "rrrr"],
    ["RPRR", "+000", "dddd", "rrrr"]
);
family!(
    planar,
    "planar|3-axis",
    false,
    0.0,
    ["RRR", "+00", "ddd", "rrr"],
    ["RR", "+0", "dd", "rr"],
    ["R", "+", "d", "r"],
    ["RP", "+|", "dd", "rr"],
    ["PR", "+|", "dd", "rr"],
    ["RPR", "+||", "ddd", "rrr"],
    ["RRP", "+0|", "ddd", "rrr"],
    ["PRR", "+|0", "ddd", "rrr"]
);
family!(
    cartesian,
    "cartesian|scara|4-axis",
    false,
    0.0,
    ["PPP", "+||", "ddd", "rrr"],
    ["PP", "+|", "dd", "rr"],
    ["P", "+", "d", "r"],
    ["PPPR", "+||0", "dddd", "rrrr"]
);
family!(
    five,
    "5-axis",
    false,
    0.0,
    ["RRRRR", "+|00|", "d0dd0", "rrrrr"],
    ["RRRRR", "+|0||", "d0dd0", "rrrr0"],
    ["RRRRR", "+||0|", "d0ddd", "rr00r"]
);
family!(
    four,
    "4-axis",
    false,
    0.0,
    ["RRRR", "+|00", "d0dd", "rrrr"],
    ["RRRR", "+|||", "dddd", "rrrr"],
    ["RRPR", "+|||", "dddd", "rrrr"]
);
family!(
    three,
    "3-axis|scara",
    false,
    0.0,
    ["RRR", "+|0", "ddd", "rrr"],
    ["RRR", "+||", "d0d", "rrr"],
    ["RRP", "+||", "ddd", "rrr"],
    ["RPP", "+0|", "ddd", "rrr"]
);
