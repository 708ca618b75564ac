//! The parameters of an arm: their names and *the* order. Everything else asks this file.

use crate::robot::{JointKind, Robot};

/// One of the ten inertial parameters of a body, in the paper's order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Inertial {
    /// Mass, kg.
    M,
    /// First moments, kg m.
    MSX,
    /// First moments, kg m.
    MSY,
    /// First moments, kg m.
    MSZ,
    /// Tensor, kg m^2.
    XX,
    /// Tensor, kg m^2.
    YY,
    /// Tensor, kg m^2.
    ZZ,
    /// Tensor, kg m^2.
    XY,
    /// Tensor, kg m^2.
    XZ,
    /// Tensor, kg m^2.
    YZ,
}

impl Inertial {
    /// All ten, in order.
    pub const ALL: [Self; 10] =
        [Self::M, Self::MSX, Self::MSY, Self::MSZ, Self::XX, Self::YY, Self::ZZ, Self::XY, Self::XZ, Self::YZ];

    /// The symbol, as robot files and groupings write it.
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

    /// Unit.
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
    /// Rotor inertia, link side of the gear, kg m^2.
    IA,
    /// Viscous friction, N m s/rad.
    FV,
    /// Coulomb friction, N m.
    FC,
    /// Offset, N m.
    FO,
}

impl DriveTerm {
    /// All, in the order of the regressor's columns.
    pub const ALL: [Self; 4] = [Self::IA, Self::FV, Self::FC, Self::FO];

    /// The symbol.
    pub fn name(self) -> &'static str {
        match self {
            Self::IA => "IA",
            Self::FV => "FV",
            Self::FC => "FC",
            Self::FO => "FO",
        }
    }
}

/// A standard parameter: what it is and of which row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Parameter {
    /// Of the link of this row (from 0).
    Link(usize, Inertial),
    /// Of the drive of this row (from 0).
    Drive(usize, DriveTerm),
}

impl Parameter {
    /// Name as it is printed, rows from 1: `XX2`, `FV3`.
    pub fn name(&self) -> String {
        match self {
            Self::Link(row, p) => format!("{}{}", p.name(), row + 1),
            Self::Drive(row, p) => format!("{}{}", p.name(), row + 1),
        }
    }

    /// Unit for a table. For a prismatic joint N stands for N m.
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

/// Every standard parameter of the robot in the order of the regressor's columns: all links, then
/// all `IA`, `FV`, `FC`, `FO` that the file's drives have.
pub fn standard(robot: &Robot) -> Vec<Parameter> {
    let links = (0..robot.joints.len()).flat_map(|row| Inertial::ALL.map(|p| Parameter::Link(row, p)));
    let drives = DriveTerm::ALL.into_iter().flat_map(|term| {
        (0..robot.joints.len())
            .filter(move |&row| drive_value(robot, row, term).is_some())
            .map(move |row| Parameter::Drive(row, term))
    });
    links.chain(drives).collect()
}

/// The file's value of a drive parameter; `None` where the model does not have it.
pub fn drive_value(robot: &Robot, row: usize, term: DriveTerm) -> Option<f64> {
    let drive = &robot.joints[row].drive;
    match term {
        DriveTerm::IA => drive.rotor_inertia,
        DriveTerm::FV => drive.viscous_friction,
        DriveTerm::FC => drive.coulomb_friction,
        DriveTerm::FO => drive.offset,
    }
}

/// Values of [`standard`] from the file, tool folded into the last link; `None` where a link's are
/// unknown.
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
