//! Recordings used by the tests, with the data needed to use them.

/// An arm with recordings, in a folder of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArmData {
    /// Folder of the recordings.
    pub folder: &'static str,
    /// Robot file.
    pub robot: &'static str,
    /// Fitted logs.
    pub fit: &'static [&'static str],
    /// Validating logs; without one, the last third of the fitted ones.
    pub validate: &'static [&'static str],
    /// Known delay of the torque, s; the torque is shifted back by it.
    pub late: f64,
    /// Torque at the joint per motor current, N m/A, if the log has currents; empty if it has
    /// torques.
    pub gains: &'static [f64],
}

/// Defaults: no delay, torques.
const PLAIN: ArmData = ArmData { folder: "", robot: "", fit: &[], validate: &[], late: 0.0, gains: &[] };

/// All arms with recordings. Each folder's README has source and licence.
pub const ARMS: [ArmData; 6] = [
    ArmData {
        folder: "kuka-lwr4plus",
        robot: include_str!("../../../../../robots/kuka-lwr4.yaml"),
        fit: &["traj1.csv"],
        ..PLAIN
    },
    ArmData {
        folder: "franka-panda",
        robot: include_str!("../../../../../robots/franka-panda.yaml"),
        fit: &["exciting.csv"],
        ..PLAIN
    },
    ArmData {
        folder: "kuka-iiwa14",
        robot: include_str!("../../../../../robots/kuka-iiwa14.yaml"),
        fit: &["chirp_j2.csv", "chirp_j6.csv", "chirp_j5j6j7.csv", "motion_j2toj7.csv"],
        validate: &["motion_j3j4.csv"],
        late: 0.04,
        ..PLAIN
    },
    ArmData {
        folder: "staubli-tx40",
        robot: include_str!("../../../../../robots/staubli-tx40.yaml"),
        fit: &["exciting_train.csv"],
        ..PLAIN
    },
    ArmData {
        folder: "kinova-gen3",
        robot: include_str!("../../../../../robots/kinova-gen3.yaml"),
        fit: &["optitraj1.csv"],
        validate: &["sync7_run.csv"],
        ..PLAIN
    },
    // Stands and is pushed: only offsets, gains and contacts can be added to it.
    ArmData {
        folder: "ur10e-pushed",
        robot: include_str!("../../../../../robots/ur10e.yaml"),
        fit: &["static_hand_push.csv"],
        gains: &[10.0, 10.6956, 8.4566, 9.0029, 9.48, 10.1232],
        ..PLAIN
    },
];
