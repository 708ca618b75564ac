//! Velocities within limits, and what small steps reach.

use denavit_runtime_core::ik::{Arm, Axis, Differential, Displacement, Family, Query};

struct Random(u64);

impl Random {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// Any lines; the third joint slides.
    fn arm<const N: usize>(&mut self) -> Arm<N> {
        let axes = core::array::from_fn(|k| {
            let h = [0; 3].map(|_| self.uniform(-1.0, 1.0));
            let n = h.iter().map(|x| x * x).sum::<f64>().sqrt();
            Axis { slides: k == 2, h: h.map(|x| x / n), c: [0; 3].map(|_| self.uniform(-0.5, 0.5)) }
        });
        let home = Displacement { shift: [0.3, -0.2, 0.6], ..Displacement::NONE };
        Arm { axes, home, limits: [Some([-2.0, 2.0]); N], exact: false, family: Family::Numerical }
    }

    fn within<const N: usize>(&mut self, size: f64) -> [f64; N] {
        core::array::from_fn(|_| self.uniform(-size, size))
    }
}

/// Columns by central differences of the forward kinematics.
#[test]
fn the_jacobian_is_the_derivative_of_the_pose() {
    let mut random = Random(1);
    let arm: Arm<7> = random.arm();
    let tool = Displacement { rotation: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.1, 0.2, 0.3] };
    for arm in [arm, arm.with_tool(&tool)] {
        let q = random.within::<7>(1.0);
        let (jacobian, here) = (arm.jacobian(&q), arm.forward(&q));
        for k in 0..7 {
            let at = |d: f64| {
                let mut q = q;
                q[k] += d;
                arm.forward(&q)
            };
            let (on, off) = (at(1e-6), at(-1e-6));
            let rate = |i: usize, j: usize| (on[i][j] - off[i][j]) / 2e-6;
            let spin = |a: usize, b: usize| (0..3).map(|j| rate(a, j) * here[b][j]).sum::<f64>();
            let expected = [rate(0, 3), rate(1, 3), rate(2, 3), spin(2, 1), spin(0, 2), spin(1, 0)];
            for i in 0..6 {
                assert!((jacobian[i][k] - expected[i]).abs() < 1e-8, "{i} {k}");
            }
        }
    }
}

/// The tool's pose is the last frame's, followed by the tool.
#[test]
fn a_tool_is_carried_along() {
    let mut random = Random(2);
    let arm: Arm<6> = random.arm();
    let tool = Displacement { rotation: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.1, 0.2, 0.3] };
    let q = random.within::<6>(1.5);
    let expected = Displacement::from_rows(&arm.forward(&q)).after(&tool);
    let found = Displacement::from_rows(&arm.with_tool(&tool).forward(&q));
    for i in 0..3 {
        assert!((expected.shift[i] - found.shift[i]).abs() < 1e-14);
        for j in 0..3 {
            assert!((expected.rotation[i][j] - found.rotation[i][j]).abs() < 1e-14);
        }
    }
}

#[test]
fn free_velocities_make_the_twist_and_bounded_ones_keep_every_bound() {
    let mut random = Random(3);
    let (mut exact, mut limited) = (0, 0);
    for _ in 0..300 {
        let arm: Arm<7> = random.arm();
        let (q, twist) = (random.within::<7>(1.99), random.within::<6>(1.0));
        let free = arm.velocities(&q, &twist, &Differential { near: 0.0, ..Differential::default() });
        assert!(free.left[0] + free.left[1] < 1e-6 && free.limited == 0, "{:?}", free.left);
        let options = Differential {
            speeds: core::array::from_fn(|_| Some(random.uniform(0.0, 1.0))),
            hold: 0.05,
            preferred: random.within::<7>(1.0),
            near: 0.0,
            ..Differential::default()
        };
        let found = arm.velocities(&q, &twist, &options);
        for k in 0..7 {
            assert!(found.dq[k].abs() <= options.speeds[k].unwrap());
            assert!((q[k] + 0.05 * found.dq[k]).abs() <= 2.0 + 1e-15);
        }
        exact += usize::from(found.left[0] + found.left[1] < 1e-6);
        limited += usize::from(found.limited != 0);
        // Nothing within the bounds is better: a step along any one joint, or any two, is none.
        let cost = |dq: &[f64; 7]| {
            let jacobian = arm.jacobian(&q);
            jacobian
                .iter()
                .zip(twist)
                .map(|(row, t)| (row.iter().zip(dq).map(|(j, d)| j * d).sum::<f64>() - t).powi(2))
                .sum::<f64>()
        };
        for _ in 0..60 {
            let way = random.within::<7>(1.0);
            for step in [1e-2, 1e-4] {
                let other: [f64; 7] = core::array::from_fn(|k| {
                    let speed = options.speeds[k].unwrap();
                    let (low, high) = ((-2.0 - q[k]) / 0.05, (2.0 - q[k]) / 0.05);
                    (found.dq[k] + step * way[k]).clamp(-speed, speed).clamp(low, high)
                });
                assert!(cost(&other) > cost(&found.dq) - 1e-12);
            }
        }
    }
    assert!(limited > 200 && exact > 0 && exact < 200, "{exact} {limited}");
}

/// At a singularity the damping bounds the speeds.
#[test]
fn speeds_stay_bounded_at_a_singularity() {
    let axis = |h, c| Axis { slides: false, h, c };
    let (x, z) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    // A planar arm of two links, stretched.
    let arm = Arm {
        axes: [axis(z, [0.0; 3]), axis(z, x)],
        home: Displacement { shift: [2.0, 0.0, 0.0], ..Displacement::NONE },
        limits: [None; 2],
        exact: false,
        family: Family::Numerical,
    };
    let mut last = 0.0f64;
    for bend in [1e-1, 1e-2, 1e-3, 1e-6, 0.0] {
        let found = arm.velocities(&[0.0, bend], &[-1.0, 0.0, 0.0, 0.0, 0.0, 0.0], &Differential::default());
        let speed = found.dq.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!(speed < 1.0 / (2.0 * 0.03), "{bend} {speed}");
        last = speed;
    }
    assert!(last < 1e-9);
}

#[test]
fn small_steps_reach_the_pose_and_keep_the_limits() {
    let mut random = Random(5);
    let mut reached = 0;
    for _ in 0..200 {
        let arm: Arm<7> = random.arm();
        let start = random.within::<7>(1.6);
        let q: [f64; 7] = core::array::from_fn(|k| (start[k] + random.uniform(-0.4, 0.4)).clamp(-2.0, 2.0));
        let pose = arm.forward(&q);
        let Some(found) = arm.approach(&pose, &start, 1e-12, &Differential::default()).unwrap() else { continue };
        reached += 1;
        assert!(found.q.iter().all(|x| x.abs() <= 2.0) && found.within_limits);
        for (a, b) in arm.forward(&found.q).as_flattened().iter().zip(pose.as_flattened()) {
            assert!((a - b).abs() < 1e-11);
        }
        // Of a redundant arm hardly farther than the posture that made the pose.
        let far = |a: &[f64; 7], b: &[f64; 7]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        assert!(far(&found.q, &start) < 1.6 * far(&q, &start) + 1e-9, "{} {}", far(&found.q, &start), far(&q, &start));
    }
    assert!(reached > 180, "{reached}");
}

/// Single precision: the pose of a posture, rounded, leads back to it.
#[test]
fn single_precision_costs_its_digits_alone() {
    let mut random = Random(7);
    let arm: Arm<6> = random.arm();
    let mut most = 0.0f64;
    for _ in 0..20 {
        let q = random.within::<6>(1.5).map(|x| x as f32);
        let pose = arm.forward(&q.map(f64::from)).map(|row| row.map(|x| x as f32));
        let query = Query { near: Some(&q.map(f64::from)), ..Query::default() };
        let found = arm.solve_f32(&pose, &query).unwrap();
        let again = arm.forward(&found.as_slice()[0].q_f32().map(f64::from));
        for (a, b) in again.as_flattened().iter().zip(pose.as_flattened()) {
            most = most.max((a - f64::from(*b)).abs());
        }
    }
    assert!(most < 2e-6, "{most}");
}
