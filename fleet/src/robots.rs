//! The robot files of a session, by their digest: what gives the columns of a factor a meaning.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use denavit::data::log::hexadecimal;
use denavit::identify::{Factors, Identification, IdentifySettings, RecordingFactor, solve};
use denavit::model::coupled::Coupled;
use denavit::model::interpreted::Interpreted;
use denavit::model::robot_edit;
use denavit::model::{Arm, DriveTerm, StandardParameter};
use denavit::robot::{Files, Problems, Robot};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::channel::Channels;
use crate::error::FleetError;

/// The text of a robot file, and of the tool files that it names: what another machine needs of it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RobotFile {
    /// Where it was read.
    pub path: PathBuf,
    text: Vec<u8>,
    /// By the name in the robot file.
    tools: BTreeMap<String, String>,
}

/// A robot file that was read.
pub struct KnownRobot {
    /// The robot.
    pub robot: Robot,
    /// SHA-256 of its file.
    pub digest: [u8; 32],
    /// The file.
    pub file: RobotFile,
    /// Its arm, for solving.
    pub arm: &'static dyn Arm,
    /// The changes that are looked for.
    pub channels: Channels,
}

impl std::fmt::Debug for KnownRobot {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.file.path.display())
    }
}

impl KnownRobot {
    /// Reads a file.
    ///
    /// # Errors
    /// Where it can't be read or has mistakes.
    pub fn open(path: &Path) -> Result<Self, FleetError> {
        let text =
            std::fs::read(path).map_err(|source| FleetError::File { path: path.into(), verb: "read", source })?;
        let tools = RefCell::new(BTreeMap::new());
        let beside = |name: &str| -> std::io::Result<String> {
            let text = std::fs::read_to_string(path.with_file_name(name))
                .map_err(|e| std::io::Error::new(e.kind(), format!("{name}: {e}")))?;
            tools.borrow_mut().insert(name.to_string(), text.clone());
            Ok(text)
        };
        let robot = parsed(path, &text, &beside)?;
        Ok(Self::of(robot, RobotFile { path: path.into(), text, tools: tools.into_inner() }))
    }

    /// Reads the text of a file that another machine has.
    ///
    /// # Errors
    /// Where it has mistakes.
    pub fn given(file: RobotFile) -> Result<Self, FleetError> {
        let beside = |name: &str| -> std::io::Result<String> {
            file.tools.get(name).cloned().ok_or_else(|| std::io::ErrorKind::NotFound.into())
        };
        let robot = parsed(&file.path, &file.text, &beside)?;
        Ok(Self::of(robot, file))
    }

    fn of(robot: Robot, file: RobotFile) -> Self {
        // A session reads a handful of robot files and keeps them to its end.
        let bodies: &'static Interpreted = Box::leak(Box::new(Interpreted::new(&robot, &[])));
        let couplings = robot_edit::couplings(&robot).into_iter().map(|(coupling, _)| coupling).collect();
        let arm: &'static dyn Arm = Box::leak(Box::new(Coupled::new(bodies, couplings)));
        let (channels, digest) = (Channels::of(arm), Sha256::digest(&file.text).into());
        Self { robot, digest, file, arm, channels }
    }

    /// The robot with the friction and the offsets of a model, base parameters. Bodies stay those
    /// of the file: base parameters are sums over them.
    pub fn with_friction(&self, model: &[f64]) -> Robot {
        let (mut robot, standard) = (self.robot.clone(), self.arm.standard_parameters());
        for (base, &value) in self.arm.base_parameters().iter().zip(model) {
            let [(one, factor)] = base.coefficients[..] else { continue };
            let StandardParameter::Drive(row, term) = standard[one] else { continue };
            let drive = &mut robot.joints[row].drive;
            match term {
                DriveTerm::FV => drive.viscous_friction = Some((value / factor).max(0.0)),
                DriveTerm::FC => drive.coulomb_friction = Some((value / factor).max(0.0)),
                DriveTerm::FO => drive.offset = Some(value / factor),
                DriveTerm::IA => {}
            }
        }
        robot
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

/// The robot of a text.
fn parsed(path: &Path, text: &[u8], tools: &Files<'_>) -> Result<Robot, FleetError> {
    let mistakes = |problems: Problems| FleetError::Robot(problems.in_file(&path.display().to_string()).to_string());
    Robot::from_bytes(text, tools).map(|reading| reading.robot).map_err(mistakes)
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
        let known =
            self.0.lock().unwrap_or_else(PoisonError::into_inner).values().find(|r| r.file.path == path).cloned();
        if let Some(known) = known {
            return Ok(known);
        }
        let robot = Arc::new(KnownRobot::open(path)?);
        self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(robot.digest, Arc::clone(&robot));
        Ok(robot)
    }

    /// The robot of a file that another machine read, made once.
    ///
    /// # Errors
    /// Where it has mistakes.
    pub fn given(&self, file: RobotFile) -> Result<Arc<KnownRobot>, FleetError> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner).values().find(|r| r.file == file).cloned();
        if let Some(known) = known {
            return Ok(known);
        }
        let robot = Arc::new(KnownRobot::given(file)?);
        self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(robot.digest, Arc::clone(&robot));
        Ok(robot)
    }

    /// The files.
    pub fn files(&self) -> Vec<RobotFile> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).values().map(|robot| robot.file.clone()).collect()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_of_a_model_is_the_robots() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots/kinova-gen3.yaml");
        let known = KnownRobot::open(&path).unwrap();
        let number = |name: &str| known.arm.base_parameters().iter().position(|base| base.name == name).unwrap();
        let mut model = vec![0.0; known.arm.base_parameters().len()];
        (model[number("FC4")], model[number("FV4")], model[number("FO4")]) = (2.5, -0.1, -0.3);
        let robot = known.with_friction(&model);
        let drive = &robot.joints[3].drive;
        assert_eq!(drive.coulomb_friction, Some(2.5));
        // A level, which no file has below 0.
        assert_eq!(drive.viscous_friction, Some(0.0));
        assert_eq!(drive.offset, Some(-0.3));
        assert_eq!(robot.links, known.robot.links);
    }
}
