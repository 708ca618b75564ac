//! `diagnose(file, robot)`: the library's verdict on one recording, as a text. For robot-days that
//! are flagged: it reads the raw log, and takes seconds.

use std::path::Path;
use std::sync::Arc;

use datafusion::arrow::array::StringArray;
use datafusion::arrow::datatypes::DataType;
use datafusion::common::Result;
use datafusion::logical_expr::{ColumnarValue, ScalarFunctionArgs, ScalarUDFImpl, Signature, Volatility};
use denavit::data::log::Reading;
use denavit::data::signal::{Motion, Prepare, each_motion};
use denavit::diagnose::{HIGHEST, Recording, Settings, diagnose, preparation};
use denavit::identify::recording::{against_limits, moving, source_joints, torque_constants};
use denavit::model::perturbable_robot::PerturbableRobot;
use denavit::report;

use super::{SessionRobots, arrays, texts};
use crate::open::with_source;
use crate::robots::KnownRobot;

/// Samples of joints that a diagnosis holds at most: ten minutes of seven joints at 1 kHz.
const MOST_HELD: usize = 4_200_000;

/// The function.
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct Diagnose {
    robots: SessionRobots,
    signature: Signature,
}

impl Diagnose {
    /// For robots of a session.
    pub fn new(robots: SessionRobots) -> Self {
        // It reads a file that others may change.
        Self { robots, signature: Signature::exact(vec![DataType::Utf8, DataType::Utf8], Volatility::Volatile) }
    }
}

impl ScalarUDFImpl for Diagnose {
    fn name(&self) -> &'static str {
        "diagnose"
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn return_type(&self, _: &[DataType]) -> Result<DataType> {
        Ok(DataType::Utf8)
    }

    fn invoke_with_args(&self, args: ScalarFunctionArgs) -> Result<ColumnarValue> {
        let arrays = arrays(&args)?;
        let row = |(file, robot): (Option<&str>, Option<&str>)| -> Result<Option<String>> {
            let (Some(file), Some(robot)) = (file, robot) else { return Ok(None) };
            let robot = self.robots.0.open(Path::new(robot))?;
            Ok(Some(verdict(Path::new(file), &robot)))
        };
        let verdicts = texts(&arrays[0])?.iter().zip(texts(&arrays[1])?).map(row);
        Ok(ColumnarValue::Array(Arc::new(verdicts.collect::<Result<StringArray>>()?)))
    }
}

/// The verdict on a recording, or why there is none.
pub fn verdict(file: &Path, robot: &KnownRobot) -> String {
    let name = file.display().to_string();
    let dof = moving(&robot.robot).count();
    let reading = Reading { mapping: robot.robot.log.clone(), joints: source_joints(&robot.robot) };
    let prepare =
        Prepare { torque_constants: torque_constants(&robot.robot), reading: reading.clone(), ..preparation(HIGHEST) };
    let mut recording = Recording::new(&name);
    let mut held = 0;
    let sink = |motion: &Motion| {
        held += motion.core.len() * dof;
        if held <= MOST_HELD {
            recording.absorb(motion);
        }
    };
    let read = with_source(&name, file, &reading, |source| each_motion(source, dof, &prepare, sink));
    let mut prepared = match read {
        Ok((Ok(prepared), _)) => prepared,
        Ok((Err(why), _)) => return format!("no diagnosis: {why}"),
        Err(why) => return format!("no diagnosis: {why}"),
    };
    if held > MOST_HELD {
        return format!("no diagnosis: {name} is too long to be held in memory; cut it");
    }
    if let Err(why) = against_limits(&mut prepared, &robot.robot, prepare.keep) {
        return format!("no diagnosis: {why}");
    }
    let plant = PerturbableRobot::new(&robot.robot);
    match diagnose(&plant, &[recording], &[], &Settings::default(), &|_| {}) {
        Ok(found) => report::diagnose_verdict(&found),
        Err(why) => format!("no diagnosis: {why}"),
    }
}
