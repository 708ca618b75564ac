//! `law`: a torque in closed form, evaluated from its expression tree. (Generated code compiles it
//! to a tape.)

use dh_codegen::robot::{LawFunction, Term, TorqueLaw, Variable};

use crate::simulate::bristle::sign;
use crate::simulate::drive::Drive;

/// Additional torque of a joint's drive.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosedForm {
    law: TorqueLaw,
}

/// Variables that laws can read, at one instant, joint by joint.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Moment {
    /// Angles of the motors, rad.
    pub q: Vec<f64>,
    /// Velocities of the motors, rad/s.
    pub dq: Vec<f64>,
    /// Accelerations of the motors, rad/s^2.
    pub ddq: Vec<f64>,
    /// Smooth substitutes for the signs of the velocities.
    pub sign: Vec<f64>,
    /// Temperatures, degrees C.
    pub temperature: Vec<f64>,
    /// Time since the start, s.
    pub t: f64,
}

impl Moment {
    /// All zero, for `n` joints.
    pub(crate) fn of(n: usize) -> Self {
        let zeros = || vec![0.0; n];
        Self { q: zeros(), dq: zeros(), ddq: zeros(), sign: zeros(), temperature: zeros(), t: 0.0 }
    }

    /// Sets time and motion; `of` gives angle, velocity and its sign for each joint.
    pub(crate) fn set(&mut self, t: f64, drives: &[Drive], of: impl Fn(usize) -> (f64, f64, f64)) {
        self.t = t;
        for (j, drive) in drives.iter().enumerate() {
            (self.q[j], self.dq[j], self.sign[j]) = of(j);
            self.temperature[j] = drive.temperature(t);
        }
    }

    fn value(&self, variable: Variable) -> f64 {
        match variable {
            Variable::Position(k) => self.q[k],
            Variable::Velocity(k) => self.dq[k],
            Variable::Acceleration(k) => self.ddq[k],
            Variable::Temperature(k) => self.temperature[k],
            Variable::Time => self.t,
        }
    }
}

impl ClosedForm {
    /// Checks the law for an arm with `joints` joints.
    ///
    /// # Errors
    /// The number of a joint that does not exist.
    pub(crate) fn new(law: &TorqueLaw, joints: usize) -> Result<Self, usize> {
        let mut most = 0;
        law.term().variables(&mut |variable| {
            most = most.max(match variable {
                Variable::Position(k)
                | Variable::Velocity(k)
                | Variable::Acceleration(k)
                | Variable::Temperature(k) => k + 1,
                Variable::Time => 0,
            });
        });
        if most > joints { Err(most) } else { Ok(Self { law: law.clone() }) }
    }

    /// Torque, N m.
    pub fn torque(&self, at: &Moment) -> f64 {
        value(self.law.term(), at, None)
    }

    /// Half of the change when the sign of the velocity of joint `j` goes from -1 to 1, N m.
    pub(crate) fn level(&self, at: &Moment, j: usize) -> f64 {
        let [up, down] = [1.0, -1.0].map(|sign| value(self.law.term(), at, Some((j, sign))));
        0.5 * (up - down)
    }

    /// Marks the joints whose velocity sign occurs in the law.
    pub(crate) fn signs(&self, of: &mut [bool]) {
        signs(self.law.term(), of);
    }

    pub(crate) fn reads_acceleration(&self) -> bool {
        self.law.reads_acceleration()
    }
}

/// Joint of `sign(dq_k)`. A bristle replaces it, so that a joint sticks where it stops.
fn sign_of(term: &Term) -> Option<usize> {
    match term {
        Term::Call(LawFunction::Sign, x) => match **x {
            Term::Variable(Variable::Velocity(k)) => Some(k),
            _ => None,
        },
        _ => None,
    }
}

fn signs(term: &Term, of: &mut [bool]) {
    if let Some(k) = sign_of(term) {
        of[k] = true;
    }
    match term {
        Term::Number(_) | Term::Variable(_) => {}
        Term::Negative(x) | Term::Inverse(x) | Term::Power(x, _) | Term::Call(_, x) => signs(x, of),
        Term::Sum(all) | Term::Product(all) => all.iter().for_each(|x| signs(x, of)),
        Term::Least(x, y) | Term::Most(x, y) => {
            signs(x, of);
            signs(y, of);
        }
    }
}

/// Value of a term. `with` is a joint and a value that replaces the sign of its velocity.
fn value(term: &Term, at: &Moment, with: Option<(usize, f64)>) -> f64 {
    let of = |x: &Term| value(x, at, with);
    if let Some(k) = sign_of(term) {
        return with.filter(|(j, _)| *j == k).map_or(at.sign[k], |(_, sign)| sign);
    }
    match term {
        Term::Number(x) => *x,
        Term::Variable(variable) => at.value(*variable),
        Term::Negative(x) => -of(x),
        Term::Inverse(x) => 1.0 / of(x),
        Term::Sum(all) => all.iter().map(of).sum(),
        Term::Product(all) => all.iter().map(of).product(),
        Term::Power(x, n) => libm::pow(of(x), *n),
        Term::Least(x, y) => of(x).min(of(y)),
        Term::Most(x, y) => of(x).max(of(y)),
        Term::Call(function, x) => {
            let x = of(x);
            match function {
                LawFunction::Sin => libm::sin(x),
                LawFunction::Cos => libm::cos(x),
                LawFunction::Exp => libm::exp(x),
                LawFunction::Ln => libm::log(x),
                LawFunction::Sqrt => x.max(0.0).sqrt(),
                LawFunction::Abs => x.abs(),
                LawFunction::Sign => sign(x),
                LawFunction::Tanh => libm::tanh(x),
            }
        }
    }
}
