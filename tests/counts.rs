//! Cost of the closed form and number of base parameters: figures that must not deteriorate
//! unnoticed.

use denavit::model::rigid_body::base::{Torques, rank, rank_of};
use dh_codegen::arm::param::{DriveTerm, Parameter};
use dh_codegen::arm::{BaseParameters, Function, Model};
use dh_codegen::robot::{Drive, Robot, no_files};

/// A robot of the repository without drives, as counted in the literature.
fn bare(name: &str) -> Robot {
    let mut robot = with_drives(name);
    robot.joints.iter_mut().for_each(|joint| joint.drive = Drive::default());
    robot
}

fn with_drives(name: &str) -> Robot {
    let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    Robot::from_yaml(&text, &no_files).unwrap().robot
}

/// Multiplications and additions of a function, without sines and cosines.
fn count(model: &Model, function: Function) -> [usize; 2] {
    let operations = model.kernel(function).tape.operations();
    [operations.mul, operations.add]
}

/// Counts of inverse dynamics (from base parameters), base regressor, regressor and mass matrix,
/// with the peers' figures for the first two. Ours take fewer multiplications, fewer additions, and
/// at least a tenth fewer operations in all.
fn costs(name: &str, expected: [[usize; 2]; 4], peers: [[usize; 2]; 2]) {
    use Function::{BaseRegressor, InverseDynamicsBase, MassMatrix, Regressor};
    let model = Model::new(&bare(name));
    let found = [InverseDynamicsBase, BaseRegressor, Regressor, MassMatrix].map(|f| count(&model, f));
    assert_eq!(found, expected, "{name}: fewer is better, then write the new figures here");
    for ([mul, add], [their_mul, their_add]) in found.into_iter().zip(peers) {
        assert!(
            mul < their_mul && add <= their_add && 10 * (mul + add) <= 9 * (their_mul + their_add),
            "{name}: {mul}/{add}, not a tenth below {their_mul}/{their_add}"
        );
    }
}

// Peers, multiplications/additions:
//                                        UR10      Puma 560   LWR 4+    Panda
//   inverse dynamics, base parameters    297/239   315/253    343/271   361/288
//   base regressor                       542/355   602/396    729/446   788/496

#[test]
fn ur10e_costs() {
    costs("ur10e", [[249, 216], [308, 243], [406, 322], [163, 143]], [[297, 239], [542, 355]]);
}

#[test]
fn puma560_costs() {
    costs("puma560", [[261, 234], [379, 298], [473, 386], [184, 159]], [[315, 253], [602, 396]]);
}

#[test]
fn kuka_lwr4_costs() {
    costs("kuka-lwr4", [[283, 262], [597, 426], [757, 578], [197, 154]], [[343, 271], [729, 446]]);
    let whole: usize = count(&Model::new(&bare("kuka-lwr4")), Function::BaseRegressor).iter().sum();
    assert!(whole <= 1050, "{whole}");
}

#[test]
fn franka_panda_costs() {
    costs("franka-panda", [[300, 278], [625, 466], [813, 634], [223, 190]], [[361, 288], [788, 496]]);
}

/// Numbers of base parameters: of the bare robot; with a rotor on every joint; with an influence at
/// rest; on a tilted base.
fn base_counts(name: &str) -> [usize; 4] {
    let robot = bare(name);
    let mut rotors = robot.clone();
    rotors.joints.iter_mut().for_each(|joint| joint.drive.rotor_inertia = Some(0.0));
    let tilted = Robot { gravity: [1.0, 2.0, -9.0], ..robot.clone() };
    let closed = |robot: &Robot| {
        let closed = BaseParameters::new(robot).len();
        let numeric = rank(robot, 3, 60);
        assert!(numeric.gap > 1e3, "{name}: the rank itself is in doubt: {numeric:?}");
        assert_eq!(closed, numeric.rank, "{name}");
        closed
    };
    [closed(&robot), closed(&rotors), rank_of(&robot, Torques::Gravity, 3, 60).rank, closed(&tilted)]
}

#[test]
fn six_joints_have_36_base_parameters() {
    for name in ["puma560", "staubli-tx40", "ur10e"] {
        assert_eq!(base_counts(name), [36, 40, 10, 38], "{name}");
    }
}

#[test]
fn seven_joints_have_43_base_parameters() {
    for name in ["kuka-lwr4", "kuka-iiwa14", "franka-panda", "kinova-gen3"] {
        assert_eq!(base_counts(name), [43, 48, 12, 45], "{name}");
    }
}

#[test]
fn small_arms() {
    assert_eq!(BaseParameters::new(&bare("planar2r")).len(), 6);
    assert_eq!(BaseParameters::new(&bare("scara")).len(), 8);
}

/// With the drives of its file, every robot has as many base parameters as its regressor has rank.
#[test]
fn every_robot_has_as_many_as_the_rank() {
    for entry in std::fs::read_dir(format!("{}/robots", env!("CARGO_MANIFEST_DIR"))).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "yaml") {
            continue;
        }
        let name = path.file_stem().unwrap().to_str().unwrap();
        let robot = with_drives(name);
        let base = BaseParameters::new(&robot);
        assert_eq!(base.len(), rank(&robot, 11, 60).rank, "{name}");
        let coulomb = |b: &&dh_codegen::arm::BaseParameter| matches!(b.leader, Parameter::Drive(_, DriveTerm::FC));
        let given = robot.joints.iter().filter(|j| j.drive.coulomb_friction.is_some()).count();
        assert_eq!(base.0.iter().filter(coulomb).count(), given, "{name}: Coulomb friction groups with nothing");
    }
}
