//! Combines an arm and the body in its hand in one regressor: the paper's equation (7).

use crate::model::{Arm, BaseParameter, Description, Inertial, Payload, StandardParameter, States};

/// Names of the ten parameters: `M MSX MSY MSZ XX YY ZZ XY XZ YZ`.
pub fn names() -> [String; 10] {
    Inertial::ALL.map(|p| p.name().to_string())
}

/// An arm whose base parameters are followed by the ten of a carried body (`ML MSXL ...`), in the
/// frame of [`Payload`]. A loaded log has `[W_b W_L]`, an unloaded one `[W_b 0]`.
pub struct Carrying<'a> {
    arm: &'a dyn Payload,
    loaded: bool,
    description: Description,
    /// Source of each entry of the pattern: the arm's own entries, then the body's.
    sources: Vec<usize>,
}

impl<'a> Carrying<'a> {
    /// The arm with the body, or (not `loaded`) with the same unknowns and an empty hand.
    pub fn new(arm: &'a dyn Payload, loaded: bool) -> Self {
        let own = arm.base_parameters().len();
        let at = arm.standard_parameters().len();
        let body = Inertial::ALL.into_iter().enumerate().map(|(k, which)| {
            let leader = StandardParameter::Payload(which);
            BaseParameter {
                leader,
                grouping: leader.to_string(),
                name: leader.to_string(),
                coefficients: vec![(at + k, 1.0)],
                unit: which.unit().into(),
            }
        });
        let body_entries = arm.payload_pattern().iter().map(|&(row, column)| (row, own + column));
        let mut entries: Vec<((usize, usize), usize)> =
            arm.base_pattern().iter().copied().chain(body_entries).enumerate().map(|(k, at)| (at, k)).collect();
        entries.sort_unstable();
        let (pattern, sources) = entries.into_iter().unzip();
        let mut description = Description { pattern, ..arm.description().clone() };
        description.base.extend(body);
        description.standard.extend(Inertial::ALL.map(StandardParameter::Payload));
        Self { description, sources, loaded, arm }
    }

    /// Index of the first of the body's ten columns.
    pub fn first(&self) -> usize {
        self.description.base.len() - 10
    }
}

impl Arm for Carrying<'_> {
    fn description(&self) -> &Description {
        &self.description
    }
    fn base_regressor(&self, states: &States, out: &mut [f64]) {
        let len = states.len;
        let own = self.arm.base_pattern().len() * len;
        let mut both = vec![0.0; own + self.arm.payload_pattern().len() * len];
        let (arm, body) = both.split_at_mut(own);
        self.arm.base_regressor(states, arm);
        if self.loaded {
            self.arm.payload_regressor(states, body);
        }
        for (to, &from) in out.chunks_exact_mut(len.max(1)).zip(&self.sources) {
            to.copy_from_slice(&both[from * len..(from + 1) * len]);
        }
    }
    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]) {
        let (arm, body) = standard.split_at(standard.len().min(self.arm.standard_parameters().len()));
        self.arm.inverse_dynamics(states, arm, out);
        if self.loaded {
            let mut regressor = vec![0.0; self.arm.payload_pattern().len() * states.len];
            self.arm.payload_regressor(states, &mut regressor);
            for (entry, &(row, column)) in regressor.chunks(states.len.max(1)).zip(self.arm.payload_pattern()) {
                let tau = &mut out[row * states.len..(row + 1) * states.len];
                tau.iter_mut().zip(entry).for_each(|(t, w)| *t += w * body.get(column).copied().unwrap_or(0.0));
            }
        }
    }
}
