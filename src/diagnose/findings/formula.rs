//! Finds a closed-form law for an error that matches no cause: a sparse regression over a
//! dictionary of terms in positions, velocities and accelerations. Only terms that halves of the
//! data choose repeatedly are kept.
//!
//! Stability selection (N. Meinshausen and P. Buehlmann, J. R. Statist. Soc. B 72, 2010). Let `p`
//! be the number of groups of terms, and `s` the mean number chosen in a half. Then at most `s^2 /
//! ((2 t - 1) p)` groups are expected by chance in a share `t` of the halves.

use std::fmt::Write as _;

use nalgebra::{DMatrix, DVector};

use super::evidence::short;
use crate::diagnose::fit::moments::pseudo_inverse;
use crate::numerics::parallel::{parallel, threads};
use crate::numerics::prng::Random;

/// Number of contiguous stretches of the data.
const STRETCHES: usize = 16;

/// Number of random halves.
const HALVES: usize = 40;

/// Share of the halves that must choose a group.
const STABLE: f64 = 0.8;

/// Maximum number of groups that a half chooses.
const MOST: usize = 4;

/// Share of the remaining squared error that a group must take.
const WORTH: f64 = 0.05;

/// Share of the squared error that a law must remove on unfitted data.
const GAIN: f64 = 0.1;

/// Range of the ratio of a law's size on unfitted data to the fitted size within which it holds.
const HOLDS: [f64; 2] = [0.5, 2.0];

/// Share of the explained squared error below which a term is dropped.
const SLIGHT: f64 = 0.002;

/// Least travel of a joint's angle in the argument of a sine or cosine, rad, and of a position: what
/// hardly changes is a constant, and several of them cancel.
const TRAVEL: f64 = 0.3;
const MOVES: f64 = 0.01;

/// Largest RMS of one term, by that of the joint's error.
const CANCELS: f64 = 3.0;

/// Maximum number of samples, spread over the data.
const SAMPLES: usize = 8000;

/// Motion of all joints and the error of one, sample by sample.
#[derive(Debug, Clone, Copy)]
pub(in crate::diagnose) struct Errors<'a> {
    /// Positions, velocities and accelerations of each joint: rad or m, and s.
    pub(in crate::diagnose) motion: &'a [[&'a [f64]; 3]],
    /// Error of the joint's torque, N m or N.
    pub(in crate::diagnose) error: &'a [f64],
}

/// A law of one joint's torque.
#[derive(Debug)]
pub(in crate::diagnose) struct Formula {
    /// Joint, from 0.
    pub joint: usize,
    /// The law, N m or N: `0.42*sign(dq2)*cos(2*q1)`, joints from 1.
    pub text: String,
    /// Root mean square of the joint's error without and with it on unfitted data, N m or N.
    pub validate: [f64; 2],
    /// Share of the halves of the data that chose the least stable of its terms.
    pub stability: f64,
    terms: Vec<Term>,
    /// Coefficients of the terms, rounded as in the text.
    x: Vec<f64>,
}

/// A factor of a term.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Factor {
    Position(usize),
    Velocity(usize),
    Acceleration(usize),
    Sign(usize),
    Speed(usize),
    Sine(u32, usize),
    Cosine(u32, usize),
}

impl Factor {
    fn joint(self) -> usize {
        match self {
            Self::Position(j) | Self::Velocity(j) | Self::Acceleration(j) | Self::Sign(j) | Self::Speed(j) => j,
            Self::Sine(_, j) | Self::Cosine(_, j) => j,
        }
    }

    fn at(self, motion: &[[&[f64]; 3]], k: usize) -> f64 {
        match self {
            Self::Position(j) => motion[j][0][k],
            Self::Velocity(j) => motion[j][1][k],
            Self::Acceleration(j) => motion[j][2][k],
            Self::Sign(j) => match motion[j][1][k] {
                v if v > 0.0 => 1.0,
                v if v < 0.0 => -1.0,
                _ => 0.0,
            },
            Self::Speed(j) => motion[j][1][k].abs(),
            Self::Sine(m, j) => (f64::from(m) * motion[j][0][k]).sin(),
            Self::Cosine(m, j) => (f64::from(m) * motion[j][0][k]).cos(),
        }
    }

    fn text(self) -> String {
        let angle = |m: u32, j: usize| if m == 1 { format!("q{}", j + 1) } else { format!("{m}*q{}", j + 1) };
        match self {
            Self::Position(j) => format!("q{}", j + 1),
            Self::Velocity(j) => format!("dq{}", j + 1),
            Self::Acceleration(j) => format!("ddq{}", j + 1),
            Self::Sign(j) => format!("sign(dq{})", j + 1),
            Self::Speed(j) => format!("abs(dq{})", j + 1),
            Self::Sine(m, j) => format!("sin({})", angle(m, j)),
            Self::Cosine(m, j) => format!("cos({})", angle(m, j)),
        }
    }
}

/// A product of factors.
type Term = Vec<Factor>;

/// Terms that are chosen together: sine and cosine of one angle.
type Group = Vec<Term>;

/// The dictionary of terms for joint `j` of `dof`.
fn dictionary(j: usize, dof: usize) -> Vec<Group> {
    use Factor::{Acceleration, Cosine, Position, Sign, Sine, Speed, Velocity};
    let mut groups: Vec<Group> = vec![vec![vec![]], vec![vec![Position(j)]]];
    for k in 0..dof {
        let most = if k == j { 6 } else { 3 };
        groups.extend((1..=most).map(|m| vec![vec![Sine(m, k)], vec![Cosine(m, k)]]));
        for before in [Sign(j), Velocity(j)] {
            groups.extend((1..=3).map(|m| vec![vec![Sine(m, k), before], vec![Cosine(m, k), before]]));
        }
        let alone = [vec![Velocity(k)], vec![Sign(k)], vec![Acceleration(k)], vec![Velocity(k), Speed(k)]];
        groups.extend(alone.map(|term| vec![term]));
        groups.push(vec![vec![Velocity(j), Velocity(k)]]);
        if k != j {
            groups.extend([vec![Sign(j), Speed(k)], vec![Sign(k), Speed(j)]].map(|term| vec![term]));
            groups.push(vec![vec![Sign(j), Sign(k)]]);
            groups.push(vec![vec![Velocity(k), Velocity(k)]]);
            groups.extend((1..=3).map(|m| vec![vec![Sine(m, j), Sign(k)], vec![Cosine(m, j), Sign(k)]]));
        }
    }
    groups.push(vec![vec![Velocity(j), Velocity(j), Velocity(j)]]);
    groups
}

/// Whether the motion changes each factor of a term enough.
/// `travel`: of each joint, rad or m.
fn shows(term: &Term, travel: &[f64]) -> bool {
    term.iter().all(|factor| {
        let travel = travel[factor.joint()];
        match factor {
            Factor::Sine(m, _) | Factor::Cosine(m, _) => f64::from(*m) * travel >= TRAVEL,
            _ => travel >= MOVES,
        }
    })
}

/// Travel of each joint, rad or m.
fn travel(motion: &[[&[f64]; 3]]) -> Vec<f64> {
    let ends = |q: &[f64]| q.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)]);
    motion.iter().map(|[q, ..]| ends(q)).map(|[low, high]| high - low).collect()
}

fn value(term: &Term, motion: &[[&[f64]; 3]], k: usize) -> f64 {
    term.iter().map(|f| f.at(motion, k)).product()
}

/// Sums of squares and products of all terms and of the error, over a stretch.
#[derive(Clone)]
struct Sums {
    gram: DMatrix<f64>,
    with: DVector<f64>,
    squares: f64,
}

fn sums(terms: &[Term], data: Errors<'_>) -> Vec<Sums> {
    let (n, len) = (terms.len(), data.error.len());
    let every = len.div_ceil(SAMPLES).max(1);
    let stretch = |s: usize| {
        let picks: Vec<usize> = (s * len / STRETCHES..(s + 1) * len / STRETCHES).step_by(every).collect();
        let rows = DMatrix::from_fn(picks.len(), n, |i, t| value(&terms[t], data.motion, picks[i]));
        let error = DVector::from_iterator(picks.len(), picks.iter().map(|&k| data.error[k]));
        Sums { gram: rows.tr_mul(&rows), with: rows.tr_mul(&error), squares: error.norm_squared() }
    };
    parallel(threads(), STRETCHES, stretch)
}

fn total<'s>(parts: impl Iterator<Item = &'s Sums>) -> Option<Sums> {
    parts.cloned().reduce(|a, b| Sums { gram: a.gram + b.gram, with: a.with + b.with, squares: a.squares + b.squares })
}

/// Least-squares coefficients of these terms alone, and the remaining squared error.
fn fitted(of: &Sums, terms: &[usize]) -> (DVector<f64>, f64) {
    let gram = of.gram.select_rows(terms).select_columns(terms);
    let with = of.with.select_rows(terms);
    let x = pseudo_inverse(&gram) * &with;
    let left = of.squares - 2.0 * x.dot(&with) + x.dot(&(&gram * &x));
    (x, left.max(0.0))
}

/// Groups chosen by forward selection, at most [`MOST`].
fn selected(of: &Sums, members: &[Vec<usize>]) -> Vec<usize> {
    let mut groups: Vec<usize> = Vec::new();
    let mut left = of.squares;
    while groups.len() < MOST {
        let with = |g: usize| -> Vec<usize> { groups.iter().chain([&g]).flat_map(|&g| members[g].clone()).collect() };
        let tried = (0..members.len()).filter(|g| !groups.contains(g)).map(|g| (g, fitted(of, &with(g)).1));
        let Some((best, less)) = tried.min_by(|a, b| a.1.total_cmp(&b.1)) else { break };
        if less > (1.0 - WORTH) * left {
            break;
        }
        groups.push(best);
        left = less;
    }
    groups
}

/// Drops terms whose removal costs less than [`SLIGHT`] of the explained squared error: sine or
/// cosine alone may suffice.
fn needed(of: &Sums, mut terms: Vec<usize>) -> Vec<usize> {
    while terms.len() > 1 {
        let left = fitted(of, &terms).1;
        let without = |t: &usize| fitted(of, &terms.iter().copied().filter(|k| k != t).collect::<Vec<usize>>()).1;
        let Some((least, more)) = terms.iter().map(|t| (*t, without(t) - left)).min_by(|a, b| a.1.total_cmp(&b.1))
        else {
            break;
        };
        if more > SLIGHT * (of.squares - left) {
            break;
        }
        terms.retain(|t| *t != least);
    }
    terms
}

/// The number as written in the law: four digits.
fn rounded(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}

fn text(terms: &[Term], x: &[f64]) -> String {
    let mut text = String::new();
    for (term, x) in terms.iter().zip(x).filter(|(_, x)| **x != 0.0) {
        let sign = match (text.is_empty(), *x < 0.0) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let _ = write!(text, "{sign}{}", x.abs());
        term.iter().for_each(|f| text.extend(["*", &f.text()]));
    }
    text
}

/// Torque of a law at a sample, N m or N.
fn torque(terms: &[Term], x: &[f64], motion: &[[&[f64]; 3]], k: usize) -> f64 {
    terms.iter().zip(x).map(|(term, x)| x * value(term, motion, k)).sum()
}

/// Root mean square error without and with a law, and the ratio of the law's size in these data to
/// its fitted size.
fn measured(terms: &[Term], x: &[f64], data: Errors<'_>) -> ([f64; 2], f64) {
    let (mut before, mut after, mut pull, mut own) = (0.0, 0.0, 0.0, 0.0);
    for (k, e) in data.error.iter().enumerate() {
        let law = torque(terms, x, data.motion, k);
        before += e * e;
        after += (e - law).powi(2);
        pull += e * law;
        own += law * law;
    }
    let rms = |sum: f64| (sum / data.error.len().max(1) as f64).sqrt();
    ([rms(before), rms(after)], if own > 0.0 { pull / own } else { 0.0 })
}

/// A law of the error of joint `j` that recurs in the fitted data and holds on others; `None` if
/// there is none.
pub(in crate::diagnose) fn formula(j: usize, fit: Errors<'_>, validate: Errors<'_>) -> Option<Formula> {
    let mut groups = dictionary(j, fit.motion.len());
    let travel = travel(fit.motion);
    groups.retain(|group| group.iter().all(|term| shows(term, &travel)));
    let terms: Vec<Term> = groups.iter().flatten().cloned().collect();
    let mut first = 0;
    let own = |group: &Group| {
        first += group.len();
        (first - group.len()..first).collect::<Vec<usize>>()
    };
    let members: Vec<Vec<usize>> = groups.iter().map(own).collect();
    let parts = sums(&terms, fit);
    let mut counts = vec![0usize; groups.len()];
    let mut random = Random::new(1);
    let mut shuffled = || {
        let mut order: Vec<(u64, usize)> = (0..STRETCHES).map(|s| (random.bits(), s)).collect();
        order.sort_unstable();
        order
    };
    let orders: Vec<Vec<(u64, usize)>> = (0..HALVES).map(|_| shuffled()).collect();
    let chosen = parallel(threads(), HALVES, |half| {
        let half = total(orders[half][..STRETCHES / 2].iter().map(|(_, s)| &parts[*s]));
        half.map_or_else(Vec::new, |half| selected(&half, &members))
    });
    chosen.into_iter().flatten().for_each(|g| counts[g] += 1);
    let stable: Vec<usize> = (0..groups.len()).filter(|&g| counts[g] as f64 >= STABLE * HALVES as f64).collect();
    let least = stable.iter().map(|&g| counts[g]).min()?;
    let whole = total(parts.iter())?;
    let chosen = needed(&whole, stable.iter().flat_map(|&g| members[g].clone()).collect());
    let x: Vec<f64> = fitted(&whole, &chosen).0.iter().map(|x| rounded(*x)).collect();
    let law: Vec<Term> = chosen.iter().map(|&t| terms[t].clone()).collect();
    let ([before, after], size) = measured(&law, &x, validate);
    let cancels = chosen.iter().zip(&x).any(|(&t, x)| x * x * whole.gram[(t, t)] > CANCELS * CANCELS * whole.squares);
    let holds = !cancels && after * after < (1.0 - GAIN) * before * before && (HOLDS[0]..HOLDS[1]).contains(&size);
    holds.then(|| Formula {
        joint: j,
        text: text(&law, &x),
        validate: [before, after],
        stability: least as f64 / HALVES as f64,
        terms: law,
        x,
    })
}

impl Formula {
    /// Whether each of its terms contains the motion of another joint.
    pub(in crate::diagnose) fn is_of_other_joints(&self) -> bool {
        self.terms.iter().all(|term| term.iter().any(|factor| factor.joint() != self.joint))
    }

    /// Torque along a motion of all joints, N m or N.
    pub(in crate::diagnose) fn along(&self, motion: &[[&[f64]; 3]]) -> Vec<f64> {
        let len = motion.first().map_or(0, |joint| joint[0].len());
        (0..len).map(|k| torque(&self.terms, &self.x, motion, k)).collect()
    }

    /// A sentence with figures; `on` names the unfitted data.
    pub(in crate::diagnose) fn sentence(&self, on: &str) -> String {
        format!(
            "joint {}: the model lacks {}; the error falls from {} to {} N m on {on}, and {:.0} % of halves of \
             the fitted logs choose these terms",
            self.joint + 1,
            self.text,
            short(self.validate[0]),
            short(self.validate[1]),
            100.0 * self.stability,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Motions of four joints as sums of sines, with their derivatives, by seed.
    fn motion(seed: u64) -> Vec<Joint> {
        let mut random = Random::new(seed);
        let joint = |_| {
            let waves: Vec<[f64; 3]> =
                (0..5).map(|k| [random.uniform(0.1, 0.5), 0.4 * f64::from(k + 1), random.uniform(0.0, 6.0)]).collect();
            let along = |f: &dyn Fn(&[f64; 3], f64) -> f64| -> Vec<f64> {
                (0..3000).map(|k| waves.iter().map(|w| f(w, f64::from(k) * 0.01)).sum()).collect()
            };
            [
                along(&|[a, w, p], t| a * (w * t + p).sin()),
                along(&|[a, w, p], t| a * w * (w * t + p).cos()),
                along(&|[a, w, p], t| -a * w * w * (w * t + p).sin()),
            ]
        };
        (0..4).map(joint).collect()
    }

    /// Position, velocity and acceleration of a joint.
    type Joint = [Vec<f64>; 3];

    fn found(law: &dyn Fn(&[Joint], usize) -> f64, noise: f64, memory: f64, seed: u64) -> Option<Formula> {
        let motions = [motion(seed), motion(seed + 1000)];
        let mut random = Random::new(seed + 7);
        let errors = motions.each_ref().map(|m| {
            let mut slow = 0.0;
            let sample = |k: usize| {
                slow = memory * slow + (1.0 - memory * memory).sqrt() * random.even(1.732 * noise);
                law(m, k) + slow
            };
            (0..3000).map(sample).collect::<Vec<f64>>()
        });
        let views = motions.each_ref().map(|m| m.iter().map(|j| j.each_ref().map(|x| &x[..])).collect::<Vec<_>>());
        let [fit, validate] = [0, 1].map(|i| Errors { motion: &views[i], error: &errors[i] });
        formula(1, fit, validate)
    }

    #[test]
    fn a_law_of_two_joints_is_found_with_its_size() {
        let law = |m: &[Joint], k: usize| 0.8 * (3.0 * m[1][0][k]).sin() * m[3][1][k].signum();
        for seed in 1..6 {
            let found = found(&law, 0.4, 0.9, seed).expect("a law");
            assert!(found.text.contains("*sin(3*q2)*sign(dq4)"), "{}", found.text);
            let size: f64 = found.text.split('*').next().unwrap().parse().unwrap();
            assert!((size - 0.8).abs() < 0.1, "{}", found.text);
            assert!(found.stability >= STABLE && found.validate[1] < 0.75 * found.validate[0]);
        }
    }

    #[test]
    fn a_sum_of_two_laws_is_found() {
        let law = |m: &[Joint], k: usize| 2.0 * m[1][1][k] * m[1][1][k].abs() + 0.5 * (m[2][0][k] - 0.4).cos();
        let found = found(&law, 0.15, 0.8, 3).expect("a law");
        assert!(found.text.contains("*dq2*abs(dq2)") && found.text.contains("*cos(q3)"), "{}", found.text);
    }

    /// On a joint that stands, a sine is a constant, and harmonics of it cancel each other at any size.
    #[test]
    fn a_joint_that_stands_is_in_no_law() {
        let wave = |k: usize, w: f64| (w * 0.01 * k as f64).sin();
        let still: Vec<f64> = (0..4000).map(|k| 0.7 + 1e-5 * wave(k, 0.3)).collect();
        let slow: Vec<f64> = (0..4000).map(|k| 3e-6 * wave(k, 0.9)).collect();
        let moving: Vec<f64> = (0..4000).map(|k| 2.0 * wave(k, 1.1)).collect();
        let travel = travel(&[[&still[..], &slow, &slow], [&moving, &moving, &moving]]);
        for term in dictionary(0, 2).into_iter().flatten().filter(|term| shows(term, &travel)) {
            assert!(term.iter().all(|factor| factor.joint() == 1), "{}", text(std::slice::from_ref(&term), &[1.0]));
        }
        assert!(shows(&vec![Factor::Sine(1, 1), Factor::Sign(1)], &travel));
    }

    /// Slow noise correlates with slow motion in the fitted data only.
    #[test]
    fn noise_has_no_law() {
        for memory in [0.0, 0.9, 0.99] {
            let count = (1..21).filter(|&seed| found(&|_, _| 0.0, 0.5, memory, 100 + seed).is_some()).count();
            assert_eq!(count, 0, "memory {memory}");
        }
    }

    #[test]
    fn a_law_is_written_as_it_is_computed() {
        use Factor::{Sign, Sine, Velocity};
        let terms = [vec![Sine(2, 0), Sign(1)], vec![], vec![Velocity(2)]];
        assert_eq!(text(&terms, &[-0.5, 0.25, 1e-3]), "-0.5*sin(2*q1)*sign(dq2) + 0.25 + 0.001*dq3");
    }
}
