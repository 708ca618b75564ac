//! Measures the deflection between a joint's motor and link, where the log has both angles.
//!
//! With `d = qm - q` and the transmitted torque `f`, a gear of stiffness `K` gives `d = f / K`. The
//! file's rotor and friction move with the motor. With the link's angle the file's torque therefore
//! lacks `IA d'' + FV d' + FC (sign(q' + d') - sign(q'))` (M. W. Spong, *Modeling and control of
//! elastic joint robots*, J. Dyn. Sys. Meas. Control 109, 1987).

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::evidence::short;
use super::result::Cause;
use crate::diagnose::fit::model::given_friction;
use crate::diagnose::hypotheses::Named;
use crate::diagnose::select::measure::share;
use crate::diagnose::select::refine_and_select::Selected;
use crate::diagnose::windows::torque_noise::autocorrelation_time;
use crate::diagnose::windows::windowed_data::WindowedData;

/// Least share of the deflection's variance that correlates with the torque for a spring.
const ELASTIC: f64 = 0.5;
/// Least compliance of a spring, in its standard deviations.
const SURE: f64 = 5.0;
/// Least share of the joint's squared error that it explains.
const GAIN: f64 = 0.08;

/// A spring identified from the deflection.
#[derive(Debug, Clone, PartialEq)]
struct Spring {
    /// Compliance, rad/(N m), and its standard deviation.
    compliance: [f64; 2],
    /// Share of the deflection's variance that correlates with the torque.
    share: f64,
}

impl Spring {
    /// Stiffness, N m/rad, and its standard deviation.
    fn stiffness(&self) -> [f64; 2] {
        let [compliance, std] = self.compliance;
        [1.0 / compliance, std / (compliance * compliance)]
    }
}

/// Linear regression of deflections (rad) on torques (N m) over the windows that are `live`.
fn spring(deflection: &[f64], torque: &[f64], live: &[bool]) -> Option<Spring> {
    let at = || (0..live.len()).filter(|&w| live[w]);
    let n = at().count() as f64;
    let mean = |x: &[f64]| at().map(|w| x[w]).sum::<f64>() / n.max(1.0);
    let (d0, f0) = (mean(deflection), mean(torque));
    let sum = |a: &dyn Fn(usize) -> f64, b: &dyn Fn(usize) -> f64| at().map(|w| a(w) * b(w)).sum::<f64>();
    let (d, f) = (|w: usize| deflection[w] - d0, |w: usize| torque[w] - f0);
    let (dd, df, ff) = (sum(&d, &d), sum(&d, &f), sum(&f, &f));
    if n < 20.0 || ff <= 0.0 || dd <= 0.0 {
        return None;
    }
    let slope = df / ff;
    let rest: Vec<f64> = (0..live.len()).map(|w| if live[w] { d(w) - slope * f(w) } else { 0.0 }).collect();
    let left: f64 = rest.iter().map(|r| r * r).sum();
    let std = (autocorrelation_time(&rest, live) * left / n / ff).sqrt();
    let share = 1.0 - left / dd;
    (slope > SURE * std && share > ELASTIC).then_some(Spring { compliance: [slope, std], share })
}

/// Angle of the motor minus that of the link over the windows, rad; `None` if not recorded.
fn measured(scene: &WindowedData<'_>, j: usize) -> Option<Vec<f64>> {
    let own = &scene.own[j];
    let there = own.iter().all(|o| o.motor.len() == o.q.len()) && own.iter().any(|o| !o.motor.is_empty());
    there.then(|| own.iter().flat_map(|o| scene.average_of(o, |k| o.motor[k] - o.q[k])).collect())
}

/// Causes for joints whose error a spring explains, with the remaining error of each joint.
pub(in crate::diagnose) fn deflections(model: &Selected<'_>, noise: &[f64]) -> Vec<Cause> {
    let (scene, residual) = (&model.tested.scene, &model.fitted.residual);
    let joint = |j: usize| {
        let load = scene.transmitted(j);
        let found = spring(&measured(scene, j)?, &load, &scene.live[j])?;
        let rate = scene.rate_of(&load);
        let second = scene.rate_of(&rate);
        let [_, velocity, _] = scene.motion_of(j);
        let [viscous, dry] = model.fitted.friction_levels(&given_friction(model.tested.plant)[j], j);
        let compliance = found.compliance[0];
        let lacks = |w: usize| {
            let (v, faster) = (velocity[w], compliance * rate[w]);
            let turned = (v + faster).signum() - v.signum();
            compliance * scene.rotors[j] * second[w] + viscous * faster + dry * turned
        };
        let squares = |left: &dyn Fn(usize) -> f64| {
            (0..scene.len).filter(|&w| scene.live[j][w]).map(|w| left(w).powi(2)).sum::<f64>()
        };
        let [before, after] = [squares(&|w| residual[j][w]), squares(&|w| residual[j][w] - lacks(w))];
        let left = after / before.max(f64::MIN_POSITIVE);
        (left < 1.0 - GAIN).then(|| cause(model, j, &found, left, noise))
    };
    (0..scene.dof()).filter_map(joint).collect()
}

/// A spring as a cause; `left` is the share of the joint's squared error on the fitted logs that
/// remains.
fn cause(model: &Selected<'_>, j: usize, found: &Spring, left: f64, noise: &[f64]) -> Cause {
    let before = model.after_fit.rms.clone();
    let mut after = before.clone();
    after[j] *= left.sqrt();
    let [stiffness, std] = found.stiffness();
    let spring = Named::new(effects::JointElasticity::KE, stiffness, Some(std));
    let spring = spring.of_joint(Some(j + 1));
    Cause {
        joints: vec![j + 1],
        probability: found.share.min(0.97),
        share: share(&before, &after, noise, &[j]),
        evidence: format!(
            "joint {}: motor and link differ by an angle of which {:.0} % goes with the torque ({} = {} +- {} N m/rad); rotor and friction move with the motor, which takes the error of the joint from {} to {} N m. The file's law is for an angle measured at the motor, so it is not written",
            j + 1,
            100.0 * found.share,
            spring.symbol,
            short(stiffness),
            short(std),
            short(before[j]),
            short(after[j])
        ),
        parameters: vec![spring],
        rms_before: before,
        rms_after: after,
        ..Cause::of_effect(EffectKind::JointElasticity)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_a_spring_and_noise_is_none() {
        let torque: Vec<f64> = (0..400).map(|k| 20.0 * (0.05 * f64::from(k)).sin()).collect();
        let live = vec![true; 400];
        let turned: Vec<f64> =
            torque.iter().enumerate().map(|(k, f)| 0.3 + f / 1500.0 + 1e-5 * ((k * 7 % 11) as f64 - 5.0)).collect();
        let found = spring(&turned, &torque, &live).unwrap();
        assert!((1.0 / found.compliance[0] / 1500.0 - 1.0).abs() < 0.01 && found.share > 0.99);
        let noise: Vec<f64> = (0..400).map(|k| 1e-5 * (f64::from(k * k % 13) - 6.0)).collect();
        assert_eq!(spring(&noise, &torque, &live), None);
        // A deflection against the torque is not a spring.
        let against: Vec<f64> = turned.iter().map(|d| -d).collect();
        assert_eq!(spring(&against, &torque, &live), None);
    }

    /// Compliance and stiffness of 300 records with different noise scatter by their stated
    /// deviations.
    #[test]
    fn a_spring_is_as_uncertain_as_it_says() {
        let mut random = crate::numerics::prng::Random::new(4);
        let torque: Vec<f64> = (0..400).map(|k| 20.0 * (0.05 * f64::from(k)).sin()).collect();
        let live = vec![true; 400];
        let (mut squares, mut stated) = ([0.0; 2], [0.0; 2]);
        for _ in 0..300 {
            let turned: Vec<f64> = torque.iter().map(|f| f / 1500.0 + random.uniform(-2e-3, 2e-3)).collect();
            let found = spring(&turned, &torque, &live).unwrap();
            for (k, truth) in [1.0 / 1500.0, 1500.0].into_iter().enumerate() {
                let [value, std] = [found.compliance, found.stiffness()][k];
                squares[k] += (value - truth).powi(2);
                stated[k] += std * std;
            }
        }
        for k in 0..2 {
            let ratio = f64::sqrt(squares[k] / stated[k]);
            assert!((ratio - 1.0).abs() < 0.15, "{k}: {ratio}");
        }
    }
}
