//! Reduces one recording of a robot to a row of a fleet's table: applies the robot file's reading
//! settings, reads the log once, and returns its factors.
//!
//! The caller opens the file, so that the command and an engine on many machines use the same code.

use dh_codegen::arm::param;
use dh_codegen::robot::{EffectKind, Joint, JointKind, Robot};

use super::{AccumulatorSettings, KnownEffects, QrAccumulator, RecordingFactor};
use crate::data::log::{
    Acceptance, Finding, Limits, LogError, Reading, Source, SourceJoint, beyond_limits, torque_unit,
};
use crate::data::signal::{Motion, Prepare, PrepareError, Prepared, each_motion_in_turn};
use crate::model::Arm;
use crate::model::coupled::Coupled;
use crate::model::file_torque_model::FileTorqueModel;
use crate::model::interpreted::Interpreted;
use crate::model::robot_edit;

/// Result of one pass over a recording.
#[derive(Debug, Clone, PartialEq)]
pub struct FactoredRecording {
    /// Days since 1970, UTC; `None` if the log's time is not calendar time.
    pub day: Option<i32>,
    /// Number of samples of the motion.
    pub samples: usize,
    /// Findings of the quality check and of the comparison with the robot file's limits.
    pub findings: Vec<Finding>,
    /// Mean temperature over joints and samples, deg C.
    pub temperature: Option<f64>,
    /// Factor of the recording.
    pub factor: RecordingFactor,
}

/// Reads recordings of one robot and computes their factors.
pub struct RecordingReader<'a> {
    robot: &'a Robot,
    digest: [u8; 32],
    arm: &'a dyn Arm,
    prepare: Prepare,
    known: Option<&'a KnownEffects<'a>>,
}

impl RecordingReader<'_> {
    /// Calls `then` with a reader for the robot's recordings. `digest`: SHA-256 of the robot file;
    /// `prepare`: preparation settings, as in `identify`.
    pub fn with<T>(
        robot: &Robot,
        digest: [u8; 32],
        mut prepare: Prepare,
        then: impl FnOnce(&RecordingReader<'_>) -> T,
    ) -> T {
        let bodies = Interpreted::new(robot, &[]);
        let couplings = robot_edit::couplings(robot);
        prepare.sums = couplings.iter().map(|(coupling, _)| coupling.velocity()).collect();
        prepare.temperature = true;
        let given: Vec<f64> = couplings.iter().flat_map(|(_, values)| *values).collect();
        let arm = Coupled::new(&bodies, couplings.into_iter().map(|(coupling, _)| coupling).collect());
        let file = known_model(robot);
        prepare.margins |= file.is_some();
        let standard = param::standard_values(robot).map(|values| [values, given].concat());
        let known = file.as_ref().zip(standard);
        let known = known.and_then(|(file, standard)| KnownEffects::new(file, &arm, &standard, prepare.filter));
        then(&RecordingReader { robot, digest, arm: &arm, prepare, known: known.as_ref() })
    }

    /// Preparation settings of the recordings.
    pub fn preparation(&self) -> &Prepare {
        &self.prepare
    }

    /// Factors one recording on one thread, in memory independent of its length.
    ///
    /// # Errors
    /// If the recording can't be used.
    pub fn factor(&self, name: &str, source: &mut dyn Source) -> Result<FactoredRecording, PrepareError> {
        let mut stack = QrAccumulator::new(name, self.arm, AccumulatorSettings::default());
        let (mut start, mut heat, mut warm) = (None, 0.0, 0_usize);
        let sink = |motion: &Motion| {
            start.get_or_insert(motion.start);
            for column in motion.temperature.chunks_exact(motion.states.len.max(1)) {
                for value in motion.picks().map(|s| column[s]).filter(|value| value.is_finite()) {
                    (heat, warm) = (heat + value, warm + 1);
                }
            }
            match self.known {
                Some(known) => stack.absorb(&known.taken_out(motion)),
                None => stack.absorb(motion),
            }
        };
        let mut prepared = each_motion_in_turn(source, self.arm.dof(), &self.prepare, sink)?;
        against_limits(&mut prepared, self.robot, self.prepare.keep)?;
        Ok(FactoredRecording {
            day: start.and_then(day),
            samples: prepared.samples,
            findings: prepared.findings,
            temperature: (warm > 0).then(|| heat / warm as f64),
            factor: RecordingFactor { robot: self.digest, factors: stack.finish() },
        })
    }
}

/// Default preparation of a robot's recordings: low-pass chosen from the log, columns named by the
/// robot file.
pub fn plain_preparation(robot: &Robot) -> Prepare {
    Prepare {
        adaptive: true,
        torque_constants: torque_constants(robot),
        reading: Reading { mapping: robot.log.clone(), joints: source_joints(robot) },
        ..Prepare::default()
    }
}

/// Moving joints.
pub fn moving(robot: &Robot) -> impl Iterator<Item = &Joint> {
    robot.joints.iter().filter(|joint| joint.kind != JointKind::Fixed)
}

/// Torque constants of the moving joints, N m at the joint per A.
pub fn torque_constants(robot: &Robot) -> Vec<Option<f64>> {
    moving(robot).map(|joint| joint.drive.torque_constant).collect()
}

/// Moving joints of a robot in the coordinates of the file from which it was imported.
pub fn source_joints(robot: &Robot) -> Vec<SourceJoint> {
    moving(robot)
        .map(|joint| match &joint.source {
            Some(source) => SourceJoint {
                name: source.name.clone().unwrap_or_else(|| joint.name.clone()),
                sign: source.sign,
                offset: source.offset,
            },
            None => SourceJoint { name: joint.name.clone(), sign: 1.0, offset: 0.0 },
        })
        .collect()
}

/// Adds to a log's findings those from the comparison with the robot file's limits.
///
/// # Errors
/// If torques are in another unit and this is not accepted.
pub fn against_limits(log: &mut Prepared, robot: &Robot, keep: Acceptance) -> Result<(), LogError> {
    let limits: Vec<Limits> = moving(robot)
        .map(|joint| Limits {
            position: joint.limits.position.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]),
            torque: joint.limits.torque.unwrap_or(f64::INFINITY),
            slides: joint.kind == JointKind::Prismatic,
        })
        .collect();
    let unit = torque_unit(&log.reached, &limits, keep.torque_unit);
    if let Some(finding) = unit.as_ref().filter(|finding| finding.is_fatal()) {
        return Err(LogError::Rejected { file: log.file.clone(), findings: vec![finding.clone()] });
    }
    log.findings.extend(unit);
    log.findings.extend(beyond_limits(&log.reached, &limits));
    Ok(())
}

/// Model of the known effects; `None` if the file has none, or no links.
fn known_model(robot: &Robot) -> Option<FileTorqueModel> {
    let own = robot.joints.iter().flat_map(|joint| &joint.drive.effects);
    let fitted = |kind| kind == EffectKind::GearCoupling;
    let law = robot.joints.iter().any(|joint| joint.drive.law.is_some());
    let known = law || own.chain(&robot.effects).any(|effect| !fitted(effect.kind()));
    known.then(|| Some(FileTorqueModel::new(robot).ok()?.among_walls(robot))).flatten()
}

/// Days since 1970 of a time since 1970, s; `None` for a time with another origin, which would lie
/// before 2000 or after 2100.
fn day(time: f64) -> Option<i32> {
    const DAY: f64 = 86_400.0;
    let days = (time / DAY).floor();
    (10_957.0..47_482.0).contains(&days).then_some(days as i32)
}
