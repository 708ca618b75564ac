//! Serialises the factors of one recording, so that they can be merged on another machine.
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
//! The batches, from which [`solve`](super::solve) estimates the correlation of the residual, are
//! omitted: they would be sixty times as large. Standard deviations are then based on the number of
//! independent samples that the torque's bandwidth allows.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

use super::regression::accumulator::{Factors, JointFactor};
use super::regression::batches::Batches;
use super::regression::r_factor::RFactor;

const MAGIC: [u8; 8] = *b"DNVFACTR";
const VERSION: u16 = 1;
/// Largest number of samples, so that sums over any number of recordings stay in range.
const MOST_SAMPLES: u64 = 1 << 40;

/// Reason why factors can't be read or merged.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FactorError {
    /// The bytes are not a factor.
    #[error("no factor: the first bytes are not DNVFACTR")]
    Magic,
    /// The factor was written by a later version.
    #[error("a factor of version {0}, where version 1 is known; use a newer denavit")]
    Version(u16),
    /// The factor is truncated.
    #[error("the factor ends after {found} bytes, within {what}")]
    Short {
        /// Length found, bytes.
        found: usize,
        /// Name of the truncated part.
        what: &'static str,
    },
    /// The factor has excess bytes.
    #[error("{0} bytes stand behind the factor's end")]
    Long(usize),
    /// A number is impossible for any recording.
    #[error("joint {joint}: {what}")]
    Impossible {
        /// Joint, counted from 1; 0 for the whole factor.
        joint: usize,
        /// Name of the number.
        what: &'static str,
    },
    /// The factors belong to different robot files, so their columns differ in meaning.
    #[error("{key}: a factor of another robot file; factor its recording again with the same one")]
    OtherRobot {
        /// Key of the recording.
        key: String,
    },
    /// Two different factors have the same key.
    #[error("{key}: two different factors have this key")]
    Conflict {
        /// Key of the recording.
        key: String,
    },
}

/// Factors of a recording with the digest of their robot file.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordingFactor {
    /// SHA-256 of the robot file.
    pub robot: [u8; 32],
    /// Factors of the recording.
    pub factors: Factors,
}

impl RecordingFactor {
    /// Serialises the factor.
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

    /// Parses bytes from an untrusted source. `name` is the name of the recording. Memory is at
    /// most a few times that of `bytes`.
    ///
    /// # Errors
    /// If the bytes are not a valid factor.
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

    /// Merges another recording of the same robot. Joints without torque are left out, as in a fit
    /// of several logs.
    ///
    /// # Errors
    /// If it belongs to another robot file.
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

    /// Empty factor with the joints and columns of this one.
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

/// Factors of many recordings by key, to be merged. Recordings and subsets may be added in any
/// order: they are folded in the order of their keys, so the result is identical to the bit.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct KeyedFactors(BTreeMap<String, RecordingFactor>);

impl KeyedFactors {
    /// Adds a recording. An identical one with the same key counts once.
    ///
    /// # Errors
    /// If a different factor has this key.
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

    /// Merged factor of all recordings; `None` if there are none.
    ///
    /// # Errors
    /// If the factors do not belong to one robot file.
    pub fn fold(&self, name: &str) -> Result<Option<RecordingFactor>, FactorError> {
        let Some(first) = self.0.values().next() else { return Ok(None) };
        let mut all = first.nothing(name);
        for (key, factor) in &self.0 {
            all.merge(factor).map_err(|_| FactorError::OtherRobot { key: key.clone() })?;
        }
        Ok(Some(all))
    }
}

/// Reader of bytes from their beginning.
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

    /// Rejects a length that exceeds the remaining bytes, before memory is allocated for it.
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
