//! External wrenches on the tool and on links.

use nalgebra::Vector6;

use super::effects::ExternalContact;
use crate::model::far_end::FarEnd;
use crate::model::rigid_body::Numeric;
use dh_codegen::robot::Robot;

/// A wrench on the tool, with its stiffness and damping.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Wrench {
    /// Force (N) and moment (N m) on the tool, about the origin of its frame, world axes.
    pub wrench: [f64; 6],
    /// Minus the derivative of the force with respect to the origin's position, N/m. Used by the
    /// implicit integrator only: it may be approximate, or zero for a soft contact.
    pub stiffness: [[f64; 3]; 3],
    /// Minus the derivative of the force with respect to the origin's velocity, N s/m.
    pub damping: [[f64; 3]; 3],
}

/// External interaction with the tool, such as a wall, a hand or a spring. Closures with the
/// signature of [`External::wrench`] implement it.
pub trait External: Sync {
    /// Wrench at time `t` (s) on a tool with the given pose and twist. `pose` is the top three rows
    /// of the tool's homogeneous matrix; `twist` is the velocity of its origin and its angular
    /// velocity. Both are in world axes.
    fn wrench(&self, t: f64, pose: &[f64; 12], twist: &[f64; 6]) -> Wrench;
}

impl<F: Fn(f64, &[f64; 12], &[f64; 6]) -> Wrench + Sync> External for F {
    fn wrench(&self, t: f64, pose: &[f64; 12], twist: &[f64; 6]) -> Wrench {
        self(t, pose, twist)
    }
}

/// A compliant plane with the damping of Hunt and Crossley (J. Applied Mechanics 42, 1975). The
/// force along the normal is `k d (1 + c d')` while the tool's origin is at depth `d`. It begins
/// and ends at zero and never pulls. Coulomb friction resists sliding, smoothed below the speed
/// `creep`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wall {
    /// A point on the plane, world axes, m.
    pub point: [f64; 3],
    /// Unit normal, pointing out of the wall.
    pub normal: [f64; 3],
    /// `k`, N/m.
    pub stiffness: f64,
    /// `c`, s/m.
    pub damping: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Speed below which friction is viscous, m/s.
    pub creep: f64,
}

impl Wall {
    /// A stiff plane: 20 kN/m, as a rubber roller on plaster.
    pub fn new(point: [f64; 3], normal: [f64; 3]) -> Self {
        let length = normal.iter().map(|n| n * n).sum::<f64>().sqrt();
        Self { point, normal: normal.map(|n| n / length), stiffness: 2e4, damping: 0.5, friction: 0.0, creep: 1e-2 }
    }
}

impl External for Wall {
    fn wrench(&self, _: f64, pose: &[f64; 12], twist: &[f64; 6]) -> Wrench {
        let n = self.normal;
        let depth: f64 = (0..3).map(|k| n[k] * (self.point[k] - pose[4 * k + 3])).sum();
        let normal_speed: f64 = (0..3).map(|k| n[k] * twist[k]).sum();
        let mut result = Wrench::default();
        let factor = 1.0 - self.damping * normal_speed; // d' = -normal_speed
        if depth <= 0.0 || factor <= 0.0 {
            return result;
        }
        let press = self.stiffness * depth * factor;
        let sliding: [f64; 3] = std::array::from_fn(|k| twist[k] - normal_speed * n[k]);
        let speed = (sliding.iter().map(|v| v * v).sum::<f64>() + self.creep * self.creep).sqrt();
        let drag = self.friction * press / speed;
        for i in 0..3 {
            result.wrench[i] = press * n[i] - drag * sliding[i];
            for k in 0..3 {
                let along = n[i] * n[k];
                let across = if i == k { 1.0 - along } else { -along };
                result.stiffness[i][k] = self.stiffness * factor * along;
                result.damping[i][k] = self.stiffness * depth * self.damping * along + drag * across;
            }
        }
        result
    }
}

/// The points of the links that contacts touch.
#[derive(Clone)]
pub(super) struct Links {
    numeric: Numeric,
    far_ends: Vec<FarEnd>,
}

impl Links {
    pub(super) fn of(robot: &Robot) -> Self {
        let far_ends = (0..robot.joints.len()).map(|row| FarEnd::of(robot, row)).collect();
        Self { numeric: Numeric::new(robot), far_ends }
    }
}

/// Contacts that the robot file states, with the links that they touch.
pub(super) struct Contacts {
    pub(super) stated: Vec<ExternalContact>,
    pub(super) links: Links,
}

impl Contacts {
    /// Whether one of them can act at this time.
    pub(super) fn act(&self, t: f64) -> bool {
        self.stated.iter().any(|contact| contact.acts(t))
    }

    /// Passes joints and torques, N m, of the wrenches on links at a time, `J' w`, to `add`.
    pub(super) fn add_on_links(&self, t: f64, q: &[f64], mut add: impl FnMut(usize, f64)) {
        let touching = |contact: &ExternalContact| Some((*contact, *self.links.far_ends.get(contact.link?)?));
        for (contact, FarEnd { row, point }) in self.stated.iter().filter_map(touching) {
            let (pose, jacobian) = self.links.numeric.point_and_jacobian(q, row, point);
            let mut wrench = Vector6::from(contact.wrench) * contact.share(t);
            if !contact.in_base {
                let turn = pose.fixed_view::<3, 3>(0, 0);
                for part in [0, 3] {
                    let turned = turn * wrench.fixed_rows::<3>(part);
                    wrench.fixed_rows_mut::<3>(part).copy_from(&turned);
                }
            }
            (jacobian.transpose() * wrench).iter().enumerate().for_each(|(joint, torque)| add(joint, *torque));
        }
    }

    /// Sum of all external wrenches on the tool at a time, world axes.
    pub(super) fn total(&self, external: &[&dyn External], t: f64, pose: &[f64; 12], twist: &[f64; 6]) -> Wrench {
        let mut sum = Wrench::default();
        for contact in self.stated.iter().filter(|contact| contact.link.is_none()) {
            let share = contact.share(t);
            let wrench = if contact.in_base { contact.wrench } else { in_base(pose, &contact.wrench) };
            sum.wrench.iter_mut().zip(wrench).for_each(|(total, part)| *total += share * part);
        }
        let walls = self.stated.iter().filter_map(|contact| contact.wall.as_ref()).map(|wall| wall as &dyn External);
        for external in external.iter().copied().chain(walls) {
            let answer = external.wrench(t, pose, twist);
            (0..6).for_each(|i| sum.wrench[i] += answer.wrench[i]);
            for i in 0..3 {
                for k in 0..3 {
                    sum.stiffness[i][k] += answer.stiffness[i][k];
                    sum.damping[i][k] += answer.damping[i][k];
                }
            }
        }
        sum
    }
}

/// Rotates a wrench from world axes into those of the tool.
pub(super) fn in_tool(pose: &[f64; 12], wrench: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|i| {
        let (column, from) = (i % 3, 3 * (i / 3));
        (0..3).map(|k| pose[4 * k + column] * wrench[from + k]).sum()
    })
}

/// Rotates a wrench from the axes of the tool into those of the base.
pub(super) fn in_base(pose: &[f64; 12], wrench: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|i| {
        let (row, from) = (i % 3, 3 * (i / 3));
        (0..3).map(|k| pose[4 * row + k] * wrench[from + k]).sum()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Friction opposes the sliding velocity and is perpendicular to the normal.
    #[test]
    fn a_wall_holds_back_what_slides_on_it() {
        let wall = Wall { friction: 0.4, damping: 0.0, ..Wall::new([0.0; 3], [0.0, 0.0, 1.0]) };
        let pose = [1.0, 0.0, 0.0, 0.3, 0.0, 1.0, 0.0, 0.1, 0.0, 0.0, 1.0, -1e-3];
        let [x, y, z, ..] = wall.wrench(0.0, &pose, &[3.0, -4.0, 0.0, 0.0, 0.0, 0.0]).wrench;
        assert!((x + 4.8).abs() < 1e-4 && (y - 6.4).abs() < 1e-4 && (z - 20.0).abs() < 1e-9, "{x} {y} {z}");
    }
}
