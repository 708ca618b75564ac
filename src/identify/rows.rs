//! The rows of the base regressor: each joint's columns, evaluated over a block of samples.

use crate::arm::{Arm, States, SummedSign};

/// Where each joint's entries stand in [`Arm::base_pattern`].
#[derive(Debug, Clone)]
pub(crate) struct Rows {
    /// Base parameters of each joint's row.
    pub(crate) columns: Vec<Vec<usize>>,
    /// First entry of each joint's row in the pattern, and the end.
    pub(crate) offsets: Vec<usize>,
    /// Position of each joint's Coulomb column, `FCj`, within its row.
    pub(crate) coulomb: Vec<Option<usize>>,
    /// Signs of sums of velocities.
    pub(crate) sums: Vec<SummedSign>,
}

impl Rows {
    pub(crate) fn new(arm: &dyn Arm) -> Self {
        let mut columns = vec![Vec::new(); arm.dof()];
        for &(row, column) in arm.base_pattern() {
            columns[row].push(column);
        }
        let mut offsets = vec![0];
        for row in &columns {
            offsets.push(offsets[offsets.len() - 1] + row.len());
        }
        let name = |c: usize| arm.base_parameters()[c].name.trim_end_matches('R').to_string();
        let coulomb =
            |(joint, row): (usize, &Vec<usize>)| row.iter().position(|&c| name(c) == format!("FC{}", joint + 1));
        let coulomb = columns.iter().enumerate().map(coulomb).collect();
        Self { columns, offsets, coulomb, sums: arm.summed_signs() }
    }

    /// The regressor's entries, `entries * len`. Where `sign` (joint-major, those of the sums behind) is given it takes the place of the
    /// velocity's sign in the Coulomb columns.
    pub(crate) fn evaluate(&self, arm: &dyn Arm, states: &States, sign: &[f64], out: &mut Vec<f64>) {
        let len = states.len;
        out.clear();
        out.resize(arm.base_pattern().len() * len, 0.0);
        arm.base_regressor(states, out);
        if sign.len() >= arm.dof() * len {
            for (joint, coulomb) in self.coulomb.iter().enumerate() {
                if let Some(column) = coulomb {
                    let entry = self.offsets[joint] + column;
                    out[entry * len..(entry + 1) * len].copy_from_slice(&sign[joint * len..(joint + 1) * len]);
                }
            }
        }
        for (row, summed) in self.sums.iter().enumerate().map(|(k, summed)| (arm.dof() + k, summed)) {
            let Some(sign) = sign.get(row * len..(row + 1) * len) else { break };
            for &(entry, factor) in &summed.entries {
                let column = &mut out[entry * len..(entry + 1) * len];
                column.iter_mut().zip(sign).for_each(|(w, s)| *w = factor * s);
            }
        }
    }
}
