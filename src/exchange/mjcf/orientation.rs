//! Poses: `pos`, and the five ways to write an orientation.

use nalgebra::Vector3;

use super::super::exact::Snap;
use super::super::tree::Displacement;
use super::super::xml::Element;
use super::{Reader, from_columns};

impl<'a> Reader<'a, '_> {
    /// Position and orientation of an element in its body; `None` if they are invalid.
    pub(super) fn pose(&mut self, element: Element<'a>, tag: &str, class: Option<&'a str>) -> Option<Displacement> {
        let value = |name: &str| self.settings.value(element, tag, class, name);
        let before = self.found.0.len();
        let pos = value("pos").map(|v| self.found.place(v.at, v.name));
        let [quat, axis_angle, axes, z, euler] = ["quat", "axisangle", "xyaxes", "zaxis", "euler"].map(value);
        let unit = self.settings.angle;
        let turned = if let Some(v) = quat {
            self.found.numbers::<4>(v.at, v.name).map(|q| self.snap.rotation(Displacement::quaternion(q)))
        } else if let Some(v) = axis_angle {
            let [x, y, z, angle] = self.found.numbers::<4>(v.at, v.name).unwrap_or([0.0, 0.0, 1.0, 0.0]);
            let axis = Vector3::from(self.snap.direction([x, y, z]));
            Some(self.exact_turn(&axis, angle * unit))
        } else if let Some(v) = axes {
            self.found.numbers::<6>(v.at, v.name).map(|a| self.snap.rotation(square(a)))
        } else if let Some(v) = z {
            self.found.numbers::<3>(v.at, v.name).map(|z| self.snap.rotation(onto(z.into())))
        } else if let Some(v) = euler {
            self.found.numbers::<3>(v.at, v.name).map(|angles| {
                let letters: Vec<char> = self.settings.euler.chars().collect();
                let mut all = Displacement::identity();
                for (letter, angle) in letters.iter().zip(angles) {
                    let axis =
                        Vector3::from(["x", "y", "z"].map(|l| f64::from(l == letter.to_lowercase().to_string())));
                    let turn = self.exact_turn(&axis, angle * unit);
                    // Small letters rotate about the moved axes, capitals about the fixed ones.
                    all = if letter.is_lowercase() { all.then(&turn) } else { turn.then(&all) };
                }
                self.snap.rotation(all)
            })
        } else {
            Some(Displacement::identity())
        };
        let at = turned.unwrap_or_else(Displacement::identity);
        if !at.is_rotation() {
            self.found.element(element, "the orientation has no length", "write a quaternion or axis that is not zero");
        }
        let origin = pos.flatten().unwrap_or_default().into();
        (self.found.0.len() == before).then_some(Displacement { origin, ..at })
    }

    /// A rotation whose sine and cosine are exact at fractions of pi.
    fn exact_turn(&mut self, axis: &Vector3<f64>, angle: f64) -> Displacement {
        exact_turn(self.snap, axis, angle)
    }
}

fn exact_turn(snap: &mut Snap, axis: &Vector3<f64>, angle: f64) -> Displacement {
    let (s, c) = snap.angle(angle).sin_cos();
    let k = axis.cross_matrix();
    Displacement { rotation: nalgebra::Matrix3::identity() + k * s + k * k * (1.0 - c), origin: Vector3::zeros() }
}

/// Rotation from axes x and y, the latter made orthogonal to the former.
fn square([a, b, c, d, e, f]: [f64; 6]) -> Displacement {
    let x = Vector3::new(a, b, c).normalize();
    let y = Vector3::new(d, e, f);
    let y = (y - x * x.dot(&y)).normalize();
    from_columns(x, y, x.cross(&y))
}

/// The smallest rotation of z onto a direction.
pub(super) fn onto(z: Vector3<f64>) -> Displacement {
    let z = z.normalize();
    let axis = Vector3::z().cross(&z);
    let sine = axis.norm();
    if sine < 1e-10 {
        return if z.z > 0.0 {
            Displacement::identity()
        } else {
            Displacement::turn(&Vector3::x(), core::f64::consts::PI)
        };
    }
    Displacement::turn(&(axis / sine), sine.atan2(z.z))
}
