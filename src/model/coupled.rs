//! An arm with motors coupled to a second joint: the regressor columns of `gear_coupling` in the
//! robot file.
//!
//! Motor m turns with `w = dq_m + KC dq_k`. In addition to the drive of joint m itself, three
//! parameters act on both joints:
//!
//! | | on joint k | on joint m |
//! |---|---|---|
//! | `IAM`, kg m^2 | `KC ddq_m` | `KC ddq_k` |
//! | `FVM`, N m s/rad | `KC dq_m` | `KC dq_k` |
//! | `FCM`, N m | `KC sign(w)` | `sign(w)` |
//!
//! They follow the arm's own parameters, and are named after the row of the motor: `IAM6`, `FVM6`,
//! `FCM6`. Rigid bodies have none of these columns, so each is a base parameter of its own. Whether
//! a motion separates it from the others is decided by the fit.

use dh_codegen::robot::effects::{self, Key};

use crate::model::{Arm, BaseParameter, Description, StandardParameter, States, SummedSign, VelocitySum};

/// A motor coupled to a second joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coupling {
    /// Row of the motor's joint, from 0, used in the parameter names.
    pub row: usize,
    /// Degree of freedom of the motor's joint, m.
    pub motor: usize,
    /// Degree of freedom of the other joint, k.
    pub other: usize,
    /// `KC`: turns of the motor, on the joint's side, per turn of joint k.
    pub ratio: f64,
}

/// A parameter of a coupled motor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CouplingTerm {
    /// Rotor inertia, kg m^2.
    IAM,
    /// Viscous friction, N m s/rad.
    FVM,
    /// Coulomb friction, N m.
    FCM,
}

impl CouplingTerm {
    /// All terms, in the order of the regressor's columns.
    pub const ALL: [Self; 3] = [Self::IAM, Self::FVM, Self::FCM];

    /// Key of the term in a robot file.
    pub fn key(self) -> Key {
        match self {
            Self::IAM => effects::GearCoupling::IAM,
            Self::FVM => effects::GearCoupling::FVM,
            Self::FCM => effects::GearCoupling::FCM,
        }
    }

    /// Symbol of the term.
    pub fn name(self) -> &'static str {
        self.key().name()
    }

    /// Unit of the term.
    pub fn unit(self) -> &'static str {
        match self {
            Self::IAM => "kg m^2",
            Self::FVM => "N m s/rad",
            Self::FCM => "N m",
        }
    }
}

impl Coupling {
    /// Velocity of the motor, on the joint's side of the gear.
    pub fn velocity(&self) -> VelocitySum {
        VelocitySum { joints: [self.motor, self.other], ratio: self.ratio }
    }

    /// Torque per unit of a parameter on joint k or m, at every sample.
    fn column(&self, term: CouplingTerm, on_motor: bool, states: &States, out: &mut [f64]) {
        let of = |all: &'_ [f64], joint: usize, s: usize| all[joint * states.len + s];
        let far = if on_motor { self.other } else { self.motor };
        for (s, out) in out.iter_mut().enumerate() {
            *out = match term {
                CouplingTerm::IAM => self.ratio * of(&states.ddq, far, s),
                CouplingTerm::FVM => self.ratio * of(&states.dq, far, s),
                CouplingTerm::FCM => {
                    let w = of(&states.dq, self.motor, s) + self.ratio * of(&states.dq, self.other, s);
                    let sign = if w == 0.0 { 0.0 } else { w.signum() };
                    if on_motor { sign } else { self.ratio * sign }
                }
            };
        }
    }
}

/// Source of an entry of the base pattern.
#[derive(Clone, Copy)]
enum Entry {
    /// Entry of the uncoupled arm, with its index.
    Arm(usize),
    /// Coupling index, term, and whether the entry is on the motor's joint.
    Coupling(usize, CouplingTerm, bool),
}

/// An arm with its couplings; without any it is equivalent to the arm.
pub struct Coupled<'a> {
    arm: &'a dyn Arm,
    couplings: Vec<Coupling>,
    description: Description,
    entries: Vec<Entry>,
}

impl<'a> Coupled<'a> {
    /// Appends the couplings' parameters to those of the arm.
    pub fn new(arm: &'a dyn Arm, couplings: Vec<Coupling>) -> Self {
        let mut description = arm.description().clone();
        let Description { standard, base, .. } = &mut description;
        let own = arm.base_pattern().iter().enumerate().map(|(entry, &place)| (place, Entry::Arm(entry)));
        let mut all: Vec<((usize, usize), Entry)> = own.collect();
        for (index, coupling) in couplings.iter().enumerate() {
            for term in CouplingTerm::ALL {
                let parameter = StandardParameter::Coupling(coupling.row, term);
                for (joint, on_motor) in [(coupling.other, false), (coupling.motor, true)] {
                    all.push(((joint, base.len()), Entry::Coupling(index, term, on_motor)));
                }
                base.push(BaseParameter {
                    leader: parameter,
                    name: parameter.to_string(),
                    grouping: format!("{parameter} = {parameter}"),
                    coefficients: vec![(standard.len(), 1.0)],
                    unit: term.unit().to_string(),
                });
                standard.push(parameter);
            }
        }
        all.sort_by_key(|(place, _)| *place);
        let entries;
        (description.pattern, entries) = all.into_iter().unzip();
        Self { arm, couplings, description, entries }
    }
}

impl Arm for Coupled<'_> {
    fn description(&self) -> &Description {
        &self.description
    }

    fn base_regressor(&self, states: &States, out: &mut [f64]) {
        if self.couplings.is_empty() {
            return self.arm.base_regressor(states, out);
        }
        let len = states.len;
        let mut own = vec![0.0; self.arm.base_pattern().len() * len];
        self.arm.base_regressor(states, &mut own);
        for (out, entry) in out.chunks_exact_mut(len.max(1)).zip(&self.entries) {
            match *entry {
                Entry::Arm(entry) => out.copy_from_slice(&own[entry * len..(entry + 1) * len]),
                Entry::Coupling(index, term, on_motor) => {
                    self.couplings[index].column(term, on_motor, states, out);
                }
            }
        }
    }

    fn summed_signs(&self) -> Vec<SummedSign> {
        let place = |own: usize| self.entries.iter().position(|e| matches!(e, Entry::Arm(k) if *k == own));
        let mut all = self.arm.summed_signs();
        for signs in &mut all {
            signs.entries = signs.entries.iter().filter_map(|&(own, f)| Some((place(own)?, f))).collect();
        }
        all.extend(self.couplings.iter().enumerate().map(|(index, coupling)| {
            let entry = |(at, entry): (usize, &Entry)| match *entry {
                Entry::Coupling(of, CouplingTerm::FCM, on_motor) if of == index => {
                    Some((at, if on_motor { 1.0 } else { coupling.ratio }))
                }
                _ => None,
            };
            SummedSign {
                sum: coupling.velocity(),
                entries: self.entries.iter().enumerate().filter_map(entry).collect(),
            }
        }));
        all
    }

    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]) {
        let own = self.arm.standard_parameters().len();
        self.arm.inverse_dynamics(states, &standard[..own], out);
        let mut column = vec![0.0; states.len];
        for (index, coupling) in self.couplings.iter().enumerate() {
            let values = &standard[own + CouplingTerm::ALL.len() * index..];
            for (term, value) in CouplingTerm::ALL.into_iter().zip(values) {
                for (joint, on_motor) in [(coupling.other, false), (coupling.motor, true)] {
                    coupling.column(term, on_motor, states, &mut column);
                    let torque = &mut out[joint * states.len..(joint + 1) * states.len];
                    torque.iter_mut().zip(&column).for_each(|(tau, w)| *tau += value * w);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::planar::Planar;

    /// The power into a coupled rotor alone is the rate of `IAM/2 (w^2 - dq_m^2 - KC^2 dq_k^2)`,
    /// and friction at the motor dissipates `FCM |w|`. The regressor agrees with the torques.
    #[test]
    fn energy_and_columns_agree() {
        let planar = Planar::new();
        let coupling = Coupling { row: 1, motor: 1, other: 0, ratio: -1.5 };
        let arm = Coupled::new(&planar, vec![coupling]);
        let own = planar.standard_parameters().len();
        assert_eq!(arm.standard_names()[own..], ["IAM2", "FVM2", "FCM2"]);
        let (v, a) = ([0.7, 0.4], [0.2, -1.1]); // joints k, m
        let states = States { len: 1, q: vec![0.3, 0.9], dq: v.to_vec(), ddq: a.to_vec() };
        let powers = [
            coupling.ratio * (a[0] * v[1] + v[0] * a[1]),
            2.0 * coupling.ratio * v[0] * v[1],
            (v[1] + coupling.ratio * v[0]).abs(),
        ];
        for (term, power) in powers.into_iter().enumerate() {
            let mut standard = vec![0.0; arm.standard_parameters().len()];
            standard[own + term] = 1.0;
            let mut tau = [0.0; 2];
            arm.inverse_dynamics(&states, &standard, &mut tau);
            assert!((tau[0] * v[0] + tau[1] * v[1] - power).abs() < 1e-12, "term {term}");
            let mut entries = vec![0.0; arm.base_pattern().len()];
            arm.base_regressor(&states, &mut entries);
            let base = arm.base_parameters().len() - CouplingTerm::ALL.len() + term;
            for (&(joint, column), entry) in arm.base_pattern().iter().zip(&entries) {
                if column == base {
                    assert_eq!(*entry, tau[joint], "term {term}, joint {joint}");
                }
            }
        }
        assert!(arm.base_pattern().is_sorted());
    }
}
