//! Result of the families: for each joint the values it takes, for each branch which of them.
//! Branches share values (eight branches of a swivel arm have two angles of joint 4).

use super::super::runtime::Block;
use super::axis::Value;
use super::list::each;
use super::solution::{Branch, CAPACITY};
use super::subproblem::DOUBT;
use super::vector::Turn;

/// The values of one joint; of one that slides, `c` is the way, m.
#[derive(Clone, Copy)]
struct Column {
    c: [f64; CAPACITY],
    s: [f64; CAPACITY],
    len: usize,
}

/// Up to [`CAPACITY`] branches of `N` joints.
pub(super) struct Candidates<const N: usize> {
    columns: [Column; N],
    /// By joint and branch: which value.
    at: [[u8; CAPACITY]; N],
    pub branch: [Branch; CAPACITY],
    /// Bit `j`: joint `j` is free; [`IN_DOUBT`].
    pub free: [u32; CAPACITY],
    /// All of them together: what was just written would not yet be there to be read side by side.
    any: u32,
    pub len: usize,
    /// May one be missing?
    pub unsure: bool,
}

/// Bit of `free` that stands for [`super::subproblem::DOUBT`] among all joints.
pub(super) const IN_DOUBT: u32 = 1 << 31;

/// That bit, from a byte of free joints.
#[inline(always)]
pub(super) fn in_doubt(free: u8) -> u32 {
    u32::from(free & DOUBT) << 24
}

/// No bound check: there are as many places as the mask allows.
const MASK: usize = CAPACITY - 1;

impl<const N: usize> Candidates<N> {
    #[inline(always)]
    pub fn new() -> Self {
        Self {
            columns: [Column { c: [0.0; CAPACITY], s: [0.0; CAPACITY], len: 0 }; N],
            at: [[0; CAPACITY]; N],
            branch: [Branch::NONE; CAPACITY],
            free: [0; CAPACITY],
            any: 0,
            len: 0,
            unsure: false,
        }
    }

    /// A value of a joint, and how to name it.
    #[inline(always)]
    pub fn value(&mut self, joint: usize, slides: bool, v: Value) -> u8 {
        let Some(column) = self.columns.get_mut(joint) else { return 0 };
        let at = column.len & MASK;
        (column.c[at], column.s[at]) = if slides { (v.way, 0.0) } else { (v.turn.c, v.turn.s) };
        column.len = at + 1;
        at as u8
    }

    /// Another branch, every joint at its first value; what does not fit is left out.
    #[inline(always)]
    pub fn push(&mut self, branch: Branch, free: u32) -> Option<usize> {
        let place = self.len;
        if place >= CAPACITY {
            return None;
        }
        (self.branch[place], self.free[place]) = (branch, free);
        self.any |= free;
        self.len += 1;
        Some(place)
    }

    /// The value that a joint takes in a branch.
    #[inline(always)]
    pub fn set(&mut self, place: usize, joint: usize, at: u8) {
        if let Some(row) = self.at.get_mut(joint) {
            row[place & MASK] = at;
        }
    }

    /// Value of a joint in a branch.
    #[inline(always)]
    pub fn at(&self, place: usize, joint: usize) -> usize {
        self.at.get(joint).map_or(0, |row| usize::from(row[place & MASK])) & MASK
    }

    /// The branch, and its free joints.
    #[inline(always)]
    pub fn kind(&self, place: usize) -> (Branch, u32) {
        (self.branch[place & MASK], self.free[place & MASK])
    }

    /// Is some branch [`IN_DOUBT`]?
    #[inline(always)]
    pub fn in_doubt(&self) -> bool {
        self.any & IN_DOUBT != 0
    }

    /// More joints of a branch are free.
    pub fn loosen(&mut self, place: usize, bits: u32) {
        self.free[place & MASK] |= bits;
        self.any |= bits;
    }

    /// No branch is in doubt.
    pub fn be_sure(&mut self) {
        for free in &mut self.free {
            *free &= !IN_DOUBT;
        }
        self.any &= !IN_DOUBT;
    }

    /// A branch with values of its own.
    pub fn push_all(&mut self, values: &[Value; N], slides: impl Fn(usize) -> bool, branch: Branch, free: u32) -> bool {
        let Some(place) = self.push(branch, free) else { return false };
        for (j, v) in values.iter().enumerate() {
            let at = self.value(j, slides(j), *v);
            self.set(place, j, at);
        }
        true
    }

    /// All joints in a branch.
    pub fn values(&self, place: usize, slides: impl Fn(usize) -> bool) -> [Value; N] {
        each(Value::ZERO, |j| {
            let (at, column) = (self.at(place, j), &self.columns[j]);
            if slides(j) { Value::way(column.c[at]) } else { Value::turn(Turn { c: column.c[at], s: column.s[at] }) }
        })
    }

    /// One joint in as many branches from `first` on as a block holds, side by side.
    #[inline(always)]
    pub fn lanes(&self, joint: usize, first: usize) -> (Block, Block) {
        let (row, column) = (&self.at[joint], &self.columns[joint]);
        (Block::pick(&column.c, row, first), Block::pick(&column.s, row, first))
    }
}
