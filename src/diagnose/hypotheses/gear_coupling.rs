//! `gear_coupling`: one motor moves another joint's axis, as in wrists with drives on concentric
//! shafts.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Hypothesis;
use super::Kind;
use super::Law;
use super::Scope;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::moves;
use crate::diagnose::windows::windowed_data::{Column, WindowedData};
use crate::model::coupled::CouplingTerm;

/// Largest turn of a joint's axis per turn of another motor.
const MOST_TURNS: f64 = 3.0;

/// Motor `m` turns with `dq_m + KC dq_k`: see the table of effects. `place` is `[m, k]`.
pub struct GearCoupling;

impl Hypothesis for GearCoupling {
    fn effect(&self) -> EffectKind {
        EffectKind::GearCoupling
    }

    fn kind(&self) -> Kind {
        Kind::Transmission
    }

    fn in_the_drive(&self) -> bool {
        true
    }

    fn scope(&self) -> Scope {
        Scope::Pair
    }

    fn shape(&self) -> &'static [Shape] {
        &[
            Shape { symbol: Symbol::Key(effects::GearCoupling::KC), unit: "", range: [-3.0, 3.0], step: None },
            Shape { symbol: Symbol::Own("parts"), unit: "", range: [1.0, 7.0], step: None },
        ]
    }

    /// All combinations of its terms: those that come out negative are dropped, since no rotor
    /// inertia and no friction is negative.
    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        [1.0, -1.0].into_iter().flat_map(|ratio| (1..8).map(move |parts| vec![ratio, f64::from(parts)])).collect()
    }

    /// Laws with fewer of these terms.
    fn simpler(&self, _: &WindowedData<'_>, _: &[usize], shape: &[f64]) -> Vec<Law> {
        let parts = shape[1] as u32;
        let with = |count: u32| {
            let fewer = (1..parts).filter(|p| p & parts == *p && p.count_ones() == count);
            (&Self as &'static dyn Hypothesis, fewer.map(|p| vec![shape[0], f64::from(p)]).collect())
        };
        (1..parts.count_ones()).map(with).collect()
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
            Column::new(vec![
                (k.min(m), series(k.min(m), if k < m { on_k } else { on_m })),
                (k.max(m), series(k.max(m), if k < m { on_m } else { on_k })),
            ])
        };
        let (own_m, own_k) = (&scene.own[m], &scene.own[k]);
        let sum = |i: usize, s: usize| own_m[i].v[s] + ratio * own_k[i].v[s];
        let dead = scene.velocity_noise_limit[m].max(scene.velocity_noise_limit[k]);
        let sign = |i: usize, s: usize| if sum(i, s).abs() > dead { sum(i, s).signum() } else { 0.0 };
        let parts = shape[1] as usize;
        let column = |term: CouplingTerm| match term {
            CouplingTerm::IAM => both(&|i, s| ratio * own_m[i].a[s], &|i, s| ratio * own_k[i].a[s]),
            CouplingTerm::FVM => both(&|i, s| ratio * own_m[i].v[s], &|i, s| ratio * own_k[i].v[s]),
            CouplingTerm::FCM => both(&|i, s| ratio * sign(i, s), &|i, s| sign(i, s)),
        };
        let used = CouplingTerm::ALL.into_iter().filter(|term| parts >> *term as usize & 1 == 1);
        used.map(|term| Term::new(term.key(), column(term), Sign::Positive)).collect()
    }

    fn says(&self) -> &'static str {
        "one motor's inertia and friction act on two joints"
    }

    fn shown_by(&self) -> &'static str {
        "each of the two joints moved alone, then both together"
    }
}

/// The link of joint m is at `q_m + CQ q_k`: the gear of joint k carries it along, and motor k
/// bears `CQ` times its torque. `place` is `[m, k]`.
pub struct CarriedAxis;

impl Hypothesis for CarriedAxis {
    fn effect(&self) -> EffectKind {
        EffectKind::GearCoupling
    }

    fn kind(&self) -> Kind {
        Kind::Transmission
    }

    fn in_the_drive(&self) -> bool {
        true
    }

    fn scope(&self) -> Scope {
        Scope::Pair
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: Symbol::Own("step"), unit: "", range: [-MOST_TURNS, MOST_TURNS], step: None }]
    }

    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        [0.02, 0.9, -0.9].iter().map(|c| vec![*c]).collect()
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        moves(scene, place[1])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (m, k, ratio) = (place[0], place[1], shape[0]);
        if ratio == 0.0 || scene.rigid[m].iter().all(|t| *t == 0.0) {
            return Vec::new();
        }
        let states = &scene.states[scene.state_of_joint[m]];
        let by = states.by_joint()[k].map(<[f64]>::to_vec);
        let mut rows = scene.moved(m, &by, ratio);
        // Motor m does not move: its rotor is not affected by the change.
        rows[m].iter_mut().zip(&by[2]).for_each(|(t, a)| *t -= scene.rotors[m] * a);
        let borne: Vec<f64> = scene.transmitted(m).iter().zip(&rows[m]).map(|(t, more)| t + ratio * more).collect();
        rows[k].iter_mut().zip(&borne).for_each(|(t, borne)| *t += borne);
        vec![Term::new(effects::GearCoupling::CQ, scene.column(rows), Sign::Any)]
    }

    fn plausible(&self, _: &WindowedData<'_>, _: &[usize], _: &[f64], x: &[f64]) -> bool {
        x.iter().all(|x| x.abs() <= MOST_TURNS)
    }

    fn finite_difference(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "the axis turns with another joint's motor, which bears a part of its torque"
    }

    fn shown_by(&self) -> &'static str {
        GearCoupling.shown_by()
    }
}
