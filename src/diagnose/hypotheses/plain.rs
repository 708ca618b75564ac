//! `viscous_friction`, `coulomb_friction`, `torque_offset`: always among the unknowns, so that no
//! other cause has to absorb them.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::{self, Key};

use super::Hypothesis;
use super::Kind;
use super::Sign;
use super::Term;
use crate::diagnose::windows::windowed_data::WindowedData;

/// One of the three plain friction terms.
pub struct Plain {
    effect: EffectKind,
    key: Key,
    says: &'static str,
    shown_by: &'static str,
}

/// `FV v`.
pub static VISCOUS: Plain = Plain {
    effect: EffectKind::ViscousFriction,
    key: effects::ViscousFriction::FV,
    says: "friction in proportion to speed that the given model lacks or has wrong",
    shown_by: "constant speeds of several sizes in both directions",
};

/// `FC sign(v)`.
pub static COULOMB: Plain = Plain {
    effect: EffectKind::CoulombFriction,
    key: effects::CoulombFriction::FC,
    says: "friction of constant size against the motion that the given model lacks or has wrong",
    shown_by: "slow motion in both directions through the same positions",
};

/// `TO`.
pub static OFFSET: Plain = Plain {
    effect: EffectKind::TorqueOffset,
    key: effects::TorqueOffset::TO,
    says: "a constant shift of the torque",
    shown_by: "the joint at rest in positions where gravity does not load it",
};

/// The terms in the order of a joint's unknowns.
pub static PLAIN: [&Plain; 3] = [&VISCOUS, &COULOMB, &OFFSET];

impl Plain {
    /// Key of the term in a robot file.
    pub const fn key(&self) -> Key {
        self.key
    }
}

impl Hypothesis for Plain {
    fn effect(&self) -> EffectKind {
        self.effect
    }

    fn kind(&self) -> Kind {
        if self.effect == EffectKind::TorqueOffset { Kind::Measurement } else { Kind::Friction }
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        let column = match self.effect {
            EffectKind::ViscousFriction => scene.pointwise(j, |o, k| o.v[k]),
            EffectKind::CoulombFriction => scene.pointwise(j, |o, k| o.sign[k]),
            _ => scene.pointwise(j, |_, _| 1.0),
        };
        vec![Term::new(self.key, column, Sign::Any)]
    }

    fn same_on_paper(&self) -> &'static [&'static str] {
        // While the joint moves, a difference of Coulomb levels is a constant.
        if self.effect == EffectKind::TorqueOffset { &[effects::AsymmetricFriction::NAME] } else { &[] }
    }

    fn says(&self) -> &'static str {
        self.says
    }

    fn shown_by(&self) -> &'static str {
        self.shown_by
    }
}
