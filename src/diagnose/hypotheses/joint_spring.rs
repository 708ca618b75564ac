//! `joint_spring`: an elastic torque as a function of the joint's angle (gravity spring, cable,
//! hose).

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Estimate;
use super::Hypothesis;
use super::Kind;
use super::Law;
use super::Named;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::moves;
use crate::diagnose::windows::windowed_data::WindowedData;

/// `KS (q - QS)`, `KS` above zero: a torque away from the rest position is due to gravity of a
/// wrong mass, or to a gain. The constant part is among the unknowns anyway.
pub struct JointSpring;

impl Hypothesis for JointSpring {
    fn effect(&self) -> EffectKind {
        EffectKind::JointSpring
    }

    fn kind(&self) -> Kind {
        Kind::Outside
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        moves(scene, place[0])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        vec![Term::new(effects::JointSpring::KS, scene.pointwise(j, |o, k| o.q[k]), Sign::Positive)]
    }

    /// Over the travel its torque is at most what the joint can hold.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        let [low, high] = scene.travel[place[0]];
        x.iter().all(|stiffness| 0.5 * stiffness.abs() * (high - low) <= scene.rated[place[0]])
    }

    fn has_constant(&self) -> bool {
        true
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let (stiffness, [_, _, offset]) = (found.x[0], found.levels);
        vec![
            found.term(0),
            Named::new(
                effects::JointSpring::QS,
                if stiffness == 0.0 || offset == 0.0 { 0.0 } else { -offset / stiffness },
                None,
            ),
        ]
    }

    fn says(&self) -> &'static str {
        "an elastic torque in proportion to the joint's angle"
    }

    fn shown_by(&self) -> &'static str {
        "static poses over the whole travel of the joint"
    }
}

/// A cable that is slack on one side of `QS` and taut on the other, or one that stiffens, or both:
/// `KS x + KQ x^3`, `x = q - QS`.
pub struct CableSpring;

/// Indices of the shape's numbers: rest position, and index of the law in [`FORMS`].
const REST: usize = 0;
const FORM: usize = 1;
/// Laws: the side that is taut (0: both), and whether the cable stiffens.
const FORMS: [(f64, bool); 5] = [(1.0, false), (-1.0, false), (1.0, true), (-1.0, true), (0.0, true)];

impl CableSpring {
    fn form(shape: &[f64]) -> (f64, bool) {
        FORMS[(shape[FORM].max(0.0) as usize).min(FORMS.len() - 1)]
    }
}

impl Hypothesis for CableSpring {
    fn effect(&self) -> EffectKind {
        EffectKind::JointSpring
    }

    fn kind(&self) -> Kind {
        Kind::Outside
    }

    fn shape(&self) -> &'static [Shape] {
        &[
            Shape { symbol: Symbol::Key(effects::JointSpring::QS), unit: "rad", range: [-1e3, 1e3], step: Some(-0.1) },
            Shape { symbol: Symbol::Own("form"), unit: "", range: [0.0, 4.0], step: None },
        ]
    }

    fn grid(&self, scene: &WindowedData<'_>, place: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let [low, high] = scene.travel[place[0]];
        let rests = (1..8).map(|k| low + f64::from(k) / 8.0 * (high - low));
        rests.flat_map(|rest| (0..FORMS.len()).map(move |form| vec![rest, form as f64])).collect()
    }

    /// A linear spring, then a cable that is taut on one side and does not stiffen.
    fn simpler(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Law> {
        let mut laws: Vec<Law> = vec![(&JointSpring, vec![Vec::new()])];
        let (side, stiffens) = Self::form(shape);
        if stiffens {
            let like = |s: &Vec<f64>| {
                let (other, stiffens) = Self::form(s);
                !stiffens && (side == 0.0 || other == side)
            };
            laws.push((&Self, self.grid(scene, place, &[]).into_iter().filter(like).collect()));
        }
        laws
    }

    /// Near the ends of the travel a cable is always taut, or never, and not identifiable.
    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        let [low, high] = scene.travel[place[0]];
        let edge = 0.05 * (high - low);
        moves(scene, place[0]) && (low + edge..high - edge).contains(&shape[REST])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (j, rest, (side, stiffens)) = (place[0], shape[REST], Self::form(shape));
        let column = |power: i32| {
            let pull = |x: f64| if side * x < 0.0 { 0.0 } else { x.powi(power) };
            scene.pointwise(j, |o, k| pull(o.q[k] - rest))
        };
        let mut terms =
            vec![Term::new(effects::JointSpring::KS, column(1), if side == 0.0 { Sign::Any } else { Sign::Positive })];
        if stiffens {
            terms.push(Term::new(effects::JointSpring::KQ, column(3), Sign::Positive));
        }
        terms
    }

    /// It pulls back towards its rest position, over the travel with at most what the joint can
    /// hold.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64], x: &[f64]) -> bool {
        let (side, _) = Self::form(shape);
        let pull = |at: f64| x.iter().zip([at, at.powi(3)]).map(|(k, x)| k * x).sum::<f64>();
        let ends = scene.travel[place[0]].map(|end| end - shape[REST]);
        let back = |at: &f64| pull(*at).abs() <= scene.rated[place[0]] && pull(0.3 * at) * at >= 0.0;
        ends.iter().filter(|at| side * **at >= 0.0).all(back)
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let (side, _) = Self::form(found.shape);
        let side = (side != 0.0).then(|| Named::new(effects::JointSpring::SIDE, side, None));
        let rest = Named::new(effects::JointSpring::QS, found.shape[REST], found.shape_std[REST]);
        found.all_terms().chain([rest]).chain(side).collect()
    }

    fn says(&self) -> &'static str {
        "an elastic torque in the joint's angle that is slack on one side, or stiffens with the stretch"
    }

    fn shown_by(&self) -> &'static str {
        JointSpring.shown_by()
    }
}
