//! The robot file that a user would have: identified on the fitted logs before anything is added.

use dh_codegen::arm::param::{self, Parameter};
use dh_codegen::robot::Robot;

use crate::apps::paper::ReproduceError;
use crate::data::log::{Acceptance, Log, Replay};
use crate::data::signal::{Filter, Prepare, each_motion, lower_cutoff};
use crate::identify::{
    AccumulatorSettings, ConsistentSettings, IdentifySettings, QrAccumulator, consistent, nonnegative_drives,
    recover_standard, solve,
};
use crate::model::interpreted::Interpreted;
use crate::model::robot_edit;

/// The robot with bodies and drives identified from these logs; every joint has a rotor, viscous
/// and Coulomb friction and an offset.
pub(super) fn identified(file: &Robot, logs: &[Log]) -> Result<Robot, ReproduceError> {
    let mut robot = Robot { tool: None, ..file.clone() };
    for row in robot.moving() {
        let drive = &mut robot.joints[row].drive;
        for value in
            [&mut drive.rotor_inertia, &mut drive.viscous_friction, &mut drive.coulomb_friction, &mut drive.offset]
        {
            value.get_or_insert(0.0);
        }
    }
    let arm = Interpreted::new(&robot, &[]);
    let mut factors = Vec::new();
    for log in logs {
        let (stack, _) = lower_cutoff(10.0, |cutoff| {
            let filter = Some(Filter { order: 5, cutoff });
            let prepare = Prepare { filter, adaptive: true, keep: Acceptance::all(), ..Prepare::default() };
            let mut stack = QrAccumulator::new("fit", &arm, AccumulatorSettings::default());
            each_motion(&mut Replay::new(log), robot.dof(), &prepare, |motion| stack.absorb(motion))?;
            Ok(stack)
        })?;
        factors.push(stack.finish());
    }
    let prior = param::standard_values(&robot);
    let settings = IdentifySettings { prior: prior.clone(), ..IdentifySettings::default() };
    let found = solve(&arm, &factors, &[], &settings)?;
    let drives: Vec<f64> = param::standard(&robot)
        .iter()
        .map(|p| match *p {
            Parameter::Drive(row, term) => param::drive_value(&robot, row, term).unwrap_or(0.0),
            Parameter::Link(..) => 0.0,
        })
        .collect();
    let bodies = robot_edit::prior(&robot, &arm);
    let standard = match consistent(&arm, &factors, &[], &found, &bodies, &drives, &ConsistentSettings::default()) {
        Ok(possible) => possible.standard,
        Err(_) => {
            let bounded = nonnegative_drives(&arm, &factors, &found, &settings, &[])?;
            recover_standard(&arm, &bounded.base, prior.as_deref())?
        }
    };
    Ok(robot_edit::with_values(robot, &standard))
}
