//! Factors of one recording as bytes: written by one machine, merged by another.
//!
//! All numbers are little-endian.
//!
//! | bytes | holds |
//! |---|---|
//! | 8 | `DNVFACTR` |
//! | 2, 2, 4 | version (1), number of joints, number of base parameters |
//! | 32 | SHA-256 of the robot file: the meaning of the columns |
//! | 8 | seconds of motion |
//!
//! Then for each joint:
//!
//! | bytes | holds |
//! |---|---|
//! | 4 | number `n` of base parameters that its torque depends on |
//! | 4 n | their indices |
//! | 8, 8 | samples (integer), independent samples |
//! | 16, 16 | least and largest torque, least and largest position |
//! | 4 (n + 1)(n + 2) | upper triangle of `R`, column by column; the torque is the last column |
//!
//! The batches, of which [`solve`](super::solve) finds how correlated the residual is, are left
//! out: they would be sixty times as large. Standard deviations then count the independent samples
//! that the band of the torque has room for.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

use super::regression::accumulator::{Factors, JointFactor};
use super::regression::batches::Batches;
use super::regression::r_factor::RFactor;

const MAGIC: [u8; 8] = *b"DNVFACTR";
const VERSION: u16 = 1;
/// Sums of so many samples over any number of recordings stay in range.
const MOST_SAMPLES: u64 = 1 << 40;

/// Why factors can't be read or merged.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FactorError {
    /// No factor at all.
    #[error("no factor: the first bytes are not DNVFACTR")]
    Magic,
    /// A later program wrote it.
    #[error("a factor of version {0}, where version 1 is known; use a newer denavit")]
    Version(u16),
    /// Bytes are missing.
    #[error("the factor ends after {found} bytes, within {what}")]
    Short {
        /// Length.
        found: usize,
        /// What is cut.
        what: &'static str,
    },
    /// Bytes are left over.
    #[error("{0} bytes stand behind the factor's end")]
    Long(usize),
    /// A number that no recording gives.
    #[error("joint {joint}: {what}")]
    Impossible {
        /// From 1; 0 for the whole.
        joint: usize,
        /// The number.
        what: &'static str,
    },
    /// Factors whose columns mean different things.
    #[error("{key}: a factor of another robot file; factor its recording again with the same one")]
    OtherRobot {
        /// Recording.
        key: String,
    },
    /// One key, two contents.
    #[error("{key}: two different factors have this key")]
    Conflict {
        /// Recording.
        key: String,
    },
}

/// Factors of a recording, with the robot file that they are of.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordingFactor {
    /// SHA-256 of the robot file.
    pub robot: [u8; 32],
    /// The factors.
    pub factors: Factors,
}

impl RecordingFactor {
    /// As bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        let Factors { joints, seconds, parameters, .. } = &self.factors;
        let mut out = Vec::new();
        out.extend(MAGIC);
        out.extend(VERSION.to_le_bytes());
        out.extend((joints.len() as u16).to_le_bytes());
        out.extend((*parameters as u32).to_le_bytes());
        out.extend(self.robot);
        out.extend(seconds.to_le_bytes());
        for joint in joints {
            out.extend((joint.columns.len() as u32).to_le_bytes());
            joint.columns.iter().for_each(|c| out.extend((*c as u32).to_le_bytes()));
            out.extend((joint.samples as u64).to_le_bytes());
            let numbers = [joint.independent].into_iter().chain(joint.range).chain(joint.reach);
            numbers.for_each(|x| out.extend(x.to_le_bytes()));
            for k in 0..joint.triangle.columns() {
                joint.triangle.column(k).iter().for_each(|x| out.extend(x.to_le_bytes()));
            }
        }
        out
    }

    /// From bytes, whoever wrote them. `name` is that of the recording. Memory is at most some
    /// times that of `bytes`.
    ///
    /// # Errors
    /// Where they are no factor.
    pub fn from_bytes(name: &str, bytes: &[u8]) -> Result<Self, FactorError> {
        let mut bytes = Bytes { all: bytes, at: 0 };
        if bytes.take::<8>("magic").map_err(|_| FactorError::Magic)? != MAGIC {
            return Err(FactorError::Magic);
        }
        let version = u16::from_le_bytes(bytes.take("version")?);
        if version != VERSION {
            return Err(FactorError::Version(version));
        }
        let dof = u16::from_le_bytes(bytes.take("number of joints")?);
        let parameters = u32::from_le_bytes(bytes.take("number of parameters")?) as usize;
        let robot = bytes.take("robot")?;
        let seconds = bytes.number("seconds")?;
        if !(seconds >= 0.0 && seconds.is_finite()) {
            return Err(FactorError::Impossible { joint: 0, what: "seconds of motion are no length of time" });
        }
        let joints = (1..=usize::from(dof)).map(|joint| bytes.joint(joint, parameters)).collect::<Result<_, _>>()?;
        match bytes.rest() {
            0 => Ok(Self { robot, factors: Factors { name: name.into(), joints, seconds, parameters } }),
            left => Err(FactorError::Long(left)),
        }
    }

    /// Takes in another recording of the same robot. As in a fit of several logs, joints without
    /// torque are left out.
    ///
    /// # Errors
    /// Where it is of another robot file.
    pub fn merge(&mut self, other: &Self) -> Result<(), FactorError> {
        let (own, others) = (&mut self.factors, &other.factors);
        let columns = |f: &Factors| f.joints.iter().map(|j| j.columns.clone()).collect::<Vec<_>>();
        if self.robot != other.robot || own.parameters != others.parameters || columns(own) != columns(others) {
            return Err(FactorError::OtherRobot { key: others.name.clone() });
        }
        own.seconds += others.seconds;
        for (to, from) in own.joints.iter_mut().zip(&others.joints).filter(|(_, from)| from.is_live()) {
            to.triangle.merge(&from.triangle);
            to.samples = to.samples.saturating_add(from.samples);
            to.independent += from.independent;
            to.range = [to.range[0].min(from.range[0]), to.range[1].max(from.range[1])];
            to.reach = [to.reach[0].min(from.reach[0]), to.reach[1].max(from.reach[1])];
        }
        Ok(())
    }

    /// Of no recording, for the joints of this one.
    fn nothing(&self, name: &str) -> Self {
        let nothing = |joint: &JointFactor| JointFactor {
            triangle: RFactor::new(joint.triangle.columns()),
            columns: joint.columns.clone(),
            samples: 0,
            independent: 0.0,
            range: [f64::INFINITY, f64::NEG_INFINITY],
            reach: [f64::INFINITY, f64::NEG_INFINITY],
            batches: Batches::new(),
        };
        let joints = self.factors.joints.iter().map(nothing).collect();
        let factors = Factors { name: name.into(), joints, seconds: 0.0, parameters: self.factors.parameters };
        Self { robot: self.robot, factors }
    }
}

/// Factors of many recordings by key, to be merged. Recordings and parts of the set come in any
/// order: they are folded in the order of their keys, so the bits do not depend on it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct KeyedFactors(BTreeMap<String, RecordingFactor>);

impl KeyedFactors {
    /// Adds a recording. The same one counts once.
    ///
    /// # Errors
    /// Where another one has this key.
    pub fn insert(&mut self, key: String, factor: RecordingFactor) -> Result<(), FactorError> {
        match self.0.entry(key) {
            Entry::Vacant(free) => {
                free.insert(factor);
                Ok(())
            }
            Entry::Occupied(same) if same.get().to_bytes() == factor.to_bytes() => Ok(()),
            Entry::Occupied(other) => Err(FactorError::Conflict { key: other.key().clone() }),
        }
    }

    /// The factor of all; `None` of none.
    ///
    /// # Errors
    /// Where they are not of one robot file.
    pub fn fold(&self, name: &str) -> Result<Option<RecordingFactor>, FactorError> {
        let Some(first) = self.0.values().next() else { return Ok(None) };
        let mut all = first.nothing(name);
        for (key, factor) in &self.0 {
            all.merge(factor).map_err(|_| FactorError::OtherRobot { key: key.clone() })?;
        }
        Ok(Some(all))
    }
}

/// Bytes that are read from their beginning.
struct Bytes<'a> {
    all: &'a [u8],
    at: usize,
}

impl Bytes<'_> {
    fn rest(&self) -> usize {
        self.all.len() - self.at
    }

    fn take<const N: usize>(&mut self, what: &'static str) -> Result<[u8; N], FactorError> {
        let part = self.all.get(self.at..).and_then(|rest| rest.first_chunk::<N>());
        let part = *part.ok_or(FactorError::Short { found: self.all.len(), what })?;
        self.at += N;
        Ok(part)
    }

    fn number(&mut self, what: &'static str) -> Result<f64, FactorError> {
        self.take(what).map(f64::from_le_bytes)
    }

    fn pair(&mut self, what: &'static str) -> Result<[f64; 2], FactorError> {
        Ok([self.number(what)?, self.number(what)?])
    }

    /// Refuses a length before memory is set aside for it.
    fn has(&self, count: u64, each: u64, what: &'static str) -> Result<(), FactorError> {
        match count.checked_mul(each) {
            Some(length) if length <= self.rest() as u64 => Ok(()),
            _ => Err(FactorError::Short { found: self.all.len(), what }),
        }
    }

    fn joint(&mut self, joint: usize, parameters: usize) -> Result<JointFactor, FactorError> {
        let refuse = |what| Err(FactorError::Impossible { joint, what });
        let count = u32::from_le_bytes(self.take("number of columns")?);
        self.has(count.into(), 4, "columns")?;
        let columns: Vec<usize> = (0..count)
            .map(|_| self.take("columns").map(|bytes| u32::from_le_bytes(bytes) as usize))
            .collect::<Result<_, _>>()?;
        let different: BTreeSet<usize> = columns.iter().copied().filter(|c| *c < parameters).collect();
        if different.len() < columns.len() {
            return refuse("its columns are no different base parameters");
        }
        let samples = u64::from_le_bytes(self.take("samples")?);
        let independent = self.number("independent samples")?;
        if samples > MOST_SAMPLES || !(independent >= 0.0 && independent <= MOST_SAMPLES as f64) {
            return refuse("the number of samples is beyond all measure");
        }
        let (range, reach) = (self.pair("torques")?, self.pair("positions")?);
        if range.iter().chain(&reach).any(|end| end.is_nan()) {
            return refuse("a range has an end that is no number");
        }
        let n = u64::from(count) + 1;
        self.has(n * (n + 1) / 2, 8, "triangle")?;
        let n = columns.len() + 1;
        let mut upper = Vec::with_capacity(n * (n + 1) / 2);
        for _ in 0..n * (n + 1) / 2 {
            upper.push(self.number("triangle")?);
        }
        if upper.iter().any(|x| !x.is_finite()) {
            return refuse("the triangle has infinite entries");
        }
        let (triangle, batches) = (RFactor::of_upper(n, &upper), Batches::new());
        Ok(JointFactor { columns, triangle, samples: samples as usize, independent, range, reach, batches })
    }
}
