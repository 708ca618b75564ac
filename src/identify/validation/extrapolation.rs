//! Predicted torque uncertainty on unrecorded motions.

use crate::identify::result::{Identification, Standing};
use crate::model::{Arm, LinkExtents, States};

/// Uncertainty of the torques over the arm's whole range.
#[derive(Debug, Clone, PartialEq)]
pub struct Extrapolation {
    /// Per joint: root mean square over random states of the standard deviation of the predicted
    /// torque, N m. Infinite if an undetermined parameter acts on the joint.
    pub torque_std: Vec<f64>,
    /// This uncertainty divided by the standard deviation of the joint's residual in the fit.
    pub ratio: Vec<f64>,
}

impl Extrapolation {
    /// Whether the fit is useless on unrecorded motions: the torque of every joint is uncertain
    /// there by more than the measured torque, root mean square.
    pub fn says_nothing(&self, found: &Identification) -> bool {
        let torque = &found.fit.torque_rms;
        self.torque_std
            .iter()
            .zip(torque)
            .all(|(std, torque)| std.partial_cmp(torque) != Some(std::cmp::Ordering::Less))
    }

    /// Joints (from 1) whose torque on unrecorded motions is uncertain by more than the fit's own
    /// residual, worst first.
    pub fn doubtful(&self) -> Vec<usize> {
        let mut joints: Vec<usize> = (0..self.ratio.len()).filter(|&j| self.ratio[j] > 1.0).collect();
        joints.sort_by(|&a, &b| self.ratio[b].total_cmp(&self.ratio[a]));
        joints.into_iter().map(|j| j + 1).collect()
    }
}

/// Number of states that are evaluated.
const STATES: usize = 256;

/// Torque uncertainty `sqrt(mean_s w_s C w_s')` per joint, with `C` the covariance of the estimates
/// and `w_s` the joint's row of the base regressor. States are spread evenly over the positions'
/// ranges, with velocities up to half of the largest speeds, which change sign within a quarter of
/// a second.
pub fn extrapolation(arm: &dyn Arm, reach: &dyn LinkExtents, found: &Identification) -> Extrapolation {
    let (n, b) = (arm.dof(), arm.base_parameters().len());
    let ranges = reach.ranges();
    let mut states = States { len: STATES, ..States::default() };
    // Kronecker's sequence with roots of the generalised golden ratio: even in all dimensions, and
    // identical on every machine.
    let phi = {
        let mut x = 2.0_f64;
        (0..60).for_each(|_| x = (1.0 + x).powf(1.0 / (3 * n + 1) as f64));
        x
    };
    let even = |k: usize, s: usize| (0.5 + phi.powi(-(k as i32 + 1)) * (s + 1) as f64).fract();
    for (j, [low, high, _]) in ranges.iter().enumerate() {
        states.q.extend((0..STATES).map(|s| low + (high - low) * even(j, s)));
    }
    for (which, factor) in [(1, 0.5), (2, 2.0)] {
        let values = ranges
            .iter()
            .enumerate()
            .flat_map(|(j, [_, _, speed])| (0..STATES).map(move |s| (which, j, s, factor * speed)));
        let values: Vec<f64> = values.map(|(w, j, s, size)| size * (2.0 * even(w * n + j, s) - 1.0)).collect();
        if which == 1 { states.dq = values } else { states.ddq = values }
    }
    let mut entries = vec![0.0; arm.base_pattern().len() * STATES];
    arm.base_regressor(&states, &mut entries);

    let open = |c: usize| found.parameters[c].standing == Standing::NotIdentifiable;
    let covariance = |i: usize, k: usize| {
        let r = found.correlation[i * b + k];
        if r.is_finite() { r * found.parameters[i].std * found.parameters[k].std } else { 0.0 }
    };
    let mut result = Extrapolation { torque_std: Vec::new(), ratio: Vec::new() };
    for joint in 0..n {
        let row: Vec<(usize, usize)> = arm
            .base_pattern()
            .iter()
            .enumerate()
            .filter(|(_, (row, _))| *row == joint)
            .map(|(k, (_, column))| (k, *column))
            .collect();
        let column = |k: usize| &entries[k * STATES..(k + 1) * STATES];
        let mut variance = 0.0;
        for (p, &(k, i)) in row.iter().enumerate() {
            if open(i) && column(k).iter().any(|w| w.abs() > 1e-12) {
                variance = f64::INFINITY;
                break;
            }
            for &(l, m) in &row[..=p] {
                let inner: f64 = column(k).iter().zip(column(l)).map(|(a, c)| a * c).sum();
                variance += if l == k { 1.0 } else { 2.0 } * covariance(i, m) * inner / STATES as f64;
            }
        }
        let std = variance.max(0.0).sqrt();
        result.torque_std.push(std);
        // A joint whose torque was not recorded has no residual for comparison.
        let sigma = found.noise.sigma.get(joint).copied().unwrap_or(f64::NAN);
        result.ratio.push(if found.fit.rms[joint].is_finite() { std / sigma } else { f64::INFINITY });
    }
    result
}
