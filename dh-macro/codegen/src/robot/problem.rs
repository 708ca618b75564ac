//! Mistakes in a robot file: location, description and advice.

use core::fmt;

/// A mistake in a robot or tool file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// Name of the file, if known: [`Problems::in_file`] sets that of the robot file; that of a
    /// tool file is set from the start.
    pub file: Option<String>,
    /// Key path, `joints[3].alpha`; rows count from 1 as in the DH table. Empty: the whole file.
    pub path: String,
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
    /// Description of the mistake, with figures.
    pub what: String,
    /// Advice on how to fix it; may be empty.
    pub mend: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        place(f, self.file.as_deref(), self.line, self.column, &self.path)?;
        f.write_str(&self.what)?;
        if self.mend.is_empty() { Ok(()) } else { write!(f, "; help: {}", self.mend) }
    }
}

/// A note to the author of the file about an assumption or finding of the reader, which is no
/// mistake.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// Name of the file, if known; see [`Problem::file`].
    pub file: Option<String>,
    /// Key path; see [`Problem::path`].
    pub path: String,
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
    /// Description of the action or finding.
    pub what: String,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        place(f, self.file.as_deref(), self.line, self.column, &self.path)?;
        f.write_str(&self.what)
    }
}

fn place(f: &mut fmt::Formatter<'_>, file: Option<&str>, line: usize, column: usize, path: &str) -> fmt::Result {
    if let Some(file) = file {
        write!(f, "{file}:")?;
    }
    write!(f, "{line}:{column}: ")?;
    if path.is_empty() { Ok(()) } else { write!(f, "{path}: ") }
}

/// All mistakes of a file, in line order; never empty when returned as an error.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problems(pub Vec<Problem>);

impl Problems {
    /// Sets the robot file's name in every problem without a file.
    pub fn in_file(mut self, name: &str) -> Self {
        for problem in &mut self.0 {
            problem.file.get_or_insert_with(|| name.to_string());
        }
        self
    }

    /// All mistakes.
    pub fn list(&self) -> &[Problem] {
        &self.0
    }
}

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, problem) in self.0.iter().enumerate() {
            if k > 0 {
                f.write_str("\n")?;
            }
            problem.fmt(f)?;
        }
        Ok(())
    }
}

impl core::error::Error for Problems {}

/// Candidate that `word` most likely means: at most two typing errors, and at most a third of its
/// letters.
pub fn closest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    if length > 40 {
        return None;
    }
    candidates
        .into_iter()
        .map(|candidate| (slips(&word.to_lowercase(), &candidate.to_lowercase()), candidate))
        .filter(|&(slips, candidate)| slips <= 2 && 3 * slips <= length.max(candidate.chars().count()))
        .min_by_key(|&(slips, _)| slips)
        .map(|(_, candidate)| candidate)
}

/// Edit distance: letters to insert, delete, replace or swap with their neighbour to turn `a` into
/// `b`.
fn slips(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut table = vec![vec![0usize; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            table[i][j] = match (i, j) {
                (0, _) => j,
                (_, 0) => i,
                _ => {
                    let same = usize::from(a[i - 1] != b[j - 1]);
                    let mut least = (table[i - 1][j] + 1).min(table[i][j - 1] + 1).min(table[i - 1][j - 1] + same);
                    if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                        least = least.min(table[i - 2][j - 2] + 1);
                    }
                    least
                }
            };
        }
    }
    table[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_keyboard_finds_its_word() {
        assert_eq!(closest("aplha", ["d", "alpha", "theta"]), Some("alpha"));
        assert_eq!(closest("posittion", ["position", "torque"]), Some("position"));
        assert_eq!(closest("m", ["I", "M", "MS"]), Some("M"));
        assert_eq!(closest("colour", ["d", "alpha", "theta"]), None);
        assert_eq!(closest("q", ["L1", "L2"]), None);
    }
}
