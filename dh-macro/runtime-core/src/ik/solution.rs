//! Results of a solver.

use super::list::List;
// [six]
use super::regional::Regional;
// [/six]

/// Identifies the posture of a solution. Signs are those of the square roots: they do not change
/// along a path that meets no singularity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Branch {
    /// `1` or `-1`; 0: the arm has no such choice.
    pub shoulder: i8,
    /// `1` or `-1`; 0: no such choice.
    pub elbow: i8,
    /// `1` or `-1`; 0: no such choice.
    pub wrist: i8,
    /// From 1: which root of a quartic (or which start of the numerical solver).
    pub root: u8,
    /// Found by iteration, not in closed form.
    pub numerical: bool,
}

fn sign(bit: u8) -> i8 {
    if bit & 1 == 0 { 1 } else { -1 }
}

impl Branch {
    pub(super) const NONE: Self = Self { shoulder: 0, elbow: 0, wrist: 0, root: 0, numerical: false };

    // [six]
    pub(super) fn of_wrist(regional: &Regional, place: u8, wrist: u8, reversed: bool) -> Self {
        let (first, second, wrist) = (sign(place), sign(place >> 1), sign(wrist));
        let mut branch = Self { wrist, ..Self::NONE };
        match *regional {
            Regional::Meet { mirrored: false, .. } => (branch.elbow, branch.shoulder) = (first, second),
            Regional::Meet { mirrored: true, .. } | Regional::Parallel { mirrored: true } => {
                (branch.shoulder, branch.elbow) = (first, second);
            }
            Regional::Parallel { mirrored: false } => (branch.elbow, branch.shoulder) = (first, second),
            Regional::General { .. } | Regional::TurnSlideTurn => branch.root = place + 1,
            Regional::TurnSlides { .. } | Regional::SlideTurnSlide => branch.shoulder = first,
            Regional::Slides => {}
        }
        if reversed {
            (branch.shoulder, branch.wrist) = (branch.wrist, branch.shoulder);
        }
        branch
    }

    pub(super) fn of_three_parallel(shoulder: u8, elbow: u8, wrist: u8, reversed: bool) -> Self {
        let elbow = sign(elbow);
        if shoulder >= 4 {
            return Self { elbow, root: shoulder - 3, ..Self::NONE };
        }
        let (shoulder, wrist) = (sign(shoulder), sign(wrist));
        let (shoulder, wrist) = if reversed { (wrist, shoulder) } else { (shoulder, wrist) };
        Self { shoulder, elbow, wrist, ..Self::NONE }
    }
    // [/six]
}

impl core::fmt::Display for Branch {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut space = "";
        if self.numerical {
            f.write_str("numerical")?;
            space = " ";
        }
        for (name, sign) in [("shoulder", self.shoulder), ("elbow", self.elbow), ("wrist", self.wrist)] {
            if sign != 0 {
                write!(f, "{space}{name}{}", if sign > 0 { '+' } else { '-' })?;
                space = " ";
            }
        }
        if self.root != 0 {
            write!(f, "{space}root{}", self.root)?;
            space = " ";
        }
        if space.is_empty() { f.write_str("only") } else { Ok(()) }
    }
}

/// One posture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution<const N: usize> {
    /// Positions, rad or m. Whole turns are chosen so that the limits hold, if they can, else
    /// within half a turn of zero (or of the posture that was named as near).
    pub q: [f64; N],
    /// The posture.
    pub branch: Branch,
    /// Distance of its last frame's origin from the pose's, m.
    pub position_error: f64,
    /// Angle between its last frame and the pose, rad.
    pub rotation_error: f64,
    /// Does it respect the limits (to 1e-9)?
    pub within_limits: bool,
    /// Distance to the nearest limit, rad or m, negative beyond it; infinite where there is none.
    pub margin: f64,
    /// Bit `j`: joint `j` (from 0) can move together with others without changing the pose: a
    /// singularity. The solution is one member of that family.
    pub free: u32,
}

impl<const N: usize> Solution<N> {
    pub(super) const NONE: Self = Self {
        q: [0.0; N],
        branch: Branch::NONE,
        position_error: 0.0,
        rotation_error: 0.0,
        within_limits: false,
        margin: 0.0,
        free: 0,
    };
}

/// Outcome for a pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Postures are returned: all, unless [`Solutions::lost`] or [`Solutions::uncertain`] says that
    /// one may be missing.
    Ok,
    /// No posture was found: see [`Solutions::distance`]. Where [`Solutions::uncertain`] is true
    /// that is no proof that there is none.
    Unreachable,
    /// Some solution is a member of a family: see [`Solution::free`].
    Singular,
}

/// At most so many solutions are kept.
pub const CAPACITY: usize = 16;

/// The postures of one pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solutions<const N: usize> {
    /// In the order of their branches.
    pub list: List<Solution<N>, CAPACITY>,
    /// Outcome for the pose.
    pub status: Status,
    /// Of an unreachable pose: how far off the nearest posture that was found is, m and rad. Zero
    /// otherwise.
    pub distance: [f64; 2],
    /// How many branches are missing at least. For an arm that is only nearly of its family: how
    /// many fewer were found than the nominal arm has (the real arm may have fewer). One more is
    /// counted where their number is odd. Of a numerical search: one where six joints have an odd
    /// number of postures.
    pub lost: u32,
    /// Whether postures may be missing that `lost` does not count. Of a numerical search: always.
    /// Of an arm that is only nearly of its family: where some posture lies beside a singularity,
    /// since the real arm may have other branches there than the nominal one.
    pub uncertain: bool,
    /// The redundancy that was used: swivel angle or the locked joint's position; zero for other
    /// arms.
    pub redundancy: f64,
    /// Was the second reference plane used, because the first is singular here?
    pub second_plane: bool,
}

impl<const N: usize> Solutions<N> {
    /// The solutions.
    pub fn as_slice(&self) -> &[Solution<N>] {
        self.list.as_slice()
    }

    /// The solution nearest to a posture: the largest joint difference is the smallest.
    pub fn nearest(&self, q: &[f64; N]) -> Option<&Solution<N>> {
        let far = |s: &Solution<N>| s.q.iter().zip(q).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
        self.list.iter().reduce(|a, b| if far(b) < far(a) { b } else { a })
    }

    /// Those that respect the limits.
    pub fn within_limits(&self) -> impl Iterator<Item = &Solution<N>> {
        self.list.iter().filter(|s| s.within_limits)
    }

    /// The solution that stays farthest from its limits.
    pub fn safest(&self) -> Option<&Solution<N>> {
        self.list.iter().reduce(|a, b| if b.margin > a.margin { b } else { a })
    }
}

impl<const N: usize> IntoIterator for Solutions<N> {
    type Item = Solution<N>;
    type IntoIter = <List<Solution<N>, CAPACITY> as IntoIterator>::IntoIter;
    fn into_iter(self) -> Self::IntoIter {
        self.list.into_iter()
    }
}

impl<'a, const N: usize> IntoIterator for &'a Solutions<N> {
    type Item = &'a Solution<N>;
    type IntoIter = core::slice::Iter<'a, Solution<N>>;
    fn into_iter(self) -> Self::IntoIter {
        self.as_slice().iter()
    }
}

/// Why a pose was not looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PoseError {
    /// Not a finite number: row and column of the pose, from 0; row 3: the redundancy or the near
    /// posture.
    NotFinite(usize, usize),
    /// The rotation is none: the largest entry of `R' R - 1`.
    NotARotation(f64),
    /// The columns are orthogonal and of length one, but turn the wrong way round: their
    /// determinant is -1.
    Reflection,
}

impl core::fmt::Display for PoseError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::NotFinite(3, _) => write!(f, "the swivel angle or the near posture is not a finite number"),
            Self::NotFinite(row, column) => {
                write!(f, "entry r{}{} of the pose is not a finite number", row + 1, column + 1)
            }
            Self::NotARotation(defect) => {
                write!(f, "the first three columns are not a rotation: R'R differs from the identity by {defect:.1e}")
            }
            Self::Reflection => write!(f, "the first three columns are a reflection: their determinant is -1"),
        }
    }
}

impl core::error::Error for PoseError {}
