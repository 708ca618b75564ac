//! The functions against each other and against differences, and a stored check vector.

use std::vec::Vec;

use super::*;

const Q: [f64; DOF] = [
    -0.15358173847198486, 0.018814802169799805, 0.2967187166213989, -0.23427331447601318, 0.590895414352417,
    0.0010224580764770508, 0.10787069797515869,
];
const DQ: [f64; DOF] = [
    0.5364192724227905, 0.8342322111129761, 0.3827909231185913, -0.2709789276123047, -0.5854606628417969,
    -0.1196742057800293, -0.9424793720245361,
];
const DDQ: [f64; DOF] = [
    -0.7735795974731445, -0.3503504991531372, 0.46886301040649414, -0.3076845407485962, 0.23818325996398926,
    -0.24037086963653564, 0.007170677185058594,
];
const PHI: [f64; STANDARD] = [
    -0.08357858657836914, 0.46506690979003906, 0.554935097694397, -0.3443901538848877, -0.9381728172302246,
    -0.36106765270233154, 0.9568207263946533, -0.6125220060348511, 0.8210475444793701, -0.09194540977478027,
    -0.83368980884552, -0.9050981998443604, 0.9776283502578735, 0.9525574445724487, -0.5295736789703369,
    -0.18684661388397217, -0.6830548048019409, -0.2710700035095215, 0.7036701440811157, 0.1631767749786377,
    -0.17402172088623047, 0.3421546220779419, 0.1769545078277588, 0.8368265628814697, -0.8107051849365234,
    0.5867948532104492, 0.6589376926422119, 0.8312602043151855, 0.26376235485076904, 0.492397665977478,
    -0.4847680330276489, -0.19721722602844238, -0.3937588930130005, 0.3037540912628174, -0.7279425859451294,
    0.6258370876312256, -0.7586435079574585, -0.8024013042449951, 0.09565246105194092, 0.6859145164489746,
    0.3170276880264282, -0.16469287872314453, -0.36151742935180664, -0.8808259963989258, 0.5742906332015991,
    -0.05156147480010986, -0.2560371160507202, 0.47957682609558105, 0.763738751411438, 0.3314594030380249,
    -0.12545156478881836, -0.6442421674728394, 0.29802238941192627, -0.7723948955535889, -0.9617632627487183,
    0.039313435554504395, -0.5865349769592285, -0.46957170963287354, 0.4593973159790039, 0.8330234289169312,
    -0.8026940822601318, -0.8452376127243042, 0.8317148685455322, 0.27969348430633545, 0.08811140060424805,
    0.45958757400512695, -0.0652700662612915, 0.23529422283172607, 0.00011920928955078125, 0.6262673139572144,
    0.7379261255264282, -0.48264217376708984, 0.6669073104858398, 0.6044915914535522, -0.9949312210083008,
    0.24764585494995117, -0.0875023603439331, 0.8954567909240723, 0.6760494709014893, -0.3350759744644165,
    0.5425145626068115, -0.849231481552124, -0.9767918586730957, 0.9964309930801392, -0.9263875484466553,
    0.980994701385498, 0.35827577114105225, -0.2501676082611084, 0.9225995540618896, -0.09318602085113525,
    -0.7319774627685547,
];
/// Torques by the interpreter of the same tape, bit for bit.
const TAU: [f64; DOF] = [
    -2.3518455653335444, 20.90600155419964, -1.466644752556993, -16.978007394894426, -1.864123759275362,
    -13.570569471879827, 0.5065314516949977,
];
/// Half the step of central differences, rad or m and their rates.
const STEP: f64 = 1e-5;

fn close(a: f64, b: f64, size: f64) {
    assert!((a - b).abs() <= 1e-11 * (1.0 + size), "{a} is not {b}");
}

/// The same of a central difference.
fn near(a: f64, b: f64, size: f64) {
    assert!((a - b).abs() <= 1e-7 * (1.0 + size), "{a} is not {b}");
}

fn product<const M: usize>(w: &[[f64; M]; DOF], x: &[f64; M]) -> [f64; DOF] {
    core::array::from_fn(|i| dot(&w[i], x))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// `x + t v`.
fn moved(x: &[f64; DOF], t: f64, v: &[f64; DOF]) -> [f64; DOF] {
    core::array::from_fn(|k| x[k] + t * v[k])
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}

/// Velocity of a frame from two poses of it: of its origin, and its angular velocity.
fn velocity(pose: &[[f64; 4]; 3], before: &[[f64; 4]; 3], after: &[[f64; 4]; 3]) -> [f64; 6] {
    let rate = |i: usize, j: usize| (after[i][j] - before[i][j]) / (2.0 * STEP);
    // The skew matrix of the angular velocity is the rate of R times R'.
    let skew = |i: usize, j: usize| (0..3).map(|k| rate(i, k) * pose[j][k]).sum::<f64>();
    [rate(0, 3), rate(1, 3), rate(2, 3), skew(2, 1), skew(0, 2), skew(1, 0)]
}

#[test]
fn frames_are_rotations_and_the_last_is_forward_kinematics() {
    let frames = frames(&Q);
    for frame in &frames {
        for i in 0..3 {
            for j in 0..3 {
                close(dot(&frame[i][..3], &frame[j][..3]), f64::from(u8::from(i == j)), 1.0);
            }
        }
        let [x, y, z] = frame;
        let cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
        close(dot(&cross, &z[..3]), 1.0, 1.0);
    }
    let last = forward_kinematics(&Q);
    for i in 0..3 {
        for j in 0..4 {
            close(frames[ROWS - 1][i][j], last[i][j], last[i][j].abs());
        }
    }
}

#[test]
fn jacobians_are_the_differences_of_their_frames() {
    let check = |jacobian: [[f64; DOF]; 6], pose: fn(&[f64; DOF]) -> [[f64; 4]; 3]| {
        let found = velocity(&pose(&Q), &pose(&moved(&Q, -STEP, &DQ)), &pose(&moved(&Q, STEP, &DQ)));
        for i in 0..6 {
            near(dot(&jacobian[i], &DQ), found[i], largest(&found));
        }
    };
    check(jacobian(&Q), forward_kinematics);
    check(tool_jacobian(&Q), tool_pose);
    let rate = jacobian_dot_velocity(&Q, &DQ);
    let [before, after] = [-STEP, STEP].map(|t| jacobian(&moved(&Q, t, &DQ)));
    for i in 0..6 {
        near(rate[i], (dot(&after[i], &DQ) - dot(&before[i], &DQ)) / (2.0 * STEP), largest(&rate));
    }
}

#[test]
fn postures_reach_their_pose() {
    let pose = forward_kinematics(&Q);
    let query = ik::Query { redundancy: IK.redundancy(&Q, &ik::Reference::UP), near: Some(&Q), ..Default::default() };
    let found = inverse_kinematics(&pose, &query).unwrap();
    assert!(!found.as_slice().is_empty());
    for posture in found.as_slice() {
        let reached = forward_kinematics(&posture.q);
        for i in 0..3 {
            for j in 0..4 {
                assert!((reached[i][j] - pose[i][j]).abs() < 1e-9, "{:?}", posture.branch);
            }
        }
    }
    let pose = tool_pose(&Q);
    let found = tool_inverse_kinematics(&pose, &query).unwrap();
    assert!(!found.as_slice().is_empty());
    for posture in found.as_slice() {
        let reached = tool_pose(&posture.q);
        for (a, b) in reached.as_flattened().iter().zip(pose.as_flattened()) {
            assert!((a - b).abs() < 1e-9, "{:?}", posture.branch);
        }
    }
}

#[test]
fn velocities_are_those_of_the_jacobian() {
    let (arm, jacobian) = (IK.with_tool(&TOOL), tool_jacobian(&Q));
    let twist: [f64; 6] = core::array::from_fn(|i| dot(&jacobian[i], &DQ));
    let found = arm.velocities(&Q, &twist, &ik::Differential { near: 0.0, ..Default::default() });
    assert!(found.left[0] + found.left[1] < 1e-5 * largest(&twist), "{:?}", found.left);
    for i in 0..6 {
        near(dot(&arm.jacobian(&Q)[i], &DQ), twist[i], largest(&twist));
    }
}

#[test]
fn the_check_vector_comes_out_bit_for_bit() {
    assert_eq!(inverse_dynamics(&Q, &DQ, &DDQ, &PHI), TAU);
}

#[test]
fn regressor_times_parameters_is_inverse_dynamics() {
    let tau = product(&regressor(&Q, &DQ, &DDQ), &PHI);
    let beta = base_parameters(&PHI);
    let from_base = product(&base_regressor(&Q, &DQ, &DDQ), &beta);
    let direct = inverse_dynamics_base(&Q, &DQ, &DDQ, &beta);
    let size = largest(&TAU);
    for i in 0..DOF {
        close(tau[i], TAU[i], size);
        close(from_base[i], TAU[i], size);
        close(direct[i], TAU[i], size);
    }
}

#[test]
fn the_mass_matrix_is_symmetric_and_fits_the_torques() {
    let beta = base_parameters(&PHI);
    let mass = mass_matrix(&Q, &beta);
    let still = inverse_dynamics_base(&Q, &DQ, &[0.0; DOF], &beta);
    let size = largest(&TAU);
    for i in 0..DOF {
        for j in 0..DOF {
            assert_eq!(mass[i][j], mass[j][i]);
        }
        close(dot(&mass[i], &DDQ) + still[i], TAU[i], size);
    }
}

#[test]
fn at_rest_there_is_only_gravity() {
    let beta = base_parameters(&PHI);
    let g = gravity(&Q, &beta);
    let w = gravity_regressor(&Q);
    for i in 0..DOF {
        close(dot(&w[i], &PHI[..10 * ROWS]), g[i], 10.0);
    }
}

/// Parameters of which those whose names begin with one of `words` are replaced.
fn with(phi: [f64; STANDARD], words: &[&str], value: f64) -> [f64; STANDARD] {
    core::array::from_fn(|k| if words.iter().any(|w| STANDARD_NAMES[k].starts_with(w)) { value } else { phi[k] })
}

#[test]
fn powers_are_the_rates_of_the_energies() {
    let phi = with(PHI, &["FV", "FC"], 0.0);
    let energy = |q: &[f64; DOF], dq: &[f64; DOF]| {
        dot(&kinetic_energy_regressor(q, dq), &phi) + dot(&potential_energy_regressor(q), &phi)
    };
    let at = |t: f64| energy(&moved(&Q, t, &DQ), &moved(&DQ, t, &DDQ));
    let power = dot(&inverse_dynamics(&Q, &DQ, &DDQ, &phi), &DQ);
    near((at(STEP) - at(-STEP)) / (2.0 * STEP), power, at(0.0).abs() + power.abs());
}

#[test]
fn forward_dynamics_undoes_inverse_dynamics() {
    // Bodies that can exist, so that the mass matrix is positive definite.
    let phi = with(with([0.0; STANDARD], &["M", "IA"], 1.0), &["MS"], 0.1);
    let phi = with(with(phi, &["XX", "YY", "ZZ"], 0.3), &["FV", "FC", "FO"], 0.2);
    let beta = base_parameters(&phi);
    let tau = inverse_dynamics_base(&Q, &DQ, &DDQ, &beta);
    let found = forward_dynamics(&Q, &DQ, &tau, &beta);
    let size: Vec<f64> = mass_matrix(&Q, &beta).iter().map(|row| largest(row)).collect();
    for k in 0..DOF {
        assert!((found[k] - DDQ[k]).abs() < 1e-9 * (1.0 + largest(&size)), "{} is not {}", found[k], DDQ[k]);
    }
}
