//! Standard parameters of an arm as a type: kind and row.

use std::fmt::{Display, Formatter};

use dh_codegen::arm::param::{DriveTerm, Inertial, Parameter};

use super::coupled::CouplingTerm;

/// A standard parameter: its kind, and its row of the DH table (from 0). Fixed rows count, so a row
/// is not a degree of freedom.
///
/// It prints as its name, with rows from 1: `XX2`, `FV3`, `IAM6`, `ML`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum StandardParameter {
    /// Inertial parameter of the link of this row.
    Link(usize, Inertial),
    /// Parameter of the drive of this row.
    Drive(usize, DriveTerm),
    /// Parameter of the motor of this row that is coupled to another joint.
    Coupling(usize, CouplingTerm),
    /// Inertial parameter of a body in the hand.
    Payload(Inertial),
}

impl From<Parameter> for StandardParameter {
    fn from(parameter: Parameter) -> Self {
        match parameter {
            Parameter::Link(row, which) => Self::Link(row, which),
            Parameter::Drive(row, term) => Self::Drive(row, term),
        }
    }
}

impl Display for StandardParameter {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Link(row, which) => write!(f, "{}{}", which.name(), row + 1),
            Self::Drive(row, term) => write!(f, "{}{}", term.name(), row + 1),
            Self::Coupling(row, term) => write!(f, "{}{}", term.name(), row + 1),
            Self::Payload(which) => write!(f, "{}L", which.name()),
        }
    }
}

impl StandardParameter {
    /// Whether it belongs to a drive or a coupling, not to a body.
    pub fn is_drive(self) -> bool {
        matches!(self, Self::Drive(..) | Self::Coupling(..))
    }

    /// Whether it is a rotor inertia or a friction level, which must not be negative.
    pub fn is_level(self) -> bool {
        self.is_drive() && !matches!(self, Self::Drive(_, DriveTerm::FO))
    }

    /// Whether it is a rotor inertia.
    pub fn is_rotor(self) -> bool {
        matches!(self, Self::Drive(_, DriveTerm::IA) | Self::Coupling(_, CouplingTerm::IAM))
    }

    /// Whether it is friction or the torque offset.
    pub fn is_friction(self) -> bool {
        self.is_drive() && !self.is_rotor()
    }

    /// Whether it is a Coulomb level, whose column is the sign of a velocity.
    pub fn is_coulomb(self) -> bool {
        matches!(self, Self::Drive(_, DriveTerm::FC) | Self::Coupling(_, CouplingTerm::FCM))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_kinds() {
        let all = [
            (StandardParameter::Link(1, Inertial::MSX), "MSX2", [false; 5]),
            (StandardParameter::Payload(Inertial::M), "ML", [false; 5]),
            (StandardParameter::Drive(11, DriveTerm::IA), "IA12", [true, true, true, false, false]),
            (StandardParameter::Drive(0, DriveTerm::FV), "FV1", [true, true, false, true, false]),
            (StandardParameter::Drive(0, DriveTerm::FC), "FC1", [true, true, false, true, true]),
            (StandardParameter::Drive(0, DriveTerm::FO), "FO1", [true, false, false, true, false]),
            (StandardParameter::Coupling(5, CouplingTerm::IAM), "IAM6", [true, true, true, false, false]),
            (StandardParameter::Coupling(5, CouplingTerm::FCM), "FCM6", [true, true, false, true, true]),
        ];
        for (p, name, kinds) in all {
            assert_eq!(p.to_string(), name);
            let found = [p.is_drive(), p.is_level(), p.is_rotor(), p.is_friction(), p.is_coulomb()];
            assert_eq!(found, kinds, "{name}");
        }
    }
}
