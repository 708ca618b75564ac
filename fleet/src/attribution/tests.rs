use denavit::numerics::prng::Random;
use nalgebra::{DMatrix, DVector};

use super::{Assumptions, CERTAIN, DayEvidence, Explanation, JointEvidence, explanations};
use crate::channel::{Channel, Kind};

const ROWS: usize = 12;
const ASSUMPTIONS: Assumptions = Assumptions { change: 10.0, correlation: 0.0 };

/// Normal, by Box and Muller.
fn gauss(draws: &mut Random) -> f64 {
    let (u, v) = (draws.uniform(1e-300, 1.0), draws.uniform(0.0, std::f64::consts::TAU));
    (-2.0 * u.ln()).sqrt() * v.cos()
}

/// A robot of one joint: how channels wander, and which of them show the same.
struct Robot {
    draws: Random,
    scatters: Vec<f64>,
    alike: Option<[usize; 2]>,
}

impl Robot {
    fn channels(&self) -> Vec<Channel> {
        (1..=self.scatters.len()).map(|joint| Channel::unplaced(Kind::Offset, joint)).collect()
    }

    /// A day whose channels changed by so much; its motion is another one each day.
    fn day(&mut self, changes: &[f64]) -> DayEvidence {
        let draws = &mut self.draws;
        let mut torques: Vec<DVector<f64>> =
            self.scatters.iter().map(|_| DVector::from_fn(ROWS, |_, _| 10.0 * gauss(draws))).collect();
        if let Some([a, b]) = self.alike {
            torques[b] = torques[a].clone();
        }
        let mut residual = DVector::from_fn(ROWS, |_, _| gauss(draws));
        for ((torque, scatter), change) in torques.iter().zip(&self.scatters).zip(changes) {
            residual += torque * (change + scatter * gauss(draws));
        }
        let n = torques.len();
        DayEvidence(vec![JointEvidence {
            channels: (0..n).collect(),
            gram: DMatrix::from_fn(n, n, |a, b| torques[a].dot(&torques[b])),
            score: DVector::from_fn(n, |a, _| torques[a].dot(&residual)),
            square: residual.dot(&residual),
            rows: ROWS,
        }])
    }

    fn explained(&mut self, changes: &[f64]) -> Vec<Explanation> {
        let still = vec![0.0; changes.len()];
        let before: Vec<DayEvidence> = (0..16).map(|_| self.day(&still)).collect();
        let after: Vec<DayEvidence> = (0..3).map(|_| self.day(changes)).collect();
        explanations(&self.channels(), &before, &after, ASSUMPTIONS)
    }
}

#[test]
fn what_wanders_every_day_explains_nothing() {
    for seed in 0..20 {
        // The last channel wanders by more than the first changes.
        let mut robot = Robot { draws: Random::new(seed), scatters: vec![0.005, 0.02, 0.1, 1.0], alike: None };
        let found = robot.explained(&[0.3, 0.0, 0.0, 0.0]);
        assert_eq!(found[0].joint, 1, "seed {seed}: {found:?}");
        assert!(found[0].probability > CERTAIN, "seed {seed}: {found:?}");
        let by = &found[0].changes[0];
        assert!((by.value - 0.3).abs() < 4.0 * by.std && by.std < 0.1, "seed {seed}: {by:?}");
    }
}

#[test]
fn causes_that_show_the_same_are_equally_probable() {
    for seed in 0..10 {
        let mut robot = Robot { draws: Random::new(seed), scatters: vec![0.01, 0.01, 0.1, 0.1], alike: Some([0, 1]) };
        let found = robot.explained(&[0.5, 0.0, 0.0, 0.0]);
        let mut named = [found[0].joint, found[1].joint];
        named.sort_unstable();
        assert_eq!(named, [1, 2], "seed {seed}: {found:?}");
        assert!((found[0].probability - 0.5).abs() < 0.01, "seed {seed}: {found:?}");
    }
}

#[test]
fn a_change_of_two_places_is_not_explained_by_one() {
    for seed in 0..10 {
        let mut robot = Robot { draws: Random::new(seed), scatters: vec![0.02; 4], alike: None };
        let found = robot.explained(&[0.5, 0.5, 0.0, 0.0]);
        assert!(found[0].share < 0.75, "seed {seed}: {found:?}");
    }
}

#[test]
fn probabilities_are_kept() {
    // Changes about as large as their uncertainty: a probability of 0.8 is right in 8 of 10.
    let (mut sum, mut right) = (0.0, 0);
    let count = 300;
    for seed in 0..count {
        let mut robot = Robot { draws: Random::new(1000 + seed), scatters: vec![0.1; 6], alike: None };
        let found = robot.explained(&[0.0, 0.0, 0.22, 0.0, 0.0, 0.0]);
        sum += found[0].probability;
        right += usize::from(found[0].joint == 3);
    }
    let (said, was) = (sum / count as f64, right as f64 / count as f64);
    println!("said {said:.2}, was {was:.2}");
    assert!((said - was).abs() < 0.12, "said {said}, was {was}");
}

#[test]
fn too_few_days_have_no_explanation() {
    let mut robot = Robot { draws: Random::new(1), scatters: vec![0.1; 2], alike: None };
    let days: Vec<DayEvidence> = (0..2).map(|_| robot.day(&[0.0; 2])).collect();
    assert!(explanations(&robot.channels(), &days, &days, ASSUMPTIONS).is_empty());
    assert!(explanations(&robot.channels(), &[], &days, ASSUMPTIONS).is_empty());
}
