//! Maps the channels of a file to the columns of the log format and converts their units.

pub use dh_codegen::robot::{LogChannel as Channel, LogMapping as Mapping};

use super::{Layout, LogError, MappingError, Role, unit};

/// A joint with the coordinates of the file from which the robot file was made, where `q = sign *
/// q_source + offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct SourceJoint {
    /// Name of the joint in that file.
    pub name: String,
    /// Sign, 1 or -1.
    pub sign: f64,
    /// Offset, rad or m.
    pub offset: f64,
}

/// Settings for reading the columns of a log.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Reading {
    /// Mapping of channels to columns; `None`: columns have the names of the log format or of the
    /// joints.
    pub mapping: Option<Mapping>,
    /// Moving joints of the robot from base to tip; empty if unknown.
    pub joints: Vec<SourceJoint>,
}

/// A column of a file that is used.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Used {
    role: Role,
    position: usize,
    conversion: [f64; 2],
}

impl Reading {
    /// Layout of the columns, and scale and offset of each.
    ///
    /// # Errors
    /// If a required column is missing, or a mapping names a channel that the file lacks.
    pub fn layout<S: AsRef<str>>(&self, file: &str, header: &[S]) -> Result<(Layout, Vec<[f64; 2]>), LogError> {
        let names: Vec<&str> = header
            .iter()
            .map(|n| n.as_ref().trim_matches(|c: char| c.is_whitespace() || c == '"' || c == '\u{feff}'))
            .collect();
        let mut used = match &self.mapping {
            Some(mapping) => self.mapped(mapping, &names).map_err(|e| LogError::mapping(file, e))?,
            None => self.named(file, &names)?,
        };
        used.sort_by_key(|u| u.position);
        let columns = used.iter().map(|u| (u.role, u.position)).collect();
        let layout = Layout::of_columns(file, &names, columns)?;
        // Columns that the layout drops (joint number above any arm's) have no conversion.
        let of = |role: &Role| used.iter().find(|u| u.role == *role).map_or([1.0, 0.0], |u| u.conversion);
        let conversions = layout.roles.iter().map(of).collect();
        Ok((layout, conversions))
    }

    /// Columns named by the log format, optionally with a unit in brackets; by joint name
    /// (`q_elbow`); or as channels of a bag (`/joint_states/position/elbow`).
    fn named(&self, file: &str, names: &[&str]) -> Result<Vec<Used>, LogError> {
        let mut used = Vec::new();
        for (position, name) in names.iter().enumerate() {
            let (plain, given) = unit::split(name);
            let by_number = element(plain, given).or_else(|| Role::of(plain)).map(|role| (role, [1.0, 0.0]));
            let Some((role, conversion)) = by_number.or_else(|| self.by_joint(plain)) else { continue };
            let factor = match given.filter(|_| element(plain, given).is_none()) {
                Some(text) => unit::scale(text, role).map_err(|e| LogError::Unit {
                    file: file.into(),
                    column: (*name).into(),
                    source: Box::new(e),
                })?,
                None => 1.0,
            };
            used.push(Used { role, position, conversion: [conversion[0] * factor, conversion[1]] });
        }
        if !used.iter().any(|u| matches!(u.role, Role::Joint(super::Quantity::Q, _))) {
            let channels = super::ros::columns(names, &self.joints).map_err(|e| LogError::mapping(file, e))?;
            for (role, position) in channels {
                used.push(Used { role, position, conversion: self.source_conversion(role) });
            }
        }
        Ok(used)
    }

    /// Column named by a quantity's prefix and a joint's name: `q_elbow`, `tau_elbow`.
    fn by_joint(&self, name: &str) -> Option<(Role, [f64; 2])> {
        let (prefix, joint) = name.split_once('_')?;
        let quantity = super::Quantity::ALL.iter().find(|(_, p)| *p == prefix)?.0;
        let role = Role::Joint(quantity, self.joints.iter().position(|j| j.name == joint)?);
        Some((role, self.source_conversion(role)))
    }

    /// Scale and offset from the coordinates of the source file to those of the DH table.
    fn source_conversion(&self, role: Role) -> [f64; 2] {
        use super::Quantity as Q;
        match role {
            Role::Joint(quantity, joint) => match (quantity, self.joints.get(joint)) {
                (Q::Temperature, _) | (_, None) => [1.0, 0.0],
                (Q::Q | Q::Qm | Q::Qd, Some(source)) => [source.sign, source.offset],
                (_, Some(source)) => [source.sign, 0.0],
            },
            _ => [1.0, 0.0],
        }
    }

    /// Columns selected by a mapping. Channels named by joint are in the source file's coordinates.
    fn mapped(&self, mapping: &Mapping, names: &[&str]) -> Result<Vec<Used>, MappingError> {
        let mut used: Vec<Used> = Vec::new();
        for (column, channel) in &mapping.columns {
            for (role, joint) in self.roles(column, channel, names)? {
                let name = self.name_of(channel, joint)?;
                let position = names.iter().position(|n| *n == name).ok_or_else(|| absent(column, &name, names))?;
                let conversion = self.conversion(channel, role, joint, column)?;
                if used.iter().any(|u| u.role == role) {
                    return Err(MappingError::Twice(role.name()));
                }
                used.push(Used { role, position, conversion });
            }
        }
        if !used.iter().any(|u| u.role == Role::Time)
            && let Some(position) = names.iter().position(|n| *n == "t")
        {
            used.push(Used { role: Role::Time, position, conversion: [1.0, 0.0] });
        }
        Ok(used)
    }

    /// Roles of a mapping entry with their joints: one, or one for each joint.
    fn roles(&self, column: &str, channel: &Channel, names: &[&str]) -> Result<Vec<(Role, usize)>, MappingError> {
        let Some(prefix) = column.strip_suffix('*') else {
            let role = Role::of(column).ok_or_else(|| MappingError::NoColumn(column.into()))?;
            let joint = if let Role::Joint(_, joint) = role { joint } else { 0 };
            return Ok(vec![(role, joint)]);
        };
        let quantity = super::Quantity::ALL
            .iter()
            .find(|(_, p)| *p == prefix)
            .ok_or_else(|| MappingError::NoJointColumn(column.into()))?
            .0;
        let joints = if self.joints.is_empty() {
            let there = |joint: &usize| self.name_of(channel, *joint).is_ok_and(|name| names.contains(&name.as_str()));
            (0..64).take_while(there).count().max(1)
        } else {
            self.joints.len()
        };
        if !["{joint}", "{number}", "{index}"].iter().any(|p| channel.name.contains(p)) && joints > 1 {
            return Err(MappingError::OneChannel(column.into()));
        }
        Ok((0..joints).map(|joint| (Role::Joint(quantity, joint), joint)).collect())
    }

    /// Name of the channel for a joint.
    fn name_of(&self, channel: &Channel, joint: usize) -> Result<String, MappingError> {
        let mut name = channel.name.clone();
        if name.contains("{joint}") {
            let source = self.joints.get(joint).ok_or(MappingError::NoRobot)?;
            name = name.replace("{joint}", &source.name);
        }
        Ok(name.replace("{number}", &(joint + 1).to_string()).replace("{index}", &joint.to_string()))
    }

    fn conversion(&self, channel: &Channel, role: Role, joint: usize, column: &str) -> Result<[f64; 2], MappingError> {
        let of = |values: &[f64], default: f64, what: &'static str| match values {
            [] => Ok(default),
            [one] => Ok(*one),
            many => many.get(joint).copied().ok_or_else(|| {
                let column = column.to_string();
                MappingError::Values { column, count: many.len(), what }
            }),
        };
        let factor = channel.unit.as_deref().map_or(Ok(1.0), |unit| unit::scale(unit, role))?;
        let (gain, offset) = (of(&channel.gain, 1.0, "gain")?, of(&channel.offset, 0.0, "offset")?);
        let [sign, shift] = if channel.name.contains("{joint}") { self.source_conversion(role) } else { [1.0, 0.0] };
        Ok([sign * gain * factor, sign * offset + shift])
    }
}

/// Element of an array of a joint quantity, counted from 0: `q[0]`.
fn element(name: &str, index: Option<&str>) -> Option<Role> {
    let joint = index?.parse().ok()?;
    let quantity = super::Quantity::ALL.iter().find(|(_, p)| *p == name)?.0;
    Some(Role::Joint(quantity, joint))
}

/// Error for a missing channel, with the most similar names of the log.
fn absent(column: &str, name: &str, names: &[&str]) -> MappingError {
    let near = |n: &&&str| {
        let (a, b) = (n.to_lowercase(), name.to_lowercase());
        a.contains(&b) || b.contains(&a)
    };
    let mut shown: Vec<String> = names.iter().filter(near).take(5).map(ToString::to_string).collect();
    if shown.is_empty() {
        shown = names.iter().take(8).map(ToString::to_string).collect();
    }
    let more = shown.len() < names.len();
    MappingError::Absent { column: column.into(), channel: name.into(), near: shown, more }
}
