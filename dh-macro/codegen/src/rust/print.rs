//! Prints a tape as straight-line Rust in blocks with separate scopes.
//!
//! rustc's debug information recurses over the `let`s of one scope and overflows near three
//! thousand of them; a block costs nothing at run time. Each block returns only values that are
//! used later: `let [a, b] = { ...; [a, b] };`.

use core::fmt::Write;

use super::names::Names;
use crate::sym::{Kind, Operand, Tape};

/// Largest number of steps in a block.
const BLOCK: usize = 200;
/// Largest number of operations in one printed expression.
const EXPRESSION: usize = 8;

/// Text of the statements: `put` returns the text that stores output `o`, given its value's text.
pub(super) fn statements(tape: &Tape, names: &Names, outputs: &[usize], put: impl Fn(usize, &str) -> String) -> String {
    let inlined = inlined(tape);
    let mut text = String::new();
    let mut emitted = vec![false; outputs.len()];
    let mut last_use = vec![0usize; tape.code.len()];
    for (at, step) in tape.code.iter().enumerate() {
        for operand in [step.a, step.b] {
            if let Operand::Temp(t) = operand {
                last_use[t as usize] = at;
            }
        }
    }
    // A temporary printed inside another expression is read at that expression's position.
    for at in (0..tape.code.len()).rev() {
        if inlined[at] {
            let place = statement_of(at, &inlined, &last_use);
            for operand in [tape.code[at].a, tape.code[at].b] {
                if let Operand::Temp(t) = operand {
                    last_use[t as usize] = last_use[t as usize].max(place);
                }
            }
        }
    }
    for (start, end, title) in blocks(tape) {
        let mut body = String::new();
        for at in (start..end).filter(|&at| !inlined[at]) {
            let name = names.of(Operand::Temp(at as u32));
            let _ = writeln!(body, "        let {name} = {};", expression(tape, names, &inlined, at));
        }
        for (k, &o) in outputs.iter().enumerate() {
            let ready = match tape.outputs[o] {
                Operand::Temp(t) => (t as usize) < end,
                _ => true,
            };
            if ready && !emitted[k] {
                emitted[k] = true;
                let _ = writeln!(body, "        {}", put(o, &names.of(tape.outputs[o])));
            }
        }
        let handed: Vec<String> = (start..end)
            .filter(|&at| !inlined[at] && (last_use[at] >= end || needed_later(tape, outputs, &emitted, at)))
            .map(|at| names.of(Operand::Temp(at as u32)))
            .collect();
        if !title.is_empty() {
            let _ = writeln!(text, "    // {title}");
        }
        if end >= tape.code.len() && handed.is_empty() && blocks(tape).len() == 1 {
            text += &body.replace("\n        ", "\n    ").replacen("        ", "    ", 1);
            continue;
        }
        match handed.as_slice() {
            [] => {
                let _ = write!(text, "    {{\n{body}    }}\n");
            }
            [one] => {
                let _ = write!(text, "    let {one} = {{\n{body}        {one}\n    }};\n");
            }
            several => {
                let list = wrapped(several, 8);
                let _ = write!(text, "    let [{list}] = {{\n{body}        [{list}]\n    }};\n");
            }
        }
    }
    text
}

/// Whether this temporary is an output that is still to be stored.
fn needed_later(tape: &Tape, outputs: &[usize], emitted: &[bool], at: usize) -> bool {
    outputs.iter().zip(emitted).any(|(&o, done)| !done && tape.outputs[o] == Operand::Temp(at as u32))
}

/// Position of a step's text, following the expressions in which it is printed.
fn statement_of(at: usize, inlined: &[bool], last_use: &[usize]) -> usize {
    let mut at = at;
    while inlined[at] {
        at = last_use[at];
    }
    at
}

/// Ranges of at most [`BLOCK`] steps, split at headings where possible; neighbouring short sections
/// keep separate blocks.
fn blocks(tape: &Tape) -> Vec<(usize, usize, String)> {
    let mut blocks: Vec<(usize, usize, String)> = Vec::new();
    for (k, section) in tape.sections.iter().enumerate() {
        let end = tape.sections.get(k + 1).map_or(tape.code.len(), |s| s.start);
        let mut start = section.start;
        while start < end || (start == end && k == 0 && tape.code.is_empty()) {
            let stop = end.min(start + BLOCK);
            let title = if start == section.start { section.title.clone() } else { format!("{} (on)", section.title) };
            blocks.push((start, stop, title));
            if stop == start {
                break;
            }
            start = stop;
        }
    }
    if blocks.is_empty() {
        blocks.push((0, 0, String::new()));
    }
    blocks
}

/// Marks steps printed inside the only expression that reads them: unnamed, used once, in the same
/// block, not too long.
fn inlined(tape: &Tape) -> Vec<bool> {
    let n = tape.code.len();
    let mut uses = vec![0u32; n];
    let mut reader = vec![usize::MAX; n];
    for (at, step) in tape.code.iter().enumerate() {
        let unary = step.kind.is_unary();
        for operand in [Some(step.a), (!unary).then_some(step.b)].into_iter().flatten() {
            if let Operand::Temp(t) = operand {
                uses[t as usize] += 1;
                reader[t as usize] = at;
            }
        }
    }
    for output in &tape.outputs {
        if let Operand::Temp(t) = output {
            uses[*t as usize] += 2;
        }
    }
    let blocks = blocks(tape);
    let block_of = |at: usize| blocks.iter().position(|(start, end, _)| (*start..*end).contains(&at));
    let mut size = vec![1usize; n];
    let mut inlined = vec![false; n];
    for at in 0..n {
        let reads = [tape.code[at].a, tape.code[at].b];
        for (k, operand) in reads.iter().enumerate() {
            if let Operand::Temp(t) = operand
                && !(k == 1 && reads[0] == reads[1])
            {
                let t = *t as usize;
                let fits = size[at] + size[t] <= EXPRESSION;
                if uses[t] == 1 && tape.labels[t].is_none() && fits && block_of(t) == block_of(at) {
                    inlined[t] = true;
                    size[at] += size[t];
                }
            }
        }
    }
    inlined
}

/// Right-hand side of a step. Brackets preserve the order of the tape's additions and
/// multiplications.
fn expression(tape: &Tape, names: &Names, inlined: &[bool], at: usize) -> String {
    let operand = |operand: Operand, brackets: &dyn Fn(Kind) -> bool| match operand {
        Operand::Temp(t) if inlined[t as usize] => {
            let inner = expression(tape, names, inlined, t as usize);
            if brackets(tape.code[t as usize].kind) { format!("({inner})") } else { inner }
        }
        other => names.of(other),
    };
    let sum = |k: Kind| matches!(k, Kind::Add | Kind::Sub);
    // A method call has a higher precedence than any operator.
    let atom = |k: Kind| k == Kind::Sign || k.is_elementary();
    let step = &tape.code[at];
    match step.kind {
        Kind::Add => {
            format!("{} + {}", operand(step.a, &|k| k == Kind::Neg), operand(step.b, &|k| sum(k) || k == Kind::Neg))
        }
        Kind::Sub => {
            format!("{} - {}", operand(step.a, &|k| k == Kind::Neg), operand(step.b, &|k| sum(k) || k == Kind::Neg))
        }
        Kind::Mul => {
            format!("{} * {}", operand(step.a, &|k| k != Kind::Mul && !atom(k)), operand(step.b, &|k| !atom(k)))
        }
        Kind::Div => {
            format!("{} / {}", operand(step.a, &|k| k != Kind::Mul && !atom(k)), operand(step.b, &|k| !atom(k)))
        }
        Kind::Neg => format!("-{}", operand(step.a, &|k| !atom(k))),
        Kind::Sign => format!("{}.sign()", operand(step.a, &|_| true)),
        Kind::Call(f) => format!("{}.{}()", operand(step.a, &|_| true), f.name()),
        Kind::Least => format!("{}.min({})", operand(step.a, &|_| true), operand(step.b, &|_| false)),
        Kind::Most => format!("{}.max({})", operand(step.a, &|_| true), operand(step.b, &|_| false)),
    }
}

/// Comma-separated list, `per` items to a line.
pub(super) fn wrapped(items: &[String], per: usize) -> String {
    if items.len() <= per {
        return items.join(", ");
    }
    let lines: Vec<String> = items.chunks(per).map(|c| format!("        {},", c.join(", "))).collect();
    format!("\n{}\n    ", lines.join("\n"))
}
