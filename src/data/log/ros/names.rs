//! Maps channels of a recording to joints by name: `/joint_states/position/elbow`.

use crate::data::log::{MappingError, Quantity, Role, SourceJoint};

/// Quantity named by a path element of a channel.
fn quantity(part: &str) -> Option<Quantity> {
    Some(match part {
        "position" | "positions" => Quantity::Q,
        "velocity" | "velocities" => Quantity::Dq,
        "acceleration" | "accelerations" => Quantity::Ddq,
        "effort" | "efforts" | "torque" => Quantity::Tau,
        "current" | "motor_current" => Quantity::Current,
        "temperature" | "motor_temperature" => Quantity::Temperature,
        _ => return None,
    })
}

/// A channel of a joint: topic (with path in the message), quantity and joint name.
struct JointChannel<'a> {
    group: &'a str,
    quantity: Quantity,
    joint: &'a str,
    position: usize,
}

/// Parses `GROUP/position/JOINT` or `GROUP/JOINT/position`.
fn joint_channel(name: &str, position: usize) -> Option<JointChannel<'_>> {
    let rest = name.strip_prefix('/').map(|_| name)?;
    let (front, last) = rest.rsplit_once('/')?;
    let (group, middle) = front.rsplit_once('/')?;
    let (found, joint) = match (quantity(middle), quantity(last)) {
        (Some(found), _) => (found, last),
        (None, Some(found)) => (found, middle),
        _ => return None,
    };
    let part = group.rsplit('/').next().unwrap_or("");
    let found = match part {
        "desired" | "reference" if found == Quantity::Q => Quantity::Qd,
        "desired" | "reference" | "error" | "output" => return None,
        _ => found,
    };
    (!group.is_empty()).then_some(JointChannel { group, quantity: found, joint, position })
}

/// Roles of a recording's channels. A quantity is used if one group has it for all joints; the
/// group that has the positions is preferred.
///
/// # Errors
/// If positions of all joints are on several topics, or joints are not found.
pub(crate) fn columns(names: &[&str], joints: &[SourceJoint]) -> Result<Vec<(Role, usize)>, MappingError> {
    let channels: Vec<JointChannel<'_>> = names.iter().enumerate().filter_map(|(i, n)| joint_channel(n, i)).collect();
    if channels.is_empty() {
        return Ok(Vec::new());
    }
    if joints.is_empty() {
        return Err(MappingError::NamedJoints(found(&channels)));
    }
    // Columns of a quantity for all joints on one topic.
    let complete = |group: &str, quantity: Quantity| -> Option<Vec<(Role, usize)>> {
        joints
            .iter()
            .enumerate()
            .map(|(i, joint)| {
                let fits = |c: &&JointChannel<'_>| c.group == group && c.quantity == quantity && c.joint == joint.name;
                channels.iter().find(fits).map(|c| (Role::Joint(quantity, i), c.position))
            })
            .collect()
    };
    let mut groups: Vec<&str> = Vec::new();
    for channel in &channels {
        if !groups.contains(&channel.group) {
            groups.push(channel.group);
        }
    }
    let with = |quantity: Quantity| -> Vec<&str> {
        groups.iter().filter(|g| complete(g, quantity).is_some()).copied().collect()
    };
    let of_positions = match with(Quantity::Q).as_slice() {
        [] => {
            let expected = joints.iter().map(|j| j.name.clone()).collect();
            return Err(MappingError::OtherJoints { recorded: found(&channels), expected });
        }
        [one] => *one,
        several => return Err(MappingError::SeveralTopics(several.iter().map(ToString::to_string).collect())),
    };
    let mut columns = Vec::new();
    if let Some(position) = names.iter().position(|n| *n == "t") {
        columns.push((Role::Time, position));
    }
    for (quantity, _) in Quantity::ALL {
        let here = complete(of_positions, quantity).or_else(|| match with(quantity).as_slice() {
            [one] => complete(one, quantity),
            _ => None,
        });
        columns.extend(here.into_iter().flatten());
    }
    Ok(columns)
}

/// Names of joints without duplicates, at most 20.
fn found(channels: &[JointChannel<'_>]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for channel in channels {
        if !names.iter().any(|n| n == channel.joint) && names.len() < 20 {
            names.push(channel.joint.into());
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joints(names: &[&str]) -> Vec<SourceJoint> {
        names.iter().map(|n| SourceJoint { name: (*n).into(), sign: 1.0, offset: 0.0 }).collect()
    }

    #[test]
    fn joints_are_matched_by_name_in_any_order() {
        let names = ["t", "/js/position/b", "/js/position/a", "/js/effort/b", "/js/effort/a", "/io/x"];
        let found = columns(&names, &joints(&["a", "b"])).unwrap();
        let q = |j| Role::Joint(Quantity::Q, j);
        let tau = |j| Role::Joint(Quantity::Tau, j);
        assert_eq!(found, [(Role::Time, 0), (q(0), 2), (q(1), 1), (tau(0), 4), (tau(1), 3)]);
    }

    #[test]
    fn desired_positions_are_no_positions() {
        let names = ["t", "/c/desired/positions/a", "/c/actual/positions/a", "/c/error/positions/a"];
        let found = columns(&names, &joints(&["a"])).unwrap();
        assert!(found.contains(&(Role::Joint(Quantity::Q, 0), 2)));
        assert!(!found.iter().any(|(_, p)| *p == 3));
    }

    #[test]
    fn two_topics_with_positions_are_a_question() {
        let names = ["/a/position/j", "/b/position/j"];
        let refused = |known: &[&str]| columns(&names, &joints(known)).unwrap_err().to_string();
        assert!(refused(&["j"]).contains("/a and /b"));
        assert!(refused(&["k"]).contains("k are not in the recording"));
        assert!(refused(&[]).contains("--robot"));
    }
}
