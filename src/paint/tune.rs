//! Gains of both loops for a planned motion: from what is known of the robot, the wall's stiffness, the filter and the sampling.

use nalgebra::{DMatrix, DVector};

use crate::control::gains::{ForcePlant, ForceProposal, JointPlant, JointProposal, propose_force, propose_joint};
use crate::control::law::Model;
use crate::control::robot::Lent;

/// What the gains must bear.
#[derive(Debug, Clone, PartialEq)]
pub struct Demands {
    /// Time between samples, s.
    pub period: f64,
    /// Corner of the filter on the force, Hz.
    pub corner: f64,
    /// Of wall and roller, N/m.
    pub stiffness: f64,
    /// Of wall and roller, N s/m.
    pub damping: f64,
    /// Rotor and spring of each joint beyond the model, kg m^2 and N m/rad: gains are tuned on the robot itself. Without a spring: infinite.
    pub drives: Vec<[f64; 2]>,
}

/// The gains.
#[derive(Debug, Clone, PartialEq)]
pub struct Tuning {
    /// Of each joint.
    pub joints: Vec<JointProposal>,
    /// Of the force loop.
    pub force: ForceProposal,
}

/// Gains that keep their margins in all these postures; `press` is the unit vector into the wall.
///
/// # Errors
/// Says what can't be kept.
pub fn tune<const N: usize>(
    lent: &mut Lent<'_>,
    postures: &[[f64; N]],
    viscous: &[f64; N],
    press: &[f64; 3],
    demands: &Demands,
) -> Result<Tuning, String> {
    let mut inertia = [[f64::INFINITY, 0.0]; N];
    let masses: Vec<Vec<f64>> = postures.iter().map(|q| lent.mass(q)).collect();
    for mass in &masses {
        let inverse = DMatrix::from_row_slice(N, N, mass).try_inverse().ok_or("the mass matrix is singular")?;
        for j in 0..N {
            // Others held, and others free: between the two lies what a joint's loop moves.
            inertia[j][0] = f64::min(inertia[j][0], 1.0 / inverse[(j, j)]);
            inertia[j][1] = f64::max(inertia[j][1], mass[j * N + j]);
        }
    }
    let mut joints = Vec::new();
    for j in 0..N {
        let [rotor, stiffness] = demands.drives[j];
        let [low, high] = inertia[j];
        let plant = JointPlant {
            period: demands.period,
            delay: 0,
            inertia: [low + rotor, high + rotor],
            rotor,
            stiffness,
            viscous: viscous[j],
        };
        joints.push(propose_joint(&plant).ok_or_else(|| format!("no gains of joint {} keep their margins", j + 1))?);
    }
    let mut plants = Vec::new();
    for (q, mass) in postures.iter().zip(&masses) {
        let along = lent.contact(q).jacobian;
        let step = 1e-3;
        let by = press.map(|p| p * step);
        let moved = lent.displaced(q, &by, q).ok_or("a posture can't be displaced along the normal")?;
        let mut mass = DMatrix::from_row_slice(N, N, mass);
        (0..N).for_each(|j| mass[(j, j)] += demands.drives[j][0]);
        plants.push(ForcePlant {
            period: demands.period,
            mass,
            viscous: DVector::from_column_slice(viscous),
            kp: DVector::from_fn(N, |j, _| joints[j].kp),
            kd: DVector::from_fn(N, |j, _| joints[j].kd),
            along: DVector::from_fn(N, |j, _| (0..3).map(|k| press[k] * along[k][j]).sum()),
            inverse: DVector::from_fn(N, |j, _| (moved[j] - q[j]) / step),
            stiffness: demands.stiffness,
            damping: demands.damping,
            corner: demands.corner,
        });
    }
    let force = propose_force(&plants).ok_or("no gains of the force loop keep their margins on this wall")?;
    Ok(Tuning { joints, force })
}
