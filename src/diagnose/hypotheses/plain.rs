//! `viscous_friction`, `coulomb_friction`, `torque_offset`: always among the unknowns, so that no
//! other cause has to stand in for them.

use super::Cause;
use super::Kind;
use super::Sign;
use super::Term;
use crate::diagnose::windowed_data::WindowedData;

/// One of the three.
pub struct Plain {
    name: &'static str,
    symbol: &'static str,
    says: &'static str,
    shown_by: &'static str,
}

/// `FV v`.
pub static VISCOUS: Plain = Plain {
    name: "viscous_friction",
    symbol: "FV",
    says: "friction in proportion to speed that the given model lacks or has wrong",
    shown_by: "constant speeds of several sizes in both directions",
};

/// `FC sign(v)`.
pub static COULOMB: Plain = Plain {
    name: "coulomb_friction",
    symbol: "FC",
    says: "friction of constant size against the motion that the given model lacks or has wrong",
    shown_by: "slow motion in both directions through the same positions",
};

/// `TO`.
pub static OFFSET: Plain = Plain {
    name: "torque_offset",
    symbol: "TO",
    says: "a constant shift of the torque",
    shown_by: "the joint at rest in positions where gravity does not load it",
};

/// All three.
pub(super) static ALL: [&dyn Cause; 3] = [&VISCOUS, &COULOMB, &OFFSET];

impl Cause for Plain {
    fn name(&self) -> &'static str {
        self.name
    }

    fn kind(&self) -> Kind {
        if self.symbol == "TO" { Kind::Measurement } else { Kind::Friction }
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        let column = match self.symbol {
            "FV" => scene.pointwise(j, |o, k| o.v[k]),
            "FC" => scene.pointwise(j, |o, k| o.sign[k]),
            _ => scene.pointwise(j, |_, _| 1.0),
        };
        vec![Term::new(self.symbol, column, Sign::Any)]
    }

    fn same_on_paper(&self) -> &'static [&'static str] {
        // While the joint moves, a difference of Coulomb levels is a constant.
        if self.symbol == "TO" { &["asymmetric_friction"] } else { &[] }
    }

    fn says(&self) -> &'static str {
        self.says
    }

    fn shown_by(&self) -> &'static str {
        self.shown_by
    }
}
