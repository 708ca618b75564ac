//! Removes the torque of known effects of the robot file (beyond links and plain friction) from the
//! measured torque, so that the rest can be fitted.
//!
//! With the file's prediction `p` (sensor readings, delay `d`, gain `g`, offset `o`) and its rigid
//! part `r` (links, rotors, plain friction), the fit uses `tau' = r + (tau - p)(t + d) / g`. If the
//! file predicts a log exactly, exactly its own rigid torque remains.

use crate::data::signal::{Filter, Motion, low_pass};
use crate::model::{Arm, States, TorqueModel};

/// Effects of a robot file, and the arm without them.
pub struct KnownEffects<'a> {
    file: &'a dyn TorqueModel,
    arm: &'a dyn Arm,
    /// Standard parameters of the file, in the arm's order.
    standard: Vec<f64>,
    /// The same without Coulomb levels: their torque is smooth and passes the low-pass unchanged.
    smooth: Vec<f64>,
    filter: Option<Filter>,
}

impl<'a> KnownEffects<'a> {
    /// `standard`: parameters of the file, one per standard parameter of `arm`. `filter`: low-pass
    /// of the recorded torque. `None` if the numbers do not match the arm.
    pub fn new(file: &'a dyn TorqueModel, arm: &'a dyn Arm, standard: &[f64], filter: Option<Filter>) -> Option<Self> {
        let parameters = arm.standard_parameters();
        if parameters.len() != standard.len() || file.dof() != arm.dof() {
            return None;
        }
        let smooth = parameters.iter().zip(standard).map(|(p, v)| if p.is_coulomb() { 0.0 } else { *v }).collect();
        Some(Self { file, arm, standard: standard.to_vec(), smooth, filter })
    }

    /// Motion with the torques that the arm would have without the effects. Filters the whole
    /// motion, so margins around its core are required.
    pub fn taken_out(&self, motion: &Motion) -> Motion {
        let (n, len) = (self.arm.dof(), motion.states.len);
        let time: Vec<f64> = (0..len).map(|s| motion.time(s)).collect();
        let (mut predicted, mut smooth, mut rigid) = (vec![0.0; n * len], vec![0.0; n * len], vec![0.0; n * len]);
        let begun = motion.segment_start;
        self.file.torques_since(begun, &time, &motion.states, &motion.temperature, &mut predicted);
        self.rigid(&motion.states, &self.smooth, &mut smooth);
        self.rigid(&motion.states, &self.standard, &mut rigid);
        let (delays, sensors) = (self.file.delays(), self.file.sensors());
        let mut out = motion.clone();
        for joint in 0..n {
            let own = joint * len..(joint + 1) * len;
            let [gain, offset] = sensors[joint];
            let late = delays[joint] / motion.period;
            let smooth = &smooth[own.clone()];
            let base: Vec<f64> = moved(smooth, -late).iter().map(|tau| gain * tau + offset).collect();
            let beside = self.low_passed(&less(&predicted[own.clone()], &base), motion.period);
            let missed: Vec<f64> =
                motion.tau[own.clone()].iter().zip(&base).zip(&beside).map(|((tau, b), e)| tau - b - e).collect();
            let friction = self.low_passed(&less(&rigid[own.clone()], smooth), motion.period);
            let missed = moved(&missed, late);
            for (s, tau) in out.tau[own].iter_mut().enumerate() {
                *tau = smooth[s] + friction[s] + missed[s] / gain;
            }
        }
        out
    }

    fn rigid(&self, states: &States, standard: &[f64], out: &mut [f64]) {
        self.arm.inverse_dynamics(states, standard, out);
    }

    /// Applies the low-pass of the recorded torque, which rounds steps of friction.
    fn low_passed(&self, x: &[f64], period: f64) -> Vec<f64> {
        let mut y = x.to_vec();
        let steady = x.windows(2).all(|w| w[0] == w[1]);
        if let Some(filter) = self.filter.filter(|_| !steady)
            && let Ok(sos) = low_pass(filter.order, filter.cutoff, period.recip())
        {
            let pad = (1.0 / (period * filter.cutoff)).ceil() as usize;
            sos.forward_backward(&mut y, pad.max(sos.scipy_padding()));
        }
        y
    }
}

fn less(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Shifts a signal by `by` samples with linear interpolation; the end values are held.
fn moved(x: &[f64], by: f64) -> Vec<f64> {
    if by == 0.0 || x.is_empty() {
        return x.to_vec();
    }
    let last = (x.len() - 1) as f64;
    let at = |place: f64| {
        let place = place.clamp(0.0, last);
        let (whole, part) = (place.floor() as usize, place.fract());
        x[whole] + part * (x[(whole + 1).min(x.len() - 1)] - x[whole])
    };
    (0..x.len()).map(|k| at(k as f64 + by)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::planar::{Planar, STANDARD, motion};
    use crate::identify::{AccumulatorSettings, IdentifySettings, QrAccumulator, solve};

    /// A planar arm with springs in its joints, direction-dependent friction, and a torque sensor
    /// on joint 2 with delay, gain and offset.
    struct Sprung {
        arm: Planar,
        standard: Vec<f64>,
    }

    const LATE: f64 = 0.01;

    impl TorqueModel for Sprung {
        fn dof(&self) -> usize {
            2
        }
        fn torques(&self, states: &States, out: &mut [f64]) {
            self.arm.inverse_dynamics(states, &self.standard, out);
            for (k, tau) in out.iter_mut().enumerate() {
                *tau += 3.0 * states.q[k] + 0.2 * states.dq[k].abs().min(1.0);
                if k >= states.len {
                    *tau = 1.1 * *tau + 0.4;
                }
            }
        }
        fn torques_along(&self, time: &[f64], states: &States, _: &[f64], out: &mut [f64]) {
            self.torques(states, out);
            let len = states.len;
            let late = moved(&out[len..], -LATE / (time[1] - time[0]));
            out[len..].copy_from_slice(&late);
        }
        fn delays(&self) -> Vec<f64> {
            vec![0.0, LATE]
        }
        fn sensors(&self) -> Vec<[f64; 2]> {
            vec![[1.0, 0.0], [1.1, 0.4]]
        }
    }

    fn fitted(arm: &Planar, motion: &Motion) -> crate::identify::Identification {
        let mut stack = QrAccumulator::new("log", arm, AccumulatorSettings::default());
        stack.absorb(motion);
        solve(arm, &[stack.finish()], &[], &IdentifySettings::default()).unwrap()
    }

    #[test]
    fn links_and_friction_are_fitted_beside_effects_that_are_known() {
        let arm = Planar::new();
        let truth = Sprung { arm: Planar::new(), standard: STANDARD.to_vec() };
        let mut m = motion(&arm, 10.0, 500.0, 0.2);
        let time: Vec<f64> = (0..m.states.len).map(|s| m.time(s)).collect();
        truth.torques_along(&time, &m.states, &[], &mut m.tau);
        // Excludes the ends, where values are held.
        m.core = 50..m.states.len - 50;
        // A file with correct effects whose links and friction are a fifth too heavy.
        let standard: Vec<f64> = STANDARD.iter().map(|v| 1.2 * v).collect();
        let file = Sprung { arm: Planar::new(), standard: standard.clone() };
        let known = KnownEffects::new(&file, &arm, &standard, None).unwrap();
        let found = fitted(&arm, &known.taken_out(&m));
        for (p, truth) in found.parameters.iter().zip(arm.beta()) {
            assert!((p.value - truth).abs() < 0.02 * truth.abs() + 2e-3, "{}: {} against {truth}", p.name, p.value);
        }
        let without = fitted(&arm, &m);
        assert!(without.fit.rms[1] > 20.0 * found.fit.rms[1], "{:?} {:?}", without.fit.rms, found.fit.rms);
        // A correct file leaves no residual, and without effects nothing changes.
        let right = KnownEffects::new(&truth, &arm, &STANDARD, None).unwrap().taken_out(&m);
        let rigid = motion(&arm, 10.0, 500.0, 0.2);
        for s in m.core.clone() {
            assert!((right.tau[s] - rigid.tau[s]).abs() < 1e-9);
        }
        assert!(KnownEffects::new(&truth, &arm, &STANDARD[1..], None).is_none());
    }
}
