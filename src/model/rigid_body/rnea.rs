//! Inverse dynamics by the recursive Newton-Euler algorithm, RBDA table 5.1.

use dh_codegen::arm::param::DriveTerm;
use nalgebra::DVector;

use super::Numeric;
use super::Workspace;
use super::body;
use super::sign;
use super::spatial::{Force, Motion};

/// Arguments of an outward sweep. An empty `dq` or `ddq` means zero.
pub(super) struct Sweep<'a> {
    pub(super) q: &'a [f64],
    pub(super) dq: &'a [f64],
    pub(super) ddq: &'a [f64],
    pub(super) base_acceleration: Motion,
}

impl Numeric {
    /// `tau = M(q) ddq + C(q, dq) dq + g(q) + IA ddq + FV dq + FC sign(dq) + FO`, `n`, with
    /// `sign(0) = 0`.
    pub fn inverse_dynamics(&self, q: &[f64], dq: &[f64], ddq: &[f64], phi: &[f64]) -> DVector<f64> {
        let mut tau = DVector::zeros(self.dof);
        self.inverse_dynamics_into(&mut self.workspace(), q, dq, ddq, phi, tau.as_mut_slice());
        tau
    }

    /// [`Numeric::inverse_dynamics`] without allocation; `tau` has `n` entries.
    pub fn inverse_dynamics_into(
        &self,
        work: &mut Workspace,
        q: &[f64],
        dq: &[f64],
        ddq: &[f64],
        phi: &[f64],
        tau: &mut [f64],
    ) {
        self.check("q", q.len());
        self.check("dq", dq.len());
        self.check("ddq", ddq.len());
        self.check("tau", tau.len());
        self.check_phi(phi);
        self.newton_euler(work, &Sweep { q, dq, ddq, base_acceleration: self.base_acceleration() }, phi, tau);
        for drive in &self.drives {
            if let Some(j) = drive.joint {
                tau[j] += phi[drive.column] * drive_factor(drive.term, dq[j], ddq[j]);
            }
        }
    }

    /// Centrifugal and Coriolis torque `C(q, dq) dq`, `n`: no gravity, no friction.
    pub fn coriolis(&self, q: &[f64], dq: &[f64], phi: &[f64]) -> DVector<f64> {
        self.check("q", q.len());
        self.check("dq", dq.len());
        self.check_phi(phi);
        let mut tau = DVector::zeros(self.dof);
        let sweep = Sweep { q, dq, ddq: &[], base_acceleration: Motion::zero() };
        self.newton_euler(&mut self.workspace(), &sweep, phi, tau.as_mut_slice());
        tau
    }

    /// Gravity torque `g(q)`, `n`, without the drives' offsets.
    pub fn gravity(&self, q: &[f64], phi: &[f64]) -> DVector<f64> {
        self.check("q", q.len());
        self.check_phi(phi);
        let mut tau = DVector::zeros(self.dof);
        let sweep = Sweep { q, dq: &[], ddq: &[], base_acceleration: self.base_acceleration() };
        self.newton_euler(&mut self.workspace(), &sweep, phi, tau.as_mut_slice());
        tau
    }

    /// The rigid-body part: outward sweep for motions and the bodies' forces, inward for joint
    /// torques.
    pub(super) fn newton_euler(&self, work: &mut Workspace, sweep: &Sweep<'_>, phi: &[f64], tau: &mut [f64]) {
        self.outward(work, sweep);
        for i in 0..self.rows.len() {
            let body = body(phi, i);
            work.f[i] = body.times(&work.a[i]) + work.v[i].cross_force(&body.times(&work.v[i]));
        }
        let mut carried = Force::zero();
        for (i, row) in self.rows.iter().enumerate().rev() {
            let force = work.f[i] + carried;
            if let Some(j) = row.joint {
                tau[j] = row.axis.dot(&force);
            }
            carried = work.x[i].force_to_parent(&force);
        }
    }

    /// Transforms, velocities and accelerations of all frames, each in its own axes: `work.x`,
    /// `work.v`, `work.a`.
    pub(super) fn outward(&self, work: &mut Workspace, sweep: &Sweep<'_>) {
        let (mut v, mut a) = (Motion::zero(), sweep.base_acceleration);
        for (i, row) in self.rows.iter().enumerate() {
            let x = row.transform(row.of(sweep.q));
            let joint = row.axis * row.of(sweep.dq);
            v = x.motion(&v) + joint;
            // The axis is constant in its own frame, so that c_J = 0.
            a = x.motion(&a) + row.axis * row.of(sweep.ddq) + v.cross(&joint);
            (work.x[i], work.v[i], work.a[i]) = (x, v, a);
        }
    }
}

/// Torque of a joint per unit of a drive parameter.
pub(super) fn drive_factor(term: DriveTerm, dq: f64, ddq: f64) -> f64 {
    match term {
        DriveTerm::IA => ddq,
        DriveTerm::FV => dq,
        DriveTerm::FC => sign(dq),
        DriveTerm::FO => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::model::rigid_body::samples;
    use crate::numerics::prng::Random;
    use dh_codegen::robot::{Angle, Convention, Inertia, Joint, JointKind, Length};

    /// Two links in a vertical plane: Craig, *Introduction to Robotics*, section 6.7, with
    /// distributed mass.
    #[test]
    fn planar_2r_is_the_textbook_closed_form() {
        let (mut robot, l1, g) = (samples::planar_2r(), 0.5, 9.81);
        let (m1, c1, i1, m2, c2, i2) = (3.0, 0.21, 0.12, 2.0, 0.17, 0.07); // i: about the centre of mass
        let link = |m: f64, c: f64, i: f64| {
            Some(Inertia { m, ms: [m * c, 0.0, 0.0], i: [0.0, 0.0, i + m * c * c, 0.0, 0.0, 0.0] })
        };
        robot.links = vec![link(m1, c1, i1), link(m2, c2, i2)];
        let phi = dh_codegen::arm::param::standard_values(&robot).unwrap();
        let numeric = Numeric::new(&robot);
        let mut random = Random::new(21);
        for _ in 0..50 {
            let s = random.state(&robot);
            let ([q1, q2], [u1, u2], [a1, a2]) = ([s.q[0], s.q[1]], [s.dq[0], s.dq[1]], [s.ddq[0], s.ddq[1]]);
            let m22 = i2 + m2 * c2 * c2;
            let m12 = m22 + m2 * l1 * c2 * q2.cos();
            let m11 = i1 + m1 * c1 * c1 + m22 + m2 * (l1 * l1 + 2.0 * l1 * c2 * q2.cos());
            let h = m2 * l1 * c2 * q2.sin();
            let g2 = m2 * c2 * g * (q1 + q2).cos();
            let g1 = (m1 * c1 + m2 * l1) * g * q1.cos() + g2;
            let tau = numeric.inverse_dynamics(&s.q, &s.dq, &s.ddq, &phi);
            assert!((tau[0] - (m11 * a1 + m12 * a2 - h * (2.0 * u1 * u2 + u2 * u2) + g1)).abs() < 1e-11);
            assert!((tau[1] - (m12 * a1 + m22 * a2 + h * u1 * u1 + g2)).abs() < 1e-11);
        }
    }

    /// One arm in both conventions: the standard table's constant part `TransX(d) RotX(alpha)`
    /// moves to the next row. The last one becomes a fixed row.
    #[test]
    fn both_conventions_describe_one_motion() {
        let mut random = Random::new(22);
        for case in 0..100 {
            let mut classical = random.robot(&Family::default());
            classical.convention = Convention::Standard;
            let inertias: Vec<Inertia> = classical.links.iter().map(|l| l.unwrap()).collect();
            let mut modified = classical.clone();
            modified.convention = Convention::Modified;
            let last = classical.joints.last().unwrap();
            modified.joints.push(Joint {
                name: "flange".to_string(),
                kind: JointKind::Fixed,
                theta: Angle::zero(),
                r: Length::zero(),
                drive: Default::default(),
                ..last.clone()
            });
            modified.links.push(Some(Inertia::default()));
            for i in 0..modified.joints.len() {
                let (alpha, d) = match i.checked_sub(1) {
                    Some(before) => (classical.joints[before].alpha.clone(), classical.joints[before].d.clone()),
                    None => (Angle::zero(), Length::zero()),
                };
                (modified.joints[i].alpha, modified.joints[i].d) = (alpha, d);
                if i < inertias.len() {
                    let (s, c) = classical.joints[i].alpha.sin_cos();
                    let rotation = [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]];
                    let origin = [classical.joints[i].d.value, 0.0, 0.0];
                    modified.links[i] = Some(inertias[i].moved(&rotation, &origin));
                }
            }
            let (a, b) = (Numeric::new(&classical), Numeric::new(&modified));
            classical.tool = None;
            modified.tool = None;
            let phi_a = dh_codegen::arm::param::standard_values(&classical).unwrap();
            let phi_b = dh_codegen::arm::param::standard_values(&modified).unwrap();
            let s = random.state(&classical);
            let (ta, tb) =
                (a.inverse_dynamics(&s.q, &s.dq, &s.ddq, &phi_a), b.inverse_dynamics(&s.q, &s.dq, &s.ddq, &phi_b));
            assert!((&ta - &tb).amax() < 1e-11 * (1.0 + ta.amax()), "case {case}: {ta} {tb}");
            let (fa, fb) = (a.frames(&s.q), b.frames(&s.q));
            assert!((fa.last().unwrap() - fb.last().unwrap()).amax() < 1e-12);
            assert!((a.jacobian(&s.q) - b.jacobian(&s.q)).amax() < 1e-12);
            assert!((a.jacobian_dot_dq(&s.q, &s.dq) - b.jacobian_dot_dq(&s.q, &s.dq)).amax() < 1e-11);
        }
    }

    #[test]
    fn torque_is_the_sum_of_its_parts() {
        let mut random = Random::new(23);
        for _ in 0..100 {
            let robot = random.robot(&Family::default());
            let (numeric, phi, s) = (Numeric::new(&robot), random.phi(&robot), random.state(&robot));
            let mut expected = numeric.mass_matrix(&s.q, &phi) * DVector::from_column_slice(&s.ddq)
                + numeric.coriolis(&s.q, &s.dq, &phi)
                + numeric.gravity(&s.q, &phi);
            for (j, row) in robot.moving().into_iter().enumerate() {
                let drive = &robot.joints[row].drive;
                expected[j] += drive.viscous_friction.unwrap_or(0.0) * s.dq[j]
                    + drive.coulomb_friction.unwrap_or(0.0) * s.dq[j].signum()
                    + drive.offset.unwrap_or(0.0);
            }
            let tau = numeric.inverse_dynamics(&s.q, &s.dq, &s.ddq, &phi);
            assert!((&tau - &expected).amax() < 1e-11 * (1.0 + tau.amax()));
        }
    }

    #[test]
    fn a_joint_at_rest_shows_no_coulomb_friction() {
        let mut robot = samples::planar_2r();
        robot.gravity = [0.0; 3];
        robot.joints[0].drive.coulomb_friction = Some(2.0);
        let numeric = Numeric::new(&robot);
        let mut phi = vec![0.0; 21];
        phi[20] = 2.0;
        for (dq, expected) in [(0.0, 0.0), (-0.0, 0.0), (1e-300, 2.0), (-1e-300, -2.0)] {
            let tau = numeric.inverse_dynamics(&[0.0; 2], &[dq, 0.0], &[0.0; 2], &phi);
            assert_eq!(tau.as_slice(), [expected, 0.0]);
        }
    }
}
