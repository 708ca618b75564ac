//! Choice among the nested models: the file unchanged, all parameters refitted, or the extended
//! model; and the causes that stay in it.
//!
//! The criterion is the error on stretches of the fitted logs that are left out in turn. Each is an
//! eighth of the data in one piece, so that it contains other motion than the rest. Errors of two
//! models are compared stretch by stretch. The simpler one stays unless the other is better by more
//! than the standard error of the difference (one-standard-error rule, Breiman et al. 1984, 3.4.3).

/// Least gain for which the file's links are given up.
const LEAST: f64 = 0.05;

/// Number of causes beside the file's links above which errors of links are likelier: one robot has
/// few faults.
const MANY: f64 = 6.0;

/// Errors on stretches that were left out.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// Mean squares per stretch and joint, (N m)^2.
    squares: Vec<Vec<f64>>,
    /// Number of windows per stretch and joint.
    counts: Vec<Vec<f64>>,
}

/// Paired comparison of the errors of two models.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paired {
    /// Difference of squares divided by their sum, mean over joints: from -1 to 1.
    pub gain: f64,
    /// Standard error of the gain, from its spread over stretches.
    pub error: f64,
    /// Whether the RMS error over all joints and stretches, in N m, is smaller too, so that many
    /// weak joints do not outvote a heavy one.
    pub whole: bool,
}

impl Paired {
    /// Whether the gain exceeds so many standard errors.
    pub fn outweighs(&self, errors: f64) -> bool {
        self.gain > errors * self.error
    }

    /// Whether the gain exceeds its standard error.
    pub fn sure(&self) -> bool {
        self.outweighs(1.0)
    }

    /// Whether the gain of a refit justifies giving up the file's links with `causes` causes beside
    /// them. It must be a twentieth, and one and a half standard errors, with a smaller error as a
    /// whole. A refit has many unknowns, which fit something in autocorrelated errors. Causes have
    /// a cost, too: beside more than [`MANY`] the refit may even be slightly worse, joints counted
    /// alike.
    pub fn worth_refit(&self, causes: usize) -> bool {
        let few = (1.0 - causes as f64 / MANY).max(-1.0);
        self.whole && self.gain > few * LEAST.max(1.5 * self.error)
    }
}

impl LeftOut {
    /// From sums of squares and numbers of windows, per stretch and joint.
    pub fn new(sums: &[Vec<f64>], counts: &[Vec<f64>]) -> Self {
        let mean = |(s, n): (&f64, &f64)| if *n > 0.0 { s / n } else { 0.0 };
        let squares = sums.iter().zip(counts).map(|(s, n)| s.iter().zip(n).map(mean).collect()).collect();
        Self { squares, counts: counts.to_vec() }
    }

    /// Gain of this model over `other`. Errors below `floor` (N m, per joint) do not count.
    pub fn less(&self, other: &Self, floor: &[f64]) -> Paired {
        let (stretches, joints) = (self.squares.len(), floor.len());
        let weight = |s: usize, j: usize| self.counts[s][j].min(other.counts[s][j]);
        // Compare within each stretch, so that one with a large error does not outvote the others.
        let gains: Vec<f64> = (0..stretches)
            .map(|s| {
                let of = |j: usize| {
                    let [own, other] = [self, other].map(|m| m.squares[s][j]);
                    (weight(s, j) > 0.0)
                        .then(|| (other - own) / (own + other + 2.0 * floor[j].powi(2)).max(f64::MIN_POSITIVE))
                };
                let live: Vec<f64> = (0..joints).filter_map(of).collect();
                live.iter().sum::<f64>() / (live.len().max(1) * stretches) as f64
            })
            .collect();
        let n = stretches.max(1) as f64;
        let gain: f64 = gains.iter().sum();
        let variance = gains.iter().map(|g| (g - gain / n).powi(2)).sum::<f64>() / (n - 1.0).max(1.0);
        Paired { gain, error: (n * variance).sqrt(), whole: self.rms() < other.rms() }
    }

    /// The errors of some joints alone.
    pub fn of(&self, joints: &[usize]) -> Self {
        let pick = |rows: &[Vec<f64>]| rows.iter().map(|row| joints.iter().map(|&j| row[j]).collect()).collect();
        Self { squares: pick(&self.squares), counts: pick(&self.counts) }
    }

    /// Whether less than a share of the squared error of `other` remains on a joint, and at most
    /// half of it in every stretch.
    pub fn nearly_all(&self, other: &Self, joint: usize, share: f64) -> bool {
        let (mut sums, mut every) = ([0.0; 2], true);
        for (s, counts) in self.counts.iter().enumerate() {
            let [a, b] = [other, self].map(|x| x.squares[s][joint] * counts[joint]);
            every &= b <= 0.5 * a;
            sums = [sums[0] + a, sums[1] + b];
        }
        every && sums[1] < share * sums[0]
    }

    /// Root mean square error of a joint on its worst stretch, N m.
    pub fn worst(&self, joint: usize) -> f64 {
        self.squares.iter().map(|s| s[joint]).fold(0.0, f64::max).sqrt()
    }

    /// Root mean square over all stretches and joints, N m.
    pub fn rms(&self) -> f64 {
        let joints = self.squares.first().map_or(0, Vec::len);
        ((0..joints).map(|j| self.mean_square(j)).sum::<f64>() / joints.max(1) as f64).sqrt()
    }

    /// Root mean square of a joint over all stretches, N m.
    pub fn joint_rms(&self, joint: usize) -> f64 {
        self.mean_square(joint).sqrt()
    }

    /// The joint with the largest relative difference between its error and `other`'s. Errors below
    /// `floor` (N m, per joint) do not count.
    pub fn most_changed(&self, other: &Self, floor: &[f64]) -> usize {
        let change = |j: &usize| {
            let [a, b] = [self, other].map(|m| m.mean_square(*j));
            (a - b).abs() / (a + b + 2.0 * floor[*j].powi(2)).max(f64::MIN_POSITIVE)
        };
        (0..floor.len()).max_by(|a, b| change(a).total_cmp(&change(b))).unwrap_or(0)
    }

    fn mean_square(&self, joint: usize) -> f64 {
        let sum: f64 = self.squares.iter().zip(&self.counts).map(|(s, n)| s[joint] * n[joint]).sum();
        let count: f64 = self.counts.iter().map(|n| n[joint]).sum();
        if count > 0.0 { sum / count } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    fn noisy(random: &mut Random, size: f64) -> LeftOut {
        let sums: Vec<Vec<f64>> =
            (0..8).map(|_| (0..2).map(|_| size * random.uniform(80.0, 120.0)).collect()).collect();
        LeftOut::new(&sums, &vec![vec![100.0; 2]; 8])
    }

    /// A refit needs a smaller gain beside several causes, and none beside many.
    #[test]
    fn the_files_links_are_given_up_for_one_and_a_half_errors() {
        let refit = |gain, error, whole| Paired { gain, error, whole }.worth_refit(0);
        assert!(refit(0.1, 0.06, true) && !refit(0.1, 0.08, true));
        assert!(!refit(0.04, 0.001, true) && !refit(0.1, 0.06, false));
        let small = Paired { gain: 0.04, error: 0.05, whole: true };
        assert!([0, 1, 2].into_iter().all(|causes| !small.worth_refit(causes)));
        assert!([4, 6, 12].into_iter().all(|causes| small.worth_refit(causes)));
        let worse = Paired { gain: -0.01, ..small };
        assert!(!worse.worth_refit(6) && worse.worth_refit(12) && !Paired { gain: -0.1, ..small }.worth_refit(12));
        assert!(!Paired { whole: false, ..small }.worth_refit(12));
    }

    /// A gain common to all stretches is sure; its standard error is the spread over stretches.
    #[test]
    fn an_error_is_how_stretches_differ() {
        let model = |squares: [f64; 4]| LeftOut::new(&squares.map(|s| vec![100.0 * s]), &[(); 4].map(|()| vec![100.0]));
        let alike = model([1.0; 4]).less(&model([2.0; 4]), &[0.0]);
        assert!((alike.gain - 1.0 / 3.0).abs() < 1e-12 && alike.error < 1e-12 && alike.whole, "{alike:?}");
        let uneven = model([1.0; 4]).less(&model([1.0, 3.0, 1.0, 3.0]), &[0.0]);
        // Gains of 0 and 2 of 4 in turn: mean a quarter, deviation 1 / sqrt(12) a stretch.
        assert!((uneven.gain - 0.25).abs() < 1e-12, "{uneven:?}");
        assert!((uneven.error - 1.0 / 48.0_f64.sqrt()).abs() < 1e-12, "{uneven:?}");
    }

    #[test]
    fn a_better_model_is_surely_better_and_the_same_is_not() {
        let mut random = Random::new(3);
        let (one, worse) = (noisy(&mut random, 1.0), noisy(&mut random, 2.0));
        let paired = one.less(&worse, &[0.0; 2]);
        assert!(paired.sure() && (paired.gain - 1.0 / 3.0).abs() < 0.05, "{paired:?}");
        assert!(!worse.less(&one, &[0.0; 2]).sure());
        assert!(!one.less(&one, &[0.0; 2]).sure());
        assert!(paired.worth_refit(0) && one.nearly_all(&noisy(&mut random, 20.0), 1, 0.1));
        assert!(!one.nearly_all(&worse, 1, 0.1));
        // Errors far below the floor make no difference.
        assert!(one.less(&worse, &[100.0; 2]).gain < 1e-3);
        assert!((one.rms() - 1.0).abs() < 0.1);
    }

    #[test]
    fn one_large_stretch_does_not_outvote_the_others() {
        let model = |others: f64, large: f64| {
            let sums: Vec<Vec<f64>> = (0..8).map(|s| vec![if s == 0 { large } else { others }]).collect();
            LeftOut::new(&sums, &vec![vec![1.0]; 8])
        };
        // Half the error in seven stretches, and no less in one that errs a hundred times as much.
        let paired = model(0.5, 100.0).less(&model(1.0, 100.0), &[0.0]);
        assert!(paired.sure() && (paired.gain - 7.0 / 24.0).abs() < 1e-12, "{paired:?}");
    }

    #[test]
    fn weak_joints_do_not_outvote_a_heavy_one() {
        let model = |light: f64, heavy: f64| {
            let sums = vec![vec![light, light, light, heavy]; 8];
            LeftOut::new(&sums, &vec![vec![1.0; 4]; 8])
        };
        // Three joints err half as much, a hundred times as heavy a one somewhat more.
        let paired = model(0.25, 120.0).less(&model(1.0, 100.0), &[0.0; 4]);
        assert!(paired.sure() && paired.gain > 0.3 && !paired.worth_refit(0), "{paired:?}");
        assert_eq!(model(1.0, 10.0).most_changed(&model(1.0, 100.0), &[0.0; 4]), 3);
        // A joint whose error is far below its floor has not changed.
        assert_eq!(model(1.0, 10.0).most_changed(&model(1.1, 100.0), &[0.0, 0.1, 0.1, 1e3]), 0);
        assert!((model(4.0, 9.0).joint_rms(0) - 2.0).abs() < 1e-12);
        // Of the light joints alone, the first model is better by a third.
        let light = model(0.25, 120.0).of(&[0, 1]).less(&model(0.5, 100.0).of(&[0, 1]), &[0.0; 2]);
        assert!((light.gain - 1.0 / 3.0).abs() < 1e-12 && light.whole, "{light:?}");
    }
}
