//! `gear_coupling`: one motor moves another joint's axis, as in wrists whose drives pass through
//! each other.

use dh_codegen::robot::EffectKind;

use super::Cause;
use super::Kind;
use super::Scope;
use super::Shape;
use super::Sign;
use super::Term;
use super::moves;
use crate::diagnose::windowed_data::{Column, WindowedData};

/// Motor `m` turns with `dq_m + KC dq_k`: see the table of effects. `place` is `[m, k]`.
pub struct GearCoupling;

impl Cause for GearCoupling {
    fn effect(&self) -> EffectKind {
        EffectKind::GearCoupling
    }

    fn kind(&self) -> Kind {
        Kind::Transmission
    }

    fn scope(&self) -> Scope {
        Scope::Pair
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: "KC", unit: "", range: [-3.0, 3.0], step: None }]
    }

    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        vec![vec![1.0], vec![-1.0]]
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        place.iter().all(|j| moves(scene, *j))
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (m, k, ratio) = (place[0], place[1], shape[0]);
        let both = |on_k: &dyn Fn(usize, usize) -> f64, on_m: &dyn Fn(usize, usize) -> f64| -> Column {
            // `on_k` is evaluated with the motor's own state, `on_m` with the other joint's.
            let series = |joint: usize, f: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
                let mut out = Vec::with_capacity(scene.len);
                for (stretch, own) in scene.own[joint].iter().enumerate() {
                    out.extend(scene.average_of(own, |s| f(stretch, s)));
                }
                scene.masked(joint, &mut out);
                out
            };
            Column {
                rows: vec![
                    (k.min(m), series(k.min(m), if k < m { on_k } else { on_m })),
                    (k.max(m), series(k.max(m), if k < m { on_m } else { on_k })),
                ],
            }
        };
        let (own_m, own_k) = (&scene.own[m], &scene.own[k]);
        let sum = |i: usize, s: usize| own_m[i].v[s] + ratio * own_k[i].v[s];
        let dead = scene.dead[m].max(scene.dead[k]);
        let sign = |i: usize, s: usize| if sum(i, s).abs() > dead { sum(i, s).signum() } else { 0.0 };
        vec![
            Term::new("IAM", both(&|i, s| ratio * own_m[i].a[s], &|i, s| ratio * own_k[i].a[s]), Sign::Any),
            Term::new("FVM", both(&|i, s| ratio * own_m[i].v[s], &|i, s| ratio * own_k[i].v[s]), Sign::Any),
            Term::new("FCM", both(&|i, s| ratio * sign(i, s), &|i, s| sign(i, s)), Sign::Any),
        ]
    }

    fn says(&self) -> &'static str {
        "one motor's inertia and friction act on two joints"
    }

    fn shown_by(&self) -> &'static str {
        "each of the two joints moved alone, then both together"
    }
}
