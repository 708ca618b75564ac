//! Selects the frame in which each column is computed: this changes the number of operations, not
//! the result.

use std::collections::BTreeSet;

/// How the wrench of one column is projected to torques.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct ColumnPlan {
    /// Frame (row) to which the wrench is carried inward, and in which its moment is projected on
    /// the axes of the preceding joints.
    pub moment: usize,
    /// Frame to whose axes the force is rotated further inward before it is projected.
    pub force: usize,
    /// For joints up to this row the moment is first taken about this frame's origin: axes that
    /// meet there are then independent of the force.
    pub about: usize,
}

impl ColumnPlan {
    /// Plan with everything in one frame.
    pub fn at(row: usize) -> Self {
        Self { moment: row, force: row, about: row }
    }
}

/// Choices for one row.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct RowPlan {
    /// Whether to compute about the origin before `TransZ(r)`, and to combine columns afterwards.
    pub shifted: bool,
    /// One plan for each of the ten parameters.
    pub columns: [ColumnPlan; 10],
}

/// Choices for all rows.
pub type Plan = Vec<RowPlan>;

/// Number of frames inward that are searched.
const REACH: usize = 2;
/// Rounds of moves for the base parameters, whose plan serves most functions.
pub const ROUNDS: usize = 3;

/// Most plans that are tried, times the rows to the third power, with which the cost of one grows.
/// Chains of up to [`WHOLE`] rows are searched to the end; for longer ones the first moves find
/// most of the gain.
const WORK: usize = 1_600_000;
/// Number of rows up to which a search ends by itself.
const WHOLE: usize = 8;

/// Plan with every link in its own frame.
pub fn plain(rows: usize) -> Plan {
    (0..rows).map(|row| RowPlan { shifted: false, columns: [ColumnPlan::at(row); 10] }).collect()
}

/// Descent from `start`: one move at a time, kept if it reduces `cost`, until none does. A move
/// sets the frames of one kind of column for a run of neighbouring rows (links with a common wrist
/// gain only together).
///
/// Performs at most `rounds` rounds of all moves; the first finds nearly everything.
pub fn search(start: Plan, rounds: usize, can_shift: impl Fn(usize) -> bool, cost: impl Fn(&Plan) -> usize) -> Plan {
    let rows = start.len();
    let mut best = start;
    let mut best_cost = cost(&best);
    // A plan that was tried once was no better than the best one then, so it is no better than the
    // present best.
    let mut tried = BTreeSet::from([best.clone()]);
    let mut try_plan = |best: &mut Plan, trial: Plan| {
        if tried.len() * rows * rows * rows.max(WHOLE) < WORK && tried.insert(trial.clone()) {
            let trial_cost = cost(&trial);
            if trial_cost < best_cost {
                (*best, best_cost) = (trial, trial_cost);
                return true;
            }
        }
        false
    };
    for _round in 0..rounds {
        let mut improved = false;
        for last in (0..rows).rev() {
            for first in 0..=last {
                for inner in 0..=first {
                    let mut trial = best.clone();
                    for row in first..=last {
                        for column in &mut trial[row].columns[..4] {
                            column.force = inner.min(column.moment);
                        }
                    }
                    improved |= try_plan(&mut best, trial);
                    for moment in inner..=first {
                        let mut trial = best.clone();
                        for row in first..=last {
                            trial[row].columns[..4].fill(ColumnPlan { moment, force: moment, about: inner });
                        }
                        improved |= try_plan(&mut best, trial);
                    }
                }
                for back in 0..=REACH.min(first) {
                    for kind in [0..4, 4..10, 0..10] {
                        let mut trial = best.clone();
                        for row in first..=last {
                            for column in &mut trial[row].columns[kind.clone()] {
                                column.moment = row - back;
                                column.force = column.force.min(column.moment);
                                column.about = column.about.min(column.moment);
                            }
                        }
                        improved |= try_plan(&mut best, trial);
                    }
                }
            }
            if can_shift(last) {
                let mut trial = best.clone();
                trial[last].shifted = !trial[last].shifted;
                improved |= try_plan(&mut best, trial.clone());
                trial[last].columns = [ColumnPlan::at(last); 10];
                improved |= try_plan(&mut best, trial);
            }
        }
        if !improved {
            break;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_chains_are_searched_for_a_bounded_time() {
        let calls = std::cell::Cell::new(0);
        let cost = |_: &Plan| {
            calls.set(calls.get() + 1);
            1_000_000 - calls.get()
        };
        assert_eq!(search(plain(30), ROUNDS, |_| true, cost).len(), 30);
        assert!(calls.get() <= 1 + WORK / 27_000, "{}", calls.get());
    }
}
