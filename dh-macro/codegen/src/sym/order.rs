//! The order in which a tape's steps are run. Steps that do not read each other may change places: no value depends on it.

use super::tape::{Operand, Tape};

/// The steps that these outputs need, each of them just before the first one that reads it: few values wait at any time.
pub(super) fn just_in_time(tape: &Tape, wanted: &[usize]) -> Vec<usize> {
    let reads = |at: usize| {
        let step = &tape.code[at];
        [step.a, step.b].into_iter().filter_map(|operand| match operand {
            Operand::Temp(t) => Some(t as usize),
            _ => None,
        })
    };
    let mut depth = vec![0usize; tape.code.len()];
    for at in 0..tape.code.len() {
        depth[at] = reads(at).map(|t| depth[t] + 1).max().unwrap_or(0);
    }
    let temp = |&output: &usize| match tape.outputs[output] {
        Operand::Temp(t) => Some(t as usize),
        _ => None,
    };
    let mut roots: Vec<usize> = wanted.iter().filter_map(temp).collect();
    roots.sort_unstable();
    let mut placed = vec![false; tape.code.len()];
    let mut order = Vec::with_capacity(tape.code.len());
    let mut stack: Vec<(usize, bool)> = Vec::new();
    for root in roots {
        stack.push((root, false));
        while let Some((at, ready)) = stack.pop() {
            if placed[at] {
                continue;
            }
            if ready {
                placed[at] = true;
                order.push(at);
                continue;
            }
            stack.push((at, true));
            // The longer of two ways first: it comes off the stack first.
            let mut below: Vec<usize> = reads(at).filter(|&t| !placed[t]).collect();
            below.sort_by_key(|&t| (depth[t], t));
            stack.extend(below.into_iter().map(|t| (t, false)));
        }
    }
    order
}
