//! `diagnose(file, robot)`: the library's verdict on one recording, as a text. For robot-days that
//! are flagged: it reads the raw log, and takes seconds.

use std::path::Path;
use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, StringArray};
use datafusion::arrow::datatypes::DataType;
use datafusion::common::Result;
use datafusion::execution::runtime_env::RuntimeEnv;
use datafusion::logical_expr::{ScalarUDF, Volatility};
use denavit::data::log::Reading;
use denavit::data::signal::{Motion, Prepare, each_motion};
use denavit::diagnose::{HIGHEST, Recording, Settings, diagnose, preparation};
use denavit::identify::recording::{against_limits, moving, source_joints, torque_constants};
use denavit::model::perturbable_robot::PerturbableRobot;
use denavit::report;
use denavit::robot::Robot;

use super::{function, texts};
use crate::open::with_source;
use crate::remote::local;
use crate::robots::Robots;

/// Samples of joints that a diagnosis holds at most: ten minutes of seven joints at 1 kHz.
const MOST_HELD: usize = 4_200_000;

/// The function. It reads a file that others may change.
pub(super) fn udf(robots: Arc<Robots>, stores: Arc<RuntimeEnv>) -> ScalarUDF {
    let inputs = vec![DataType::Utf8, DataType::Utf8];
    function("diagnose", inputs, DataType::Utf8, Volatility::Volatile, move |arrays| {
        let row = |(file, robot): (Option<&str>, Option<&str>)| -> Result<Option<String>> {
            let (Some(file), Some(robot)) = (file, robot) else { return Ok(None) };
            let robot = robots.open(Path::new(robot))?;
            Ok(Some(verdict(file, &robot.robot, &stores)))
        };
        let verdicts = texts(&arrays[0])?.iter().zip(texts(&arrays[1])?).map(row);
        Ok(Arc::new(verdicts.collect::<Result<StringArray>>()?) as ArrayRef)
    })
}

/// The verdict on a recording of a folder or an object store, or why there is none.
pub fn verdict(name: &str, robot: &Robot, stores: &RuntimeEnv) -> String {
    match local(stores, name) {
        Ok(file) => diagnosed(name, file.path(), robot),
        Err(why) => format!("no diagnosis: {why}"),
    }
}

fn diagnosed(name: &str, file: &Path, robot: &Robot) -> String {
    let dof = moving(robot).count();
    let reading = Reading { mapping: robot.log.clone(), joints: source_joints(robot) };
    let prepare =
        Prepare { torque_constants: torque_constants(robot), reading: reading.clone(), ..preparation(HIGHEST) };
    let mut recording = Recording::new(name);
    let mut held = 0;
    let sink = |motion: &Motion| {
        held += motion.core.len() * dof;
        if held <= MOST_HELD {
            recording.absorb(motion);
        }
    };
    let read = with_source(name, file, &reading, |source| each_motion(source, dof, &prepare, sink));
    let mut prepared = match read {
        Ok((Ok(prepared), _)) => prepared,
        Ok((Err(why), _)) => return format!("no diagnosis: {why}"),
        Err(why) => return format!("no diagnosis: {why}"),
    };
    if held > MOST_HELD {
        return format!("no diagnosis: {name} is too long to be held in memory; cut it");
    }
    if let Err(why) = against_limits(&mut prepared, robot, prepare.keep) {
        return format!("no diagnosis: {why}");
    }
    let plant = PerturbableRobot::new(robot);
    match diagnose(&plant, &[recording], &[], &Settings::default(), &|_| {}) {
        Ok(found) => report::diagnose_verdict(&found),
        Err(why) => format!("no diagnosis: {why}"),
    }
}
