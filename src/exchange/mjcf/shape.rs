//! Inertia of simple shapes, as the format defines it for bodies without `inertial`.

use core::f64::consts::PI;

use dh_codegen::robot::Inertia;
use nalgebra::Vector3;

use super::super::tree::Displacement;
use super::super::xml::Element;
use super::Reader;
use super::orientation::onto;

/// Default density, kg/m^3.
const DENSITY: f64 = 1000.0;

impl<'a> Reader<'a, '_> {
    /// Inertia of a geom in its body's frame; `None` if it is not known from the file alone (a
    /// mesh).
    pub(super) fn geom(&mut self, geom: Element<'a>, class: Option<&'a str>) -> Option<Inertia> {
        let value = |name: &str| self.settings.value(geom, "geom", class, name);
        let mesh = value("mesh").is_some();
        let kind = value("type").map_or(if mesh { "mesh" } else { "sphere" }, |v| v.text);
        let shell = value("shellinertia").is_some_and(|v| v.text == "true");
        let [mass, density, size, fromto] = ["mass", "density", "size", "fromto"].map(value);
        let mut number = |v: Option<super::Value<'a>>| v.and_then(|v| self.found.number(v.at, v.name));
        let (mass, density) = (number(mass), number(density).unwrap_or(DENSITY));
        if mass.map_or(density, |m| m) == 0.0 || ["plane", "hfield"].contains(&kind) {
            return Some(Inertia::default());
        }
        if shell || mesh {
            return None;
        }
        let mut size = size.and_then(|v| self.found.list(v.at, v.name)).unwrap_or_default();
        let mut at = self.pose(geom, "geom", class)?;
        if let Some(v) = fromto {
            let [a, b, c, d, e, f] = self.found.numbers::<6>(v.at, v.name)?;
            let (from, to) = (Vector3::new(a, b, c), Vector3::new(d, e, f));
            let half = (to - from).norm() / 2.0;
            at = Displacement { origin: (from + to) / 2.0, ..onto(to - from) };
            let width = *size.first()?;
            size = if ["box", "ellipsoid"].contains(&kind) { vec![width, width, half] } else { vec![width, half] };
        }
        at = self.frames(geom)?.then(&at);
        let (volume, unit) = solid(kind, &size).or_else(|| {
            let what = format!("a geom `{kind}` of {} size(s) is not known", size.len());
            self.found.element(geom, what, "correct its type or size");
            None
        })?;
        let m = mass.unwrap_or(density * volume);
        let [x, y, z] = unit;
        let own = Inertia { m, ms: [0.0; 3], i: [m * x, m * y, m * z, 0.0, 0.0, 0.0] };
        Some(own.moved(&at.rows(), &at.origin.into()))
    }

    /// Pose of the `frame` elements between an element and its body.
    fn frames(&mut self, element: Element<'a>) -> Option<Displacement> {
        let mut all = Displacement::identity();
        let frames: Vec<Element<'a>> =
            element.ancestors().skip(1).take_while(|n| n.is_element() && n.tag_name().name() == "frame").collect();
        for frame in frames {
            all = self.pose(frame, "frame", None)?.then(&all);
        }
        Some(all)
    }
}

/// Volume, m^3, and principal moments per mass, m^2, of a solid with these half sizes, m.
fn solid(kind: &str, size: &[f64]) -> Option<(f64, [f64; 3])> {
    let ball = 4.0 / 3.0 * PI;
    Some(match (kind, size) {
        ("sphere", [r, ..]) => (ball * r.powi(3), [0.4 * r * r; 3]),
        ("box", [a, b, c, ..]) => {
            (8.0 * a * b * c, [(b * b + c * c) / 3.0, (a * a + c * c) / 3.0, (a * a + b * b) / 3.0])
        }
        ("ellipsoid", [a, b, c, ..]) => {
            (ball * a * b * c, [(b * b + c * c) / 5.0, (a * a + c * c) / 5.0, (a * a + b * b) / 5.0])
        }
        ("cylinder", [r, half, ..]) => {
            let across = (3.0 * r * r + 4.0 * half * half) / 12.0;
            (2.0 * PI * r * r * half, [across, across, r * r / 2.0])
        }
        ("capsule", [r, half, ..]) => {
            let height = 2.0 * half;
            let ends = 4.0 * r / (4.0 * r + 3.0 * height);
            let middle = 1.0 - ends;
            let across = middle * (3.0 * r * r + height * height) / 12.0
                + ends * (0.4 * r * r + height * height / 4.0 + 3.0 * height * r / 8.0);
            let along = middle * r * r / 2.0 + ends * 0.4 * r * r;
            (PI * r * r * height + ball * r.powi(3), [across, across, along])
        }
        _ => return None,
    })
}
