//! Order in which a tape's steps are run. Steps that do not depend on each other may be exchanged
//! without changing any value.

use super::tape::{Instruction, Operand, Section, Tape};

/// Steps required by these outputs, each placed just before its first reader, so that few values
/// are live at any time.
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
            // The longest branch is pushed last, so that it is placed first.
            let mut below: Vec<usize> = reads(at).filter(|&t| !placed[t]).collect();
            below.sort_by_key(|&t| (depth[t], t));
            stack.extend(below.into_iter().map(|t| (t, false)));
        }
    }
    order
}

/// Number of live values that a section may add and still be placed early.
const FEW: isize = 8;

/// Reorders the sections of a tape. The next one is the first that is ready and adds at most
/// [`FEW`] live values, otherwise the one that adds the fewest. Everything computed from one motion
/// thus precedes the next motion. Steps keep their order within a section; a change of sign moves
/// to the section of its operand.
pub(super) fn few_waiting(tape: &Tape) -> Tape {
    let count = tape.sections.len();
    let mut steps: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut section_of = vec![0usize; tape.code.len()];
    for (s, section) in tape.sections.iter().enumerate() {
        for at in section.start..tape.sections.get(s + 1).map_or(tape.code.len(), |next| next.start) {
            let step = &tape.code[at];
            section_of[at] = match step.a {
                Operand::Temp(t) if step.kind.is_unary() => section_of[t as usize],
                _ => s,
            };
            steps[section_of[at]].push(at);
        }
    }
    // Per section: values that it reads from others, without duplicates. Per step: number of other
    // sections that have yet to read it.
    let mut reads: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut waiting = vec![0usize; tape.code.len()];
    for (s, reads) in reads.iter_mut().enumerate() {
        let operands = steps[s].iter().flat_map(|&at| [tape.code[at].a, tape.code[at].b]);
        reads.extend(operands.filter_map(|operand| match operand {
            Operand::Temp(t) if section_of[t as usize] != s => Some(t as usize),
            _ => None,
        }));
        reads.sort_unstable();
        reads.dedup();
        reads.iter().for_each(|&t| waiting[t] += 1);
    }
    let mut placed = vec![false; count];
    let mut place = vec![0u32; tape.code.len()];
    let mut out = Tape { formulas: tape.formulas.clone(), ..Tape::default() };
    for _ in 0..count {
        let more = |s: usize| {
            let begun = steps[s].iter().filter(|&&t| waiting[t] > 0).count() as isize;
            begun - reads[s].iter().filter(|&&t| waiting[t] == 1).count() as isize
        };
        let ready = (0..count).filter(|&s| !placed[s] && reads[s].iter().all(|&t| placed[section_of[t]]));
        let Some(s) = ready.min_by_key(|&s| ((more(s) - FEW).max(0), s)) else { break };
        placed[s] = true;
        reads[s].iter().for_each(|&t| waiting[t] -= 1);
        if steps[s].is_empty() && !tape.code.is_empty() {
            continue;
        }
        out.sections.push(Section { start: out.code.len(), title: tape.sections[s].title.clone() });
        for &at in &steps[s] {
            place[at] = out.code.len() as u32;
            let Instruction { kind, a, b } = tape.code[at];
            out.code.push(Instruction { kind, a: moved(a, &place), b: moved(b, &place) });
            out.labels.push(tape.labels[at].clone());
        }
    }
    out.outputs = tape.outputs.iter().map(|&operand| moved(operand, &place)).collect();
    out
}

/// Operand after its step was moved.
fn moved(operand: Operand, place: &[u32]) -> Operand {
    match operand {
        Operand::Temp(t) => Operand::Temp(place[t as usize]),
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Graph, Kind, Operand, Tape};

    /// Two motions of ten values each, then a column of each: the first column precedes the second
    /// motion, and every step reads the same values as before.
    #[test]
    fn a_column_stands_right_after_its_motion() {
        let g = Graph::new();
        g.section("motion 1");
        let first: Vec<_> = (0..10).map(|i| g.input(i) * g.input(i + 1)).collect();
        g.section("motion 2");
        let second: Vec<_> = first.iter().enumerate().map(|(i, &x)| x * g.input(20 + i)).collect();
        g.section("column 1");
        let one = first.iter().copied().reduce(|a, b| a + b).unwrap();
        g.section("column 2");
        let two = second.iter().copied().reduce(|a, b| a - b).unwrap();
        let tape = Tape::new(&g, &[one, two, -two]);
        let sorted = tape.with_few_waiting();
        let titles: Vec<&str> = sorted.sections.iter().map(|s| s.title.as_str()).collect();
        assert_eq!(titles, ["motion 1", "column 1", "motion 2", "column 2"]);
        let values = |tape: &Tape| -> Vec<u64> {
            let mut of: Vec<f64> = Vec::new();
            let read = |of: &[f64], operand: Operand| match operand {
                Operand::Constant(x) => x,
                Operand::Input(i) => 1.0 + 0.37 * f64::from(i),
                Operand::Temp(t) => of[t as usize],
            };
            for step in &tape.code {
                let (a, b) = (read(&of, step.a), read(&of, step.b));
                of.push(match step.kind {
                    Kind::Add => a + b,
                    Kind::Sub => a - b,
                    Kind::Mul => a * b,
                    Kind::Neg => -a,
                    other => panic!("{other:?}"),
                });
            }
            tape.outputs.iter().map(|&o| read(&of, o).to_bits()).collect()
        };
        assert_eq!(values(&sorted), values(&tape));
        assert_eq!(sorted.operations(), tape.operations());
    }
}
