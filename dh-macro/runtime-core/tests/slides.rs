//! Six joints in general position, of which up to three slide: every order of them.

use core::f64::consts::{PI, TAU};

use denavit_runtime_core::ik::{Arm, Axis, CHOICES, Displacement, Family, General, NO_CHOICE, Query, Solutions};

struct Random(u64);

impl Random {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// Any lines; bit `k`: joint `k` slides.
    fn arm(&mut self, slides: u32) -> Arm<6> {
        let axes = core::array::from_fn(|k| {
            let h = [0; 3].map(|_| self.uniform(-1.0, 1.0));
            let n = h.iter().map(|x| x * x).sum::<f64>().sqrt();
            let c = [0; 3].map(|_| self.uniform(-0.5, 0.5));
            Axis { slides: slides >> k & 1 == 1, h: h.map(|x| x / n), c }
        });
        let order = [NO_CHOICE; CHOICES];
        let mut general = General { axes, joints: [0, 1, 2, 3, 4, 5], locked: None, size: 1.0, order };
        let trial = [0.3, -0.7, 0.8, 0.4, -0.6, 0.9];
        let good: Vec<u8> = (0..12).filter(|choice| general.trial(&trial, *choice).is_some()).collect();
        assert!(!good.is_empty(), "{slides:06b}");
        for (place, choice) in general.order.iter_mut().zip(good) {
            *place = choice;
        }
        let home = Displacement { shift: [0.3, -0.2, 0.6], ..Displacement::NONE };
        Arm { axes, home, limits: [None; 6], exact: true, family: Family::General(general) }
    }

    fn posture(&mut self, arm: &Arm<6>) -> [f64; 6] {
        arm.axes.map(|a| if a.slides { self.uniform(-1.0, 1.0) } else { self.uniform(-PI, PI) })
    }
}

/// Largest difference of a joint, whole turns apart.
fn far(arm: &Arm<6>, a: &[f64; 6], b: &[f64; 6]) -> f64 {
    (0..6).fold(0.0, |m: f64, k| {
        let d = a[k] - b[k];
        m.max(if arm.axes[k].slides { d } else { d - TAU * (d / TAU).round() }.abs())
    })
}

fn marked(found: &Solutions<6>) -> bool {
    found.uncertain || found.lost > 0
}

#[test]
fn postures_are_found_and_what_is_odd_is_marked() {
    let (mut poses, mut doubtful) = (0, 0);
    for slides in (0u32..64).filter(|bits| bits.count_ones() <= 3) {
        let mut random = Random(u64::from(slides) + 1);
        let arm = random.arm(slides);
        for _ in 0..40 {
            let q = random.posture(&arm);
            let pose = arm.forward(&q);
            let found = arm.solve(&pose, &Query::default()).unwrap();
            poses += 1;
            doubtful += usize::from(marked(&found));
            let own = found.as_slice().iter().any(|s| far(&arm, &s.q, &q) < 1e-6);
            assert!(own || marked(&found), "{slides:06b} {q:?}");
            assert!(found.as_slice().len().is_multiple_of(2) || marked(&found), "{slides:06b} {q:?}");
            let most = [16, 16, 8, 2][slides.count_ones() as usize];
            assert!(found.as_slice().len() <= most || marked(&found), "{slides:06b} {q:?}");
            for s in found.as_slice() {
                // What rounding leaves grows with the ways.
                let long = |m: f64, (q, a): (&f64, &Axis)| if a.slides { m.max(q.abs()) } else { m };
                let size = s.q.iter().zip(&arm.axes).fold(1.0, long);
                for (a, b) in arm.forward(&s.q).as_flattened().iter().zip(pose.as_flattened()) {
                    assert!((a - b).abs() < 1e-11 * size, "{slides:06b} {q:?}");
                }
            }
        }
    }
    assert!(doubtful * 50 <= poses, "{doubtful} of {poses}");
}
