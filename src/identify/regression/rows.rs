//! Evaluates the rows of the base regressor: each joint's columns over a block of samples.

use crate::model::{Arm, DriveTerm, States, SummedSign};

/// Index of each joint's entries in [`Arm::base_pattern`].
#[derive(Debug, Clone)]
pub(crate) struct Rows {
    /// Base parameters in each joint's row.
    pub(crate) columns: Vec<Vec<usize>>,
    /// Index of the first entry of each joint's row in the pattern, and the end.
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
        let coulomb =
            |row: &Vec<usize>| row.iter().position(|&c| arm.base_parameters()[c].is_drive_term(DriveTerm::FC));
        let coulomb = columns.iter().map(coulomb).collect();
        Self { columns, offsets, coulomb, sums: arm.summed_signs() }
    }

    /// Evaluates the regressor's entries, `entries * len`. If `sign` (joint-major, followed by the
    /// sums) is given, it replaces the sign of the velocity in the Coulomb columns.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::interpreted::Interpreted;

    #[test]
    fn a_fixed_row_does_not_move_the_friction_of_the_joints_behind_it() {
        let drive = "drive: { rotor_inertia: 0, friction: { viscous_friction: 0, coulomb_friction: 0 } }";
        let text = format!(
            "name: elbow\nconvention: modified\njoints:\n  - {{ type: revolute, {drive} }}\n  - {{ type: fixed, alpha: 90deg, d: 0.2 }}\n  - \
             {{ type: revolute, d: 0.3, {drive} }}\n"
        );
        let robot = dh_codegen::robot::Robot::from_yaml(&text, &dh_codegen::robot::no_files).unwrap().robot;
        let arm = Interpreted::new(&robot, &[]);
        let rows = Rows::new(&arm);
        for (joint, name) in ["FC1", "FC3"].iter().enumerate() {
            let at = rows.coulomb[joint].map(|k| rows.columns[joint][k]);
            assert_eq!(at.map(|c| arm.base_parameters()[c].name.as_str()), Some(*name));
        }
        // A given sign replaces that of the velocity.
        let states = States { len: 1, q: vec![0.1, 0.2], dq: vec![1.0, 1.0], ddq: vec![0.0; 2] };
        let (mut plain, mut given) = (Vec::new(), Vec::new());
        rows.evaluate(&arm, &states, &[], &mut plain);
        rows.evaluate(&arm, &states, &[0.25, -0.5], &mut given);
        let changed: Vec<f64> = plain.iter().zip(&given).filter(|(a, b)| a != b).map(|(_, b)| *b).collect();
        assert_eq!(changed, [0.25, -0.5]);
    }
}
