//! Names of inputs, temporaries and constants in the printed code.

use std::collections::{BTreeMap, BTreeSet};

use super::numbers::Numbers;
use super::words::LOCAL;
use crate::arm::chain::{Group, Inputs};
use crate::sym::{Operand, Tape};

/// Names of all operands of a tape.
pub(super) struct Names {
    inputs: Inputs,
    parameters: Vec<String>,
    temps: Vec<String>,
    /// Variable and origin of each constant, by the bits of the number.
    constants: BTreeMap<u64, (String, String)>,
    seeds: bool,
}

impl Names {
    /// Names the operands. A constant of the file keeps its name, and a number derived from named
    /// ones is written as their formula.
    pub(super) fn new(tape: &Tape, inputs: Inputs, parameters: &[String], numbers: &Numbers) -> Self {
        let mut constants = BTreeMap::new();
        let mut add = |operand: &Operand| {
            if let Operand::Constant(value) = operand
                && !constants.contains_key(&value.to_bits())
            {
                let text = tape.formulas.get(&value.to_bits()).and_then(|formula| numbers.text(formula));
                let local = text.as_deref().and_then(|text| numbers.local(text));
                let name = local.unwrap_or_else(|| format!("k{}", constants.len()));
                let name = (name, text.unwrap_or_else(|| format!("{value:?}")));
                constants.insert(value.to_bits(), name);
            }
        };
        tape.code.iter().flat_map(|s| [&s.a, &s.b]).for_each(&mut add);
        // Structural zeros are never stored one by one.
        tape.outputs.iter().filter(|o| **o != Operand::Constant(0.0)).for_each(&mut add);
        let mut taken: BTreeSet<String> = parameters.iter().cloned().collect();
        let mut temps = Vec::with_capacity(tape.code.len());
        for (i, label) in tape.labels.iter().enumerate() {
            temps.push(match label {
                Some(label) if !label.starts_with(LOCAL) && taken.insert(label.clone()) => label.clone(),
                _ => format!("t{i}"),
            });
        }
        Self { inputs, parameters: parameters.to_vec(), temps, constants, seeds: false }
    }

    /// Variant for an adjoint, with seeds after the parameters.
    pub(super) fn with_seeds(mut self) -> Self {
        self.seeds = true;
        self
    }

    /// Names of the constants, with the text of their values.
    pub(super) fn constants(&self) -> impl Iterator<Item = (&str, &str)> {
        let mut all: Vec<(&str, &str)> = self.constants.values().map(|(n, v)| (n.as_str(), v.as_str())).collect();
        all.sort_by(|a, b| (a.0.len(), a.0).cmp(&(b.0.len(), b.0)));
        all.into_iter()
    }

    /// Name of an operand.
    pub(super) fn of(&self, operand: Operand) -> String {
        match operand {
            Operand::Constant(value) => {
                self.constants.get(&value.to_bits()).map(|(name, _)| name.clone()).unwrap_or_default()
            }
            Operand::Temp(i) => self.temps[i as usize].clone(),
            Operand::Input(i) => {
                let (group, at) = self.inputs.locate(i as usize);
                self.input(group, at)
            }
        }
    }

    /// Number of inputs that are parameters of the arm.
    pub(super) fn parameters(&self) -> usize {
        self.parameters.len()
    }

    /// Name of an input, with joints counted from 1. The parameters are followed by bristles,
    /// warmth and clock, or by seeds.
    pub(super) fn input(&self, group: Group, at: usize) -> String {
        let letter = match group {
            Group::Position => "q",
            Group::Sine => "s",
            Group::Cosine => "c",
            Group::Velocity => "dq",
            Group::Acceleration => "ddq",
            Group::Torque => "tau",
            Group::Parameter => {
                let beyond = || {
                    let (dof, after) = (self.inputs.dof.max(1), at - self.parameters.len());
                    if self.seeds {
                        return format!("w{after}");
                    }
                    let clock = after.checked_sub(2 * dof);
                    match (after < dof, clock) {
                        (_, Some(0)) => "time".to_string(),
                        (_, Some(joint)) => format!("temp{joint}"),
                        (true, None) => format!("bristle{}", after + 1),
                        (false, None) => format!("warmth{}", after % dof + 1),
                    }
                };
                return self.parameters.get(at).cloned().unwrap_or_else(beyond);
            }
        };
        format!("{letter}{}", at + 1)
    }
}
