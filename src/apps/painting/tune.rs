//! Gains of both loops for a planned motion, from the model of the robot, the wall's stiffness, the
//! filter and the sampling.

use nalgebra::{DMatrix, DVector};

use crate::control::gains::{
    ArmPlant, ForcePlant, ForceProposal, JointPlant, JointProposal, lowered, propose_force, propose_joint,
};
use crate::control::law::Model;
use crate::control::robot::RobotModel;

/// Conditions under which the gains must keep their margins.
#[derive(Debug, Clone, PartialEq)]
pub struct Demands {
    /// Time between samples, s.
    pub period: f64,
    /// Corner frequency of the filter on the force, Hz.
    pub corner: f64,
    /// Stiffness of wall and roller, N/m.
    pub stiffness: f64,
    /// Damping of wall and roller, N s/m.
    pub damping: f64,
    /// Of each joint beyond the model: rotor inertia, kg m^2, spring stiffness, N m/rad (infinite
    /// for none), and its damping, N m s/rad. Gains are tuned on the robot itself.
    pub drives: Vec<[f64; 3]>,
}

/// Gains of all loops.
#[derive(Debug, Clone, PartialEq)]
pub struct Tuning {
    /// Gains of each joint.
    pub joints: Vec<JointProposal>,
    /// Gains of the force loop.
    pub force: ForceProposal,
}

/// Margin that no gains keep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TuneError {
    /// Margins of a joint by itself, from 1.
    #[error("no gains of joint {0} keep their margins")]
    Joint(usize),
    /// Margins of all joints together.
    #[error("no gains keep their margins with all joints together")]
    Together,
    /// A posture has no displacement along the normal.
    #[error("a posture can't be displaced along the normal")]
    Posture,
    /// Margins of the force loop.
    #[error("no gains of the force loop keep their margins on this wall")]
    Force,
}

/// Proposes gains that keep their margins in all these postures; `press` is the unit vector into
/// the wall.
///
/// # Errors
/// Returns the margin that cannot be kept.
pub fn tune<const N: usize>(
    model: &mut RobotModel<'_>,
    postures: &[[f64; N]],
    viscous: &[f64; N],
    press: &[f64; 3],
    demands: &Demands,
) -> Result<Tuning, TuneError> {
    let masses: Vec<Vec<f64>> = postures.iter().map(|q| model.mass(q)).collect();
    let mut joints = Vec::new();
    for j in 0..N {
        let [rotor, stiffness, damping] = demands.drives[j];
        let at = |mass: &Vec<f64>| mass[j * N + j] + rotor;
        let low = masses.iter().map(at).fold(f64::INFINITY, f64::min);
        let high = masses.iter().map(at).fold(0.0, f64::max);
        let plant = JointPlant {
            period: demands.period,
            delay: 0,
            inertia: [low, high],
            rotor,
            stiffness,
            damping,
            viscous: viscous[j],
        };
        joints.push((plant, propose_joint(&plant).ok_or(TuneError::Joint(j + 1))?));
    }
    let arms: Vec<ArmPlant> = masses
        .iter()
        .map(|mass| ArmPlant {
            period: demands.period,
            mass: DMatrix::from_row_slice(N, N, mass),
            drives: demands.drives.clone(),
            viscous: viscous.to_vec(),
        })
        .collect();
    let gains = lowered(&arms, joints.iter().map(|(_, p)| [p.kp, p.kd]).collect());
    let gains = gains.ok_or(TuneError::Together)?;
    let joints: Vec<JointProposal> = joints
        .iter()
        .zip(gains)
        .map(|((plant, found), [kp, kd])| JointProposal {
            kp,
            kd,
            bandwidth: found.bandwidth * (kp / found.kp).sqrt(),
            margins: plant.margins(kp, kd),
        })
        .collect();
    let gains: Vec<[f64; 2]> = joints.iter().map(|j| [j.kp, j.kd]).collect();
    let rigid: Option<Vec<ForcePlant>> =
        postures.iter().map(|q| plant(model, q, viscous, press, demands, &gains, false)).collect();
    let force = propose_force(&rigid.ok_or(TuneError::Posture)?);
    let force = force.ok_or(TuneError::Force)?;
    Ok(Tuning { joints, force })
}

/// Linear model of arm and wall in a posture, for joints with these gains (`kp`, `kd`). Joints are
/// rigid, or, if `soft`, on their springs. `None` if the posture cannot be displaced along the
/// normal.
pub fn plant<const N: usize>(
    model: &mut RobotModel<'_>,
    q: &[f64; N],
    viscous: &[f64; N],
    press: &[f64; 3],
    demands: &Demands,
    gains: &[[f64; 2]],
    soft: bool,
) -> Option<ForcePlant> {
    let drives: Vec<[f64; 3]> =
        demands.drives.iter().map(|d| if soft { *d } else { [d[0], f64::INFINITY, 0.0] }).collect();
    let mut mass = DMatrix::from_row_slice(N, N, &model.mass(q));
    (0..N).filter(|&j| !drives[j][1].is_finite()).for_each(|j| mass[(j, j)] += drives[j][0]);
    let along = model.contact(q).jacobian;
    let step = 1e-3;
    let moved = model.displaced(q, &press.map(|p| p * step), q)?;
    Some(ForcePlant {
        period: demands.period,
        mass,
        drives,
        viscous: DVector::from_column_slice(viscous),
        kp: DVector::from_fn(N, |j, _| gains[j][0]),
        kd: DVector::from_fn(N, |j, _| gains[j][1]),
        along: DVector::from_fn(N, |j, _| (0..3).map(|k| press[k] * along[k][j]).sum()),
        inverse: DVector::from_fn(N, |j, _| (moved[j] - q[j]) / step),
        stiffness: demands.stiffness,
        damping: demands.damping,
        corner: demands.corner,
    })
}
