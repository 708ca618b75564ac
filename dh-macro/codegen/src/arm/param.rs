//! Names and order of an arm's parameters; the only definition of both.

use crate::robot::{JointKind, Robot};

/// One of the ten inertial parameters of a body, in the paper's order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Inertial {
    /// Mass, kg.
    M,
    /// First moment about the origin, x, kg m.
    MSX,
    /// First moment about the origin, y, kg m.
    MSY,
    /// First moment about the origin, z, kg m.
    MSZ,
    /// Entry XX of the inertia tensor, kg m^2.
    XX,
    /// Entry YY of the inertia tensor, kg m^2.
    YY,
    /// Entry ZZ of the inertia tensor, kg m^2.
    ZZ,
    /// Entry XY of the inertia tensor, kg m^2.
    XY,
    /// Entry XZ of the inertia tensor, kg m^2.
    XZ,
    /// Entry YZ of the inertia tensor, kg m^2.
    YZ,
}

impl Inertial {
    /// All ten, in order.
    pub const ALL: [Self; 10] =
        [Self::M, Self::MSX, Self::MSY, Self::MSZ, Self::XX, Self::YY, Self::ZZ, Self::XY, Self::XZ, Self::YZ];

    /// Symbol in robot files and groupings.
    pub fn name(self) -> &'static str {
        match self {
            Self::M => "M",
            Self::MSX => "MSX",
            Self::MSY => "MSY",
            Self::MSZ => "MSZ",
            Self::XX => "XX",
            Self::YY => "YY",
            Self::ZZ => "ZZ",
            Self::XY => "XY",
            Self::XZ => "XZ",
            Self::YZ => "YZ",
        }
    }

    /// Unit of the parameter.
    pub fn unit(self) -> &'static str {
        match self {
            Self::M => "kg",
            Self::MSX | Self::MSY | Self::MSZ => "kg m",
            _ => "kg m^2",
        }
    }
}

/// A drive parameter that the model may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DriveTerm {
    /// Rotor inertia on the link side of the gear, kg m^2.
    IA,
    /// Viscous friction, N m s/rad.
    FV,
    /// Coulomb friction, N m.
    FC,
    /// Torque offset, N m.
    FO,
}

impl DriveTerm {
    /// All terms, in the order of the regressor's columns.
    pub const ALL: [Self; 4] = [Self::IA, Self::FV, Self::FC, Self::FO];

    /// Symbol of the term.
    pub fn name(self) -> &'static str {
        match self {
            Self::IA => "IA",
            Self::FV => "FV",
            Self::FC => "FC",
            Self::FO => "FO",
        }
    }
}

/// A standard parameter, with its row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Parameter {
    /// Parameter of the link of this row (from 0).
    Link(usize, Inertial),
    /// Parameter of the drive of this row (from 0).
    Drive(usize, DriveTerm),
}

impl Parameter {
    /// Printed name, with rows counted from 1: `XX2`, `FV3`.
    pub fn name(&self) -> String {
        match self {
            Self::Link(row, p) => format!("{}{}", p.name(), row + 1),
            Self::Drive(row, p) => format!("{}{}", p.name(), row + 1),
        }
    }

    /// Unit for a table. For a prismatic joint N replaces N m.
    pub fn unit(&self, robot: &Robot) -> &'static str {
        let prismatic = |row: usize| robot.joints[row].kind == JointKind::Prismatic;
        match *self {
            Self::Link(_, which) => which.unit(),
            Self::Drive(row, DriveTerm::IA) if prismatic(row) => "kg",
            Self::Drive(row, DriveTerm::FV) if prismatic(row) => "N s/m",
            Self::Drive(row, _) if prismatic(row) => "N",
            Self::Drive(_, DriveTerm::IA) => "kg m^2",
            Self::Drive(_, DriveTerm::FV) => "N m s/rad",
            Self::Drive(..) => "N m",
        }
    }
}

/// Standard parameters of the robot in the order of the regressor's columns: all links, then all
/// `IA`, `FV`, `FC`, `FO` that the file's drives have.
pub fn standard(robot: &Robot) -> Vec<Parameter> {
    let links = (0..robot.joints.len()).flat_map(|row| Inertial::ALL.map(|p| Parameter::Link(row, p)));
    let drives = DriveTerm::ALL.into_iter().flat_map(|term| {
        (0..robot.joints.len())
            .filter(move |&row| drive_value(robot, row, term).is_some())
            .map(move |row| Parameter::Drive(row, term))
    });
    links.chain(drives).collect()
}

/// Value of a drive parameter in the file; `None` if the model lacks it.
pub fn drive_value(robot: &Robot, row: usize, term: DriveTerm) -> Option<f64> {
    let drive = &robot.joints[row].drive;
    match term {
        DriveTerm::IA => drive.rotor_inertia,
        DriveTerm::FV => drive.viscous_friction,
        DriveTerm::FC => drive.coulomb_friction,
        DriveTerm::FO => drive.offset,
    }
}

/// Values of [`standard`] from the file, with the tool added to the last link; `None` if a link's
/// parameters are unknown.
pub fn standard_values(robot: &Robot) -> Option<Vec<f64>> {
    let inertias = robot.inertias()?;
    Some(
        standard(robot)
            .iter()
            .map(|p| match *p {
                Parameter::Link(row, which) => inertias[row].to_array()[which as usize],
                Parameter::Drive(row, term) => drive_value(robot, row, term).unwrap_or(0.0),
            })
            .collect(),
    )
}
