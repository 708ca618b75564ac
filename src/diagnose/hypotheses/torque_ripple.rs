//! `torque_ripple`: torque periodic in the joint or motor angle.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Hypothesis;
use super::Kind;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::moves;
use super::nearly_one_order;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::numerics::periodogram::{Orders, Sample, periodogram};

/// `RC cos(RN q) + RS sin(RN q)`.
pub struct TorqueRipple;

/// Orders of the peaks in the residual's periodogram over the angle, highest first.
fn peaks(scene: &WindowedData<'_>, j: usize, residual: &[f64]) -> Vec<f64> {
    let [low, high] = scene.travel[j];
    let range = (high - low).max(0.05);
    let q: Vec<f64> = scene.own_series(j, |o| o.q.to_vec());
    let v: Vec<f64> = scene.own_series(j, |o| o.v.to_vec());
    let used: Vec<usize> = (0..scene.len).filter(|&w| scene.live[j][w]).collect();
    // Above this order, most windows contain more than a period.
    let mut speeds: Vec<f64> = used.iter().map(|&w| v[w].abs()).collect();
    speeds.sort_by(f64::total_cmp);
    let typical = speeds.get(speeds.len() / 3).copied().unwrap_or(0.0).max(1e-3);
    let most = (2.0 / (typical * scene.step)).min(1200.0);
    let step = 0.7 / range;
    let first = (9.5 / range).max(1.0);
    let count = (((most - first) / step).max(0.0) as usize).min(6000);
    let sample = |&w: &usize| Sample { value: residual[w], angle: q[w], half: 0.5 * v[w] * scene.step };
    let orders = Orders { first, step, count };
    let power = periodogram(&used.iter().map(sample).collect::<Vec<Sample>>(), &orders);
    // Where the power still rises at an end of the range, its peak lies outside.
    let mut order: Vec<usize> =
        (1..count.saturating_sub(1)).filter(|&i| power[i] >= power[i - 1] && power[i] > power[i + 1]).collect();
    order.sort_by(|a, b| power[*b].total_cmp(&power[*a]));
    order.into_iter().take(4).map(|i| orders.at(i)).collect()
}

impl Hypothesis for TorqueRipple {
    fn effect(&self) -> EffectKind {
        EffectKind::TorqueRipple
    }

    fn kind(&self) -> Kind {
        Kind::Transmission
    }

    fn in_the_drive(&self) -> bool {
        true
    }

    fn follows_acceleration(&self) -> bool {
        false
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape {
            symbol: Symbol::Key(effects::TorqueRipple::RN),
            unit: "1/turn",
            range: [0.5, 5000.0],
            step: Some(-0.15),
        }]
    }

    fn grid(&self, scene: &WindowedData<'_>, place: &[usize], residual: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let j = place[0];
        if !moves(scene, j) {
            return Vec::new();
        }
        let mut orders = peaks(scene, j, &residual[j]);
        let [low, high] = scene.travel[j];
        let least = 9.5 / (high - low).max(0.05);
        orders.extend([2.0, 3.0, 4.0, 6.0, 8.0].into_iter().filter(|n| *n >= least));
        if let Some(gear) = scene.plant.gear_ratios()[j] {
            orders.extend([1.0, 2.0, 3.0, 4.0, 6.0].map(|k| k * gear.abs()).into_iter().filter(|n| *n >= least));
        }
        orders.into_iter().map(|n| vec![n]).collect()
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        // Less than a period and a half within the travel is not identifiable as ripple.
        let [low, high] = scene.travel[place[0]];
        moves(scene, place[0]) && shape[0] * (high - low) >= 9.4
    }

    /// Where two orders get out of step by less than 1 rad over the travel, their sizes cancel.
    fn unresolved(&self, scene: &WindowedData<'_>, place: &[usize], a: &[f64], b: &[f64]) -> bool {
        let [low, high] = scene.travel[place[0]];
        (a[0] - b[0]).abs() * (high - low) < 1.0
    }

    fn same_law(&self, a: &[f64], b: &[f64]) -> bool {
        nearly_one_order(a, b, 1.1)
    }

    fn integer_shape(&self) -> Option<usize> {
        Some(0)
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (j, n) = (place[0], shape[0]);
        vec![
            Term::new(effects::TorqueRipple::RC, scene.pointwise(j, |o, k| (n * o.q[k]).cos()), Sign::Any),
            Term::new(effects::TorqueRipple::RS, scene.pointwise(j, |o, k| (n * o.q[k]).sin()), Sign::Any),
        ]
    }

    /// At most the rated torque, as for other laws. Published ripple of gears and motors is 0.5 to 1.3 %
    /// of it (see the table of effects); no source gives an upper bound.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        x.iter().map(|x| x * x).sum::<f64>().sqrt() <= scene.rated[place[0]]
    }

    fn most(&self) -> usize {
        2
    }

    fn says(&self) -> &'static str {
        "torque that is periodic in the joint's angle"
    }

    fn shown_by(&self) -> &'static str {
        "slow constant speed over several periods, in both directions"
    }
}
