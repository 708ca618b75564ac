//! Plain solution with non-negative rotor inertias and friction levels.

use crate::identify::Factors;
use crate::identify::Identification;
use crate::identify::IdentifyError;
use crate::identify::IdentifySettings;
use crate::identify::Known;
use crate::identify::solve;
use crate::model::Arm;

/// Base parameters of a fit with possible drives.
#[derive(Debug, Clone, PartialEq)]
pub struct Nonnegative {
    /// Base parameters, in the arm's order.
    pub base: Vec<f64>,
    /// Names of the parameters held at their bound, in parameter order.
    pub held: Vec<String>,
}

/// Fixes rotor inertias and friction levels that are below zero, or below their floor, at that
/// bound. Fits the others again, until none is below. This is the active-set method of non-negative
/// least squares (Lawson and Hanson 1974), without release.
///
/// `floors`: standard parameters with a least value above zero. Friction that differs by `FCA`
/// between directions has a level of `FC - |FCA|` in one of them.
pub fn nonnegative_drives(
    arm: &dyn Arm,
    fit: &[Factors],
    found: &Identification,
    settings: &IdentifySettings,
    floors: &[(usize, f64)],
) -> Result<Nonnegative, IdentifyError> {
    let floor = |c: usize| -> f64 {
        let has = |i: &usize| arm.base_parameters()[c].coefficients.iter().any(|(k, _)| k == i);
        floors.iter().filter(|(i, _)| has(i)).map(|(_, least)| *least).sum()
    };
    let mut known: Vec<Option<f64>> = vec![None; found.parameters.len()];
    let mut base = found.values();
    loop {
        let below = |c: &usize| found.parameters[*c].leader.is_level() && base[*c] < floor(*c);
        let negative: Vec<usize> = (0..base.len()).filter(below).collect();
        if negative.is_empty() {
            let held = found.parameters.iter().zip(&known).filter(|(_, k)| k.is_some());
            return Ok(Nonnegative { base, held: held.map(|(p, _)| p.name.clone()).collect() });
        }
        negative.iter().for_each(|&c| known[c] = Some(floor(c)));
        let rest = Known::new(arm, &known);
        let factors: Vec<Factors> = fit.iter().map(|log| rest.factors(log)).collect();
        let settings = IdentifySettings { essential: None, ..settings.clone() };
        base = rest.whole(&solve(&rest, &factors, &[], &settings)?.values());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::planar::{Planar, motion};
    use crate::identify::{AccumulatorSettings, QrAccumulator};

    #[test]
    fn a_negative_friction_level_is_held_at_zero_and_the_rest_fitted_again() {
        let arm = Planar::new();
        let mut m = motion(&arm, 10.0, 100.0, 0.3);
        let len = m.states.len;
        // Friction of joint 2 with the opposite sign.
        let level = 5.0;
        (len..2 * len).for_each(|k| m.tau[k] -= level * (m.states.dq[k].signum() + m.states.dq[k]));
        let mut stack = QrAccumulator::new("log", &arm, AccumulatorSettings::default());
        stack.absorb(&m);
        let fit = [stack.finish()];
        let settings = IdentifySettings::default();
        let found = solve(&arm, &fit, &[], &settings).unwrap();
        let lowest = found.parameters.iter().filter(|p| p.leader.is_level()).map(|p| p.value).fold(0.0, f64::min);
        assert!(lowest < -1.0, "{lowest}");
        let bounded = nonnegative_drives(&arm, &fit, &found, &settings, &[]).unwrap();
        assert!(!bounded.held.is_empty());
        // A difference between directions that exceeds the level of joint 1.
        let fc1 = arm.standard_names().iter().position(|name| name == "FC1").unwrap();
        let floored = nonnegative_drives(&arm, &fit, &found, &settings, &[(fc1, 2.0)]).unwrap();
        let at = floored.held.iter().position(|name| name == "FC1");
        assert!(at.is_some() && (floored.base[9] - 2.0).abs() < 1e-12, "{floored:?}");
        for (p, value) in found.parameters.iter().zip(&bounded.base) {
            assert!(!p.leader.is_level() || *value >= 0.0, "{}: {value}", p.name);
            assert!(!bounded.held.contains(&p.name) || *value == 0.0, "{}: {value}", p.name);
        }
    }
}
