//! Tests with a prismatic joint and its drive: the SCARA arm.

use super::*;
use crate::data::log::Quantity;
use crate::identify::tool::shape::{Assembly, Axis};

/// The links of the file are the solids named in its comment.
#[test]
fn scara_links_are_the_solids_of_its_comment() {
    let (l1, l2) = (0.325, 0.275);
    let solids = [
        Assembly::new().cuboid(6.0, [0.44, 0.12, 0.08], [l1 / 2.0, 0.0, 0.0]).tube(
            3.0,
            [0.04, 0.0],
            0.15,
            Axis::Z,
            [l1, 0.0, 0.08],
        ),
        Assembly::new().cuboid(5.0, [0.40, 0.12, 0.10], [l2 / 2.0, 0.0, 0.08]).cuboid(
            3.0,
            [0.12, 0.09, 0.12],
            [0.10, 0.0, 0.19],
        ),
        Assembly::new().cuboid(1.0, [0.08, 0.06, 0.05], [0.0, 0.0, -0.35]),
        Assembly::new().tube(1.0, [0.01, 0.0], 0.40, Axis::Z, [0.0, 0.0, -0.20]),
    ];
    let scara = robot("scara");
    for (link, solid) in scara.links.iter().zip(&solids) {
        let link = link.as_ref().unwrap().to_array();
        for (a, b) in link.iter().zip(solid.inertia.to_array()) {
            assert!((a - b).abs() < 1e-11, "{link:?} {solid:?}");
        }
    }
}

/// The prismatic joint carries carriage and quill, 2 kg, whatever the arm does: F = M (a - g), with
/// z pointing down. The recorded force is the one that the motion requires: at rest -19.62 N.
#[test]
fn a_stroke_carries_its_weight() {
    let scara = robot("scara");
    let step = 0.002;
    let t: Vec<f64> = (0..=1000).map(|k| f64::from(k) * step).collect();
    let angle = |t: f64| (std::f64::consts::PI * t / 2.0).sin().powi(4);
    let stroke = |t: f64| 0.1 + 0.08 * (std::f64::consts::PI * t).sin().powi(3);
    let mut q: Vec<f64> = Vec::new();
    q.extend(t.iter().map(|&t| 0.8 * angle(t)));
    q.extend(t.iter().map(|&t| -1.1 * angle(t)));
    q.extend(t.iter().map(|&t| stroke(t)));
    q.extend(t.iter().map(|&t| 2.0 * angle(t)));
    let motion = Trajectory::new(4, t, q, None, None).unwrap();
    for request in [exact(1000.0), loop_at(1000.0)] {
        let recording = run(&scara, &Effects::default(), &motion, &request);
        let log = &recording.log;
        let force = log.joint(Quantity::Tau, 2).unwrap();
        let second = |t: f64| {
            let h = 1e-4;
            (stroke(t + h) - 2.0 * stroke(t) + stroke(t - h)) / (h * h)
        };
        // Skips the transient of the loop, which starts from rest.
        for (t, force) in recording.truth.t.iter().zip(force).skip(50) {
            if *t > 0.05 && *t < 1.95 {
                let due = 2.0 * (second(*t) - 9.81);
                assert!((force - due).abs() < 0.05, "at {t} s: {force} N where {due} N are due");
            }
        }
    }
}

/// On a prismatic joint, friction is in N and N s/m and a spring in N/m.
#[test]
fn effects_of_a_stroke_are_forces() {
    let scara = robot("scara");
    let motion = motion(4, 0.05, 2.0);
    let plain = run(&scara, &Effects::default(), &motion, &exact(1000.0));
    let spring = at_joint(2, "joint_spring", &[("KS", 100.0), ("QS", 0.1)]);
    let sprung = run(&scara, &spring, &motion, &exact(1000.0));
    let column = |r: &Recording, quantity| r.log.joint(quantity, 2).unwrap().to_vec();
    let (q, a) = (column(&plain, Quantity::Q), column(&plain, Quantity::Tau));
    for ((q, a), b) in q.iter().zip(&a).zip(&column(&sprung, Quantity::Tau)) {
        assert!((b - a - 100.0 * (q - 0.1)).abs() < 1e-6, "{q}: {a} {b}");
    }
}
