//! The columns that a motion has to determine: selected columns of the base regressor, a payload in
//! the tool frame, a caller's own columns.

use crate::model::{Differentiable, Gradient, Inertial, States};

use super::extra::Extra;

/// A selected entry of the regressor: its row, its column, and the position of its samples.
#[derive(Debug, Clone, Copy)]
pub(super) struct Entry {
    pub(super) row: usize,
    pub(super) column: usize,
    pub(super) place: usize,
}

/// A selection of columns.
pub struct Columns<'a> {
    arm: &'a dyn Differentiable,
    extra: Option<&'a dyn Extra>,
    /// Number of entries evaluated: of the base regressor, of the payload, of the extra columns.
    parts: [usize; 3],
    entries: Vec<Entry>,
    names: Vec<String>,
    /// Speed over which the sign in a Coulomb column changes smoothly, per joint; empty: a step.
    turn: Vec<f64>,
}

impl<'a> Columns<'a> {
    /// Selects the columns of the base parameters at these indices, then the ten of a payload if
    /// requested, then the caller's.
    pub fn new(arm: &'a dyn Differentiable, base: &[usize], payload: bool, extra: Option<&'a dyn Extra>) -> Self {
        let mut names: Vec<String> = base.iter().map(|&b| arm.base_parameters()[b].name.clone()).collect();
        let mut entries = Vec::new();
        let pattern = arm.base_pattern();
        for (place, &(row, column)) in pattern.iter().enumerate() {
            if let Some(column) = base.iter().position(|&b| b == column) {
                entries.push(Entry { row, column, place });
            }
        }
        let mut parts = [pattern.len(), 0, 0];
        if payload {
            let (first, place) = (names.len(), parts[0]);
            let pattern = arm.payload_pattern();
            entries.extend(pattern.iter().enumerate().map(|(k, &(row, column))| Entry {
                row,
                column: first + column,
                place: place + k,
            }));
            parts[1] = pattern.len();
            names.extend(Inertial::ALL.map(|which| format!("{} of the tool", which.name())));
        }
        if let Some(extra) = extra {
            let (first, place) = (names.len(), parts[0] + parts[1]);
            entries.extend(extra.pattern().iter().enumerate().map(|(k, &(row, column))| Entry {
                row,
                column: first + column,
                place: place + k,
            }));
            parts[2] = extra.pattern().len();
            names.extend((0..extra.columns()).map(|k| format!("extra {}", k + 1)));
        }
        entries.sort_by_key(|e| (e.row, e.column));
        Self { arm, extra, parts, entries, names, turn: Vec::new() }
    }

    /// The same with the sign in Coulomb columns replaced by `tanh(v / turn)`: it is
    /// differentiable, so that the time of a reversal affects the criterion.
    pub(super) fn smooth(mut self, turn: Vec<f64>) -> Self {
        self.turn = turn;
        self
    }

    /// Names of the columns.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Number of columns.
    pub fn count(&self) -> usize {
        self.names.len()
    }

    pub(super) fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Number of values that [`Columns::evaluate`] writes per sample.
    pub(super) fn values(&self) -> usize {
        self.parts.iter().sum()
    }

    pub(super) fn evaluate(&self, states: &States, out: &mut [f64]) {
        let len = states.len;
        let (base, rest) = out.split_at_mut(self.parts[0] * len);
        let (payload, extra) = rest.split_at_mut(self.parts[1] * len);
        self.arm.base_regressor(states, base);
        if !self.turn.is_empty() {
            for &(entry, joint) in self.arm.coulomb_entries() {
                let speeds = &states.dq[joint * len..(joint + 1) * len];
                let column = &mut base[entry * len..(entry + 1) * len];
                column.iter_mut().zip(speeds).for_each(|(c, v)| *c = (v / self.turn[joint]).tanh());
            }
        }
        if self.parts[1] > 0 {
            self.arm.payload_regressor(states, payload);
        }
        if let Some(columns) = self.extra {
            columns.evaluate(states, extra);
        }
    }

    pub(super) fn vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient) {
        let len = states.len;
        let (base, rest) = seeds.split_at(self.parts[0] * len);
        let (payload, extra) = rest.split_at(self.parts[1] * len);
        if self.entries.iter().any(|e| e.place < self.parts[0]) {
            self.arm.base_regressor_vjp(states, base, to);
        }
        if !self.turn.is_empty() {
            for &(entry, joint) in self.arm.coulomb_entries() {
                for s in 0..len {
                    let tanh = (states.dq[joint * len + s] / self.turn[joint]).tanh();
                    to.dq[joint * len + s] += base[entry * len + s] * (1.0 - tanh * tanh) / self.turn[joint];
                }
            }
        }
        if self.parts[1] > 0 {
            self.arm.payload_regressor_vjp(states, payload, to);
        }
        if let Some(columns) = self.extra {
            columns.vjp(states, extra, to);
        }
    }
}
