//! Torques of the walls in a robot file (`external_contact` with `k`): the motors' part while the
//! tool is behind them.

use dh_codegen::robot::{Effect, Robot};
use nalgebra::Vector3;

use crate::model::States;
use crate::model::rigid_body::Numeric;

/// All walls of a file.
pub(crate) struct Walls {
    numeric: Numeric,
    planes: Vec<Plane>,
}

/// A plane with the force `stiffness max(at - n'p, 0)` along the unit normal `n`.
struct Plane {
    /// Stiffness, N/m.
    stiffness: f64,
    normal: Vector3<f64>,
    /// Distance along the normal, m.
    at: f64,
}

impl Walls {
    /// The walls of this robot; `None` if it has none.
    pub(crate) fn of(robot: &Robot) -> Option<Self> {
        let plane = |effect: &Effect| match effect {
            Effect::ExternalContact(contact) => {
                let normal = Vector3::from(contact.normal()).try_normalize(0.0)?;
                Some(Plane { stiffness: contact.stiffness(), normal, at: contact.at() })
            }
            _ => None,
        };
        let planes: Vec<Plane> = robot.effects.iter().filter_map(plane).filter(|p| p.stiffness > 0.0).collect();
        (!planes.is_empty()).then(|| Self { numeric: Numeric::new(&robot.effective()), planes })
    }

    /// Adds their torques to `out` (joint-major), N m.
    pub(crate) fn add(&self, states: &States, out: &mut [f64]) {
        let (n, len) = (self.numeric.dof(), states.len);
        for s in 0..len {
            let q: Vec<f64> = (0..n).map(|j| states.q[j * len + s]).collect();
            let (tool, jacobian) = self.numeric.tool_and_jacobian(&q);
            let origin = tool.fixed_view::<3, 1>(0, 3).into_owned();
            let press = |p: &Plane| p.normal * p.stiffness * (p.at - p.normal.dot(&origin)).max(0.0);
            let force: Vector3<f64> = self.planes.iter().map(press).sum();
            let torques = jacobian.fixed_rows::<3>(0).transpose() * force;
            (0..n).for_each(|j| out[j * len + s] -= torques[j]);
        }
    }
}
