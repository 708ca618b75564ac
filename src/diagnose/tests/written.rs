//! Agreement of errors: a file's error on a log is the same in every command, and the written file
//! is the offered model.

use dh_codegen::arm::param;
use dh_codegen::robot::effects::{JointSpring, TorqueOffset};
use dh_codegen::robot::{Inertia, Robot, no_files};

use super::mechanisms::{Bodies, RATE, bare, log, plain, planar};
use super::world::{motion, record};
use crate::data::log::open;
use crate::data::signal::{Prepare, each_motion};
use crate::diagnose::windows::windowed_data::edge;
use crate::diagnose::{Diagnosis, Offered, SearchSettings, Settings, diagnose, extended, misses, written_errors};
use crate::identify::{AccumulatorSettings, IdentifySettings, KnownEffects, QrAccumulator, solve};
use crate::model::file_torque_model::FileTorqueModel;
use crate::model::interpreted::Interpreted;
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::{States, TorqueModel};
use crate::numerics::prng::Random;

/// Torques of the textbook arm with a spring in joint 2.
fn sprung(robot: &Robot, stiffness: f64) -> impl Fn(&[[f64; 2]; 3]) -> [f64; 2] + use<> {
    let (bodies, robot) = (Bodies::of(&bare(robot)), robot.clone());
    move |s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        [rigid[0] + friction[0], rigid[1] + friction[1] + stiffness * (s[0][1] - 0.1)]
    }
}

fn rms(x: impl ExactSizeIterator<Item = f64>) -> f64 {
    let n = x.len() as f64;
    (x.map(|x| x * x).sum::<f64>() / n).sqrt()
}

/// Error of the unchanged file in an identification's fit, N m.
fn before_identification(file: &Robot, bytes: &[u8]) -> Vec<f64> {
    let arm = Interpreted::new(file, &[]);
    let (model, standard) = (FileTorqueModel::new(file).unwrap(), param::standard_values(file).unwrap());
    let prepare = Prepare { margins: true, ..Prepare::default() };
    let known = KnownEffects::new(&model, &arm, &standard, prepare.filter).unwrap();
    let mut stack = QrAccumulator::new("log", &arm, AccumulatorSettings::default());
    let mut source = open("log", bytes).unwrap();
    each_motion(source.as_mut(), 2, &prepare, |motion| stack.absorb(&known.taken_out(motion))).unwrap();
    let settings = IdentifySettings { prior: Some(standard), ..IdentifySettings::default() };
    solve(&arm, &[stack.finish()], &[], &settings).unwrap().fit_before.unwrap().rms
}

/// The file's spring is too weak, and it has an offset that the arm does not have.
#[test]
fn identification_evaluation_and_diagnosis_agree_on_what_a_file_with_effects_misses() {
    const SEED: u64 = 21;
    let mut file = planar();
    let spring = JointSpring { stiffness: Some(1.0), rest: Some(0.1), ..Default::default() };
    file.joints[1].drive.effects.push(spring.into());
    file.joints[0].drive.effects.push(TorqueOffset { offset: Some(0.5) }.into());
    let truth = sprung(&planar(), 1.6);
    let bytes = log(&file, 10.0, &mut Random::new(SEED), &truth);
    let identified = before_identification(&file, &bytes);
    let recording = record("log", &bytes, 2);
    let stretch = recording.stretches[0].clone();
    let [diagnosed, _] = misses(&PerturbableRobot::new(&file), &[recording], &Settings::default());

    let states = motion(&file, 10.0, RATE, &mut Random::new(SEED));
    let len = states[0].len();
    let of = |which: usize| states.iter().flatten().map(|s| s[which]).collect::<Vec<f64>>();
    let mut predicted = vec![0.0; 2 * len];
    let model = FileTorqueModel::new(&file).unwrap();
    model.torques(&States { len, q: of(0), dq: of(1), ddq: of(2) }, &mut predicted);
    // Each on the samples that it uses: the diagnosis leaves out more of the ends.
    let identified_on = (0.2 * RATE) as usize..len - (0.2 * RATE) as usize;
    let (first, cut) = ((stretch.start * RATE).round() as usize, edge(&stretch, stretch.states.len));
    let diagnosed_on = first + cut..first + stretch.states.len - cut;
    let missed =
        |k: usize, j: usize| truth(&[0, 1, 2].map(|i| [states[0][k][i], states[1][k][i]]))[j] - predicted[j * len + k];
    for j in 0..2 {
        for (figure, used) in [(identified[j], &identified_on), (diagnosed[j], &diagnosed_on)] {
            let evaluated = rms(used.clone().map(|k| missed(k, j)));
            assert!(
                evaluated > 0.2 && (figure - evaluated).abs() < 0.02 * evaluated,
                "joint {}: {figure} {evaluated}",
                j + 1
            );
        }
    }
}

/// Diagnoses `file` for an arm with these torques, with at most `causes`. The error of the written
/// file on the validating log must equal that of the offered model.
fn offered(file: &Robot, causes: usize, truth: &dyn Fn(&[[f64; 2]; 3]) -> [f64; 2]) -> (Diagnosis, Robot) {
    let mut random = Random::new(31);
    let [fit, validate] = [8.0, 4.0].map(|seconds| record("log", &log(file, seconds, &mut random, truth), 2));
    let search = SearchSettings { most: causes, ..SearchSettings::default() };
    let settings = Settings { search, ..Settings::default() };
    let validate = [validate];
    let found = diagnose(&PerturbableRobot::new(file), &[fit], &validate, &settings, &|_| {}).unwrap();
    let robot = extended(file.clone(), &found);
    let text = robot.to_yaml();
    let robot = Robot::from_yaml(&text, &no_files).unwrap().robot;
    let written = written_errors(&FileTorqueModel::new(&robot).unwrap(), &validate, &found);
    for (is, offered) in written.iter().zip(&found.extended.validate) {
        assert!((is - offered).abs() < 0.01 * offered, "{written:?} {:?}\n{text}", found.extended.validate);
    }
    (found, robot)
}

/// A drive's own offset is corrected, and no second one of opposite sign is written beside it.
#[test]
fn a_wrong_offset_of_the_file_is_corrected_where_it_stands() {
    let mut file = planar();
    let truth = sprung(&file, 0.0);
    file.joints[0].drive.offset = Some(1.5);
    let (found, written) = offered(&file, 3, &truth);
    assert!(found.causes.iter().any(|c| c.cause == "torque_offset"), "{:?}", found.causes);
    let drive = &written.joints[0].drive;
    assert!(drive.effects.is_empty() && drive.offset.is_some_and(|own| own.abs() < 0.1), "{drive:?}");
}

#[test]
fn a_file_that_is_kept_is_written_as_it_is() {
    let file = planar();
    let (found, written) = offered(&file, 0, &sprung(&file, 0.0));
    assert_eq!(found.offer.offered, Offered::File);
    assert_eq!(written.to_yaml(), file.to_yaml());
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn a_refit_is_written_with_its_links_and_friction() {
    let known = planar();
    let truth = sprung(&known, 0.0);
    let mut without = Robot { links: Vec::new(), ..known.clone() };
    without.joints.iter_mut().for_each(|joint| joint.drive = Default::default());
    let mut heavy = known.clone();
    heavy.links.iter_mut().flatten().for_each(|link| *link = Inertia::from_array(link.to_array().map(|v| 1.5 * v)));
    for file in [without, heavy] {
        let (found, written) = offered(&file, 0, &truth);
        assert!(found.links_refitted && found.offer.offered != Offered::File, "{:?}", found.offer);
        assert!(written.links.iter().all(|link| link.is_some_and(|link| link.physical().is_ok())));
        for (written, truth) in written.joints.iter().zip(&known.joints) {
            let [is, was] = [&written.drive, &truth.drive].map(|drive| drive.coulomb_friction.unwrap());
            assert!((is - was).abs() < 0.1 * was, "{is} {was}");
        }
    }
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn an_extended_model_is_written_with_its_causes() {
    let known = planar();
    let without = Robot { links: Vec::new(), ..known.clone() };
    for (file, refitted) in [(known.clone(), false), (without, true)] {
        let (found, written) = offered(&file, 1, &sprung(&known, 0.5));
        assert_eq!((found.offer.offered, found.links_refitted), (Offered::Extended, refitted));
        let effects: Vec<&str> = written.joints[1].drive.effects.iter().map(|e| e.name()).collect();
        assert_eq!(effects, ["joint_spring"]);
    }
}
