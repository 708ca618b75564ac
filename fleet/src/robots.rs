//! The robot files of a session, by their digest: what gives the columns of a factor a meaning.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use denavit::identify::{Factors, Identification, IdentifySettings, RecordingFactor, solve};
use denavit::model::Arm;
use denavit::model::coupled::Coupled;
use denavit::model::interpreted::Interpreted;
use denavit::model::robot_edit;
use denavit::robot::Robot;
use sha2::{Digest, Sha256};

use crate::channel::Channels;
use crate::error::FleetError;

/// A robot file that was read.
pub struct KnownRobot {
    /// The robot.
    pub robot: Robot,
    /// SHA-256 of its file.
    pub digest: [u8; 32],
    /// Where it was read.
    pub path: PathBuf,
    /// Its arm, for solving.
    pub arm: &'static dyn Arm,
    /// The changes that are looked for.
    pub channels: Channels,
}

impl std::fmt::Debug for KnownRobot {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.path.display())
    }
}

impl KnownRobot {
    /// Reads a file.
    ///
    /// # Errors
    /// Where it can't be read or has mistakes.
    pub fn open(path: &Path) -> Result<Self, FleetError> {
        let unreadable = |source| FleetError::File { path: path.into(), verb: "read", source };
        let text = std::fs::read(path).map_err(unreadable)?;
        let robot = Robot::open(path)
            .map_err(|problems| FleetError::Robot { path: path.into(), problems: problems.to_string() })?;
        // A session reads a handful of robot files and keeps them to its end.
        let bodies: &'static Interpreted = Box::leak(Box::new(Interpreted::new(&robot, &[])));
        let couplings = robot_edit::couplings(&robot).into_iter().map(|(coupling, _)| coupling).collect();
        let arm: &'static dyn Arm = Box::leak(Box::new(Coupled::new(bodies, couplings)));
        let (channels, digest) = (Channels::of(arm), Sha256::digest(&text).into());
        Ok(Self { robot, digest, path: path.into(), arm, channels })
    }

    /// Base parameters from factors.
    ///
    /// # Errors
    /// Where they are not of this arm, or determine nothing.
    pub fn solve(&self, what: &str, factors: &[Factors]) -> Result<Identification, FleetError> {
        solve(self.arm, factors, &[], &IdentifySettings::default())
            .map_err(|source| FleetError::Identify { what: what.into(), source })
    }
}

/// The robot files that were read so far.
#[derive(Debug, Default)]
pub struct Robots(Mutex<BTreeMap<[u8; 32], Arc<KnownRobot>>>);

impl Robots {
    /// The robot of a file, read once.
    ///
    /// # Errors
    /// Where it can't be read or has mistakes.
    pub fn open(&self, path: &Path) -> Result<Arc<KnownRobot>, FleetError> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner).values().find(|r| r.path == path).cloned();
        if let Some(known) = known {
            return Ok(known);
        }
        let robot = Arc::new(KnownRobot::open(path)?);
        self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(robot.digest, Arc::clone(&robot));
        Ok(robot)
    }

    /// The robot of a factor.
    ///
    /// # Errors
    /// Where its file was not read.
    pub fn of(&self, factor: &RecordingFactor) -> Result<Arc<KnownRobot>, FleetError> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner).get(&factor.robot).cloned();
        known.ok_or_else(|| FleetError::UnknownRobot { digest: hexadecimal(&factor.robot) })
    }
}

/// Bytes in hexadecimal digits.
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
