//! Seven turning joints in general position: one is locked, six by elimination.

use denavit_runtime_core::ik::{Arm, Axis, CHOICES, Differential, Displacement, Family, General, NO_CHOICE, Query};

struct Random(u64);

impl Random {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// Limits of 100 degrees to either side.
    fn arm(&mut self, locked: usize) -> Arm<7> {
        let axes: [Axis; 7] = core::array::from_fn(|_| {
            let h = [0; 3].map(|_| self.uniform(-1.0, 1.0));
            let n = h.iter().map(|x| x * x).sum::<f64>().sqrt();
            Axis { slides: false, h: h.map(|x| x / n), c: [0; 3].map(|_| self.uniform(-0.5, 0.5)) }
        });
        let joints: [u8; 6] = core::array::from_fn(|k| (k + usize::from(k >= locked)) as u8);
        let six = joints.map(|k| axes[usize::from(k)]);
        let mut general = General { axes: six, joints, locked: None, size: 1.0, order: [NO_CHOICE; CHOICES] };
        let trial = [0.3, -0.7, 1.1, 0.4, -1.3, 0.9];
        let good: Vec<u8> = (0..12).filter(|choice| general.trial(&trial, *choice).is_some()).collect();
        for (place, choice) in general.order.iter_mut().zip(good) {
            *place = choice;
        }
        general.locked = Some(locked as u8);
        let home = Displacement { shift: [0.3, -0.2, 0.6], ..Displacement::NONE };
        Arm { axes, home, limits: [Some([-1.75, 1.75]); 7], exact: true, family: Family::General(general) }
    }

    fn posture(&mut self, size: f64) -> [f64; 7] {
        core::array::from_fn(|_| self.uniform(-size, size))
    }
}

/// Wherever the locked joint is, the posture that made the pose is found, and the joint stays there.
#[test]
fn any_joint_can_be_locked() {
    let mut random = Random(6);
    for locked in 0..7 {
        let arm = random.arm(locked);
        for _ in 0..10 {
            let q = random.posture(1.6);
            let pose = arm.forward(&q);
            let found = arm.solve(&pose, &Query { redundancy: q[locked], ..Query::default() }).unwrap();
            assert!(found.uncertain || found.as_slice().len().is_multiple_of(2), "{locked} {q:?}");
            let far = |s: &[f64; 7]| s.iter().zip(q).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            assert!(found.as_slice().iter().any(|s| far(&s.q) < 1e-6), "{locked} {q:?}");
            for s in found.as_slice() {
                assert!((s.q[locked] - q[locked]).abs() < 1e-12);
                for (a, b) in arm.forward(&s.q).as_flattened().iter().zip(pose.as_flattened()) {
                    assert!((a - b).abs() < 1e-11, "{locked} {q:?}");
                }
            }
        }
    }
}

/// Axes of a calibrated arm are near those of the closed form alone: postures are refined, and the
/// locked joint stays where it was asked for.
#[test]
fn a_calibrated_arm_keeps_the_locked_joint() {
    let mut random = Random(9);
    let mut own = 0;
    for locked in 0..7 {
        let mut arm = random.arm(locked);
        for axis in &mut arm.axes {
            let h = axis.h.map(|x| x + random.uniform(-1e-3, 1e-3));
            let n = h.iter().map(|x| x * x).sum::<f64>().sqrt();
            (axis.h, axis.c) = (h.map(|x| x / n), axis.c.map(|x| x + random.uniform(-1e-3, 1e-3)));
        }
        arm.exact = false;
        for _ in 0..10 {
            let q = random.posture(1.6);
            let pose = arm.forward(&q);
            let found = arm.solve(&pose, &Query { redundancy: q[locked], ..Query::default() }).unwrap();
            let far = |s: &[f64; 7]| s.iter().zip(q).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            own += usize::from(found.as_slice().iter().any(|s| far(&s.q) < 1e-6));
            for s in found.as_slice() {
                assert!((s.q[locked] - q[locked]).abs() < 1e-9, "{locked} {q:?} {:?}", s.q);
            }
        }
    }
    assert!(own >= 60, "{own} of 70");
}

/// Without limits each joint comes out with the whole turns of the posture that is near.
#[test]
fn turns_are_those_of_the_near_posture() {
    let mut random = Random(12);
    let mut arm = random.arm(3);
    arm.limits = [None; 7];
    for _ in 0..10 {
        let q = random.posture(1.6);
        let mut near = q;
        for (x, turns) in near.iter_mut().zip([1.0, -1.0, 0.0, 1.0, -2.0, 2.0, -1.0]) {
            *x += std::f64::consts::TAU * turns;
        }
        let query = Query { redundancy: q[3], near: Some(&near), ..Query::default() };
        let found = arm.solve(&arm.forward(&q), &query).unwrap();
        let far = |s: &[f64; 7]| s.iter().zip(near).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
        assert!(found.as_slice().iter().any(|s| far(&s.q) < 1e-6), "{q:?}");
    }
}

/// Against postures at 500 positions: allowed is what lies in a range, but for what is nearer to an
/// end than the limits can be told apart, and narrow ones.
#[test]
fn ranges_of_the_locked_joint_agree_with_a_scan() {
    let mut random = Random(1);
    let (mut looked, mut allowed, mut wrong) = (0, 0, 0);
    for _ in 0..4 {
        let arm = random.arm(6);
        for _ in 0..3 {
            let q = random.posture(1.6);
            let pose = arm.forward(&q);
            let ranges = arm.locked_ranges(&pose).unwrap().unwrap();
            assert!(ranges.list.iter().any(|[from, to]| *from <= q[6] && q[6] <= *to), "{q:?}");
            let (best, margin) = ranges.best.unwrap();
            let mut most = f64::NEG_INFINITY;
            for k in 0..500 {
                let at = -1.75 + 3.5 * (f64::from(k) + 0.5) / 500.0;
                let found = arm.solve(&pose, &Query { redundancy: at, ..Query::default() }).unwrap();
                let own = found.safest().map_or(f64::NEG_INFINITY, |s| s.margin);
                most = most.max(own);
                let inside = ranges.list.iter().any(|[from, to]| *from <= at && at <= *to);
                looked += 1;
                allowed += usize::from(own >= 0.0);
                wrong += usize::from(inside != (own >= 0.0));
            }
            assert!(margin > most - 5e-3, "{best} {margin} {most}");
            let there = arm.solve(&pose, &Query { redundancy: best, ..Query::default() }).unwrap();
            assert!((there.safest().unwrap().margin - margin).abs() < 1e-9);
        }
    }
    assert!(allowed > looked / 20 && allowed < looked && wrong * 200 <= looked, "{wrong} {allowed} of {looked}");
}

/// Along a line, the posture moves on without a jump, reaches every pose, and its redundancy is its
/// own: elimination at that position of the locked joint finds it again.
#[test]
fn a_path_is_followed_without_jumps() {
    let mut random = Random(4);
    let mut followed = 0;
    for _ in 0..10 {
        let arm = random.arm(6);
        let start = random.posture(1.0);
        let mut q = start;
        for k in 1..=40 {
            let mut pose = arm.forward(&start);
            for (row, way) in pose.iter_mut().zip([0.05, -0.04, 0.03]) {
                row[3] += way * f64::from(k) / 40.0;
            }
            let Some(next) = arm.approach(&pose, &q, 1e-12, &Differential::default()).unwrap() else { break };
            assert!(next.within_limits);
            let most = next.q.iter().zip(q).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            assert!(most < 0.2, "{most}");
            let query = Query { redundancy: next.q[6], near: Some(&next.q), ..Query::default() };
            let found = arm.solve(&pose, &query).unwrap();
            assert!(found.as_slice()[0].q.iter().zip(next.q).all(|(a, b)| (a - b).abs() < 1e-6));
            q = next.q;
            followed += 1;
        }
    }
    assert!(followed > 300, "{followed}");
}
