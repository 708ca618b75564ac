//! Bounds on the bodies given by the user, and priors that satisfy them.

use super::ConsistentError;
use crate::model::pseudo_inertia::is_body;

/// Bounds on links (counted from 0, in the order of the parameters). They apply to the link's own
/// body, without the bodies fixed to it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bounds {
    /// Smallest and largest mass of a link, kg.
    pub mass: Vec<(usize, [f64; 2])>,
    /// Box for the centre of mass in the link's frame: link, axis (0 x, 1 y, 2 z), smallest and
    /// largest coordinate, m.
    pub center: Vec<(usize, usize, [f64; 2])>,
    /// Total mass of all links, kg.
    pub total_mass: Option<f64>,
}

impl Bounds {
    fn mass_of(&self, link: usize) -> [f64; 2] {
        let all = self.mass.iter().filter(|b| b.0 == link).map(|b| b.1);
        all.fold([0.0, f64::INFINITY], |[a, b], [c, d]| [a.max(c), b.min(d)])
    }

    /// Rejects contradictory bounds.
    pub(super) fn check(&self, links: usize) -> Result<(), ConsistentError> {
        let bad = |what: String| Err(ConsistentError::Bounds { what });
        let named = self.mass.iter().map(|b| b.0).chain(self.center.iter().map(|b| b.0));
        if let Some(link) = named.into_iter().find(|l| *l >= links) {
            return bad(format!("link {} is bounded, but the arm has {links}", link + 1));
        }
        let ranges = self.mass.iter().map(|b| (b.0, b.1)).chain(self.center.iter().map(|b| (b.0, b.2)));
        for (link, [low, high]) in ranges {
            if low.is_nan() || high.is_nan() || low >= high {
                return bad(format!("link {}: the least value, {low}, is not below the largest, {high}", link + 1));
            }
        }
        let (mut least, mut most) = (0.0, 0.0);
        for link in 0..links {
            let [low, high] = self.mass_of(link);
            if low.is_nan() || high.is_nan() || low >= high {
                return bad(format!("link {}: bounds leave it no mass between {low} and {high} kg", link + 1));
            }
            (least, most) = (least + low, most + high);
        }
        match self.total_mass {
            Some(total) if !(total > least && total < most && total.is_finite()) => bad(format!(
                "a total of {total} kg can't be reached: the links' masses add up to between {least} and {most} kg"
            )),
            _ => Ok(()),
        }
    }

    /// Moves bodies inside the bounds: masses between their bounds, centres into their boxes, and
    /// masses scaled to the total. A body keeps its shape about its centre of mass (its tensor
    /// there grows with the mass).
    pub(super) fn enforce(&self, bodies: &mut [[f64; 10]]) -> Result<(), ConsistentError> {
        self.check(bodies.len())?;
        let inside = |x: f64, [low, high]: [f64; 2]| {
            let room = 0.05 * if high.is_finite() { high - low } else { low.abs().max(0.1) };
            if high.is_finite() { x.clamp(low + room, high - room) } else { x.max(low + room.min(0.5 * x)) }
        };
        let masses: Vec<f64> = bodies
            .iter()
            .enumerate()
            .map(|(link, body)| match self.mass.iter().any(|b| b.0 == link) {
                true => inside(body[0], self.mass_of(link)),
                false => body[0],
            })
            .collect();
        let masses = match self.total_mass {
            None => masses,
            Some(total) => {
                // Every link moves the same share of its distance to its bound.
                let sum: f64 = masses.iter().sum();
                let bound = |link: usize| self.mass_of(link)[usize::from(total > sum)];
                if total > sum && (0..masses.len()).any(|l| bound(l).is_infinite()) {
                    let open: f64 = (0..masses.len()).filter(|&l| bound(l).is_infinite()).map(|l| masses[l]).sum();
                    let factor = 1.0 + (total - sum) / open;
                    (0..masses.len())
                        .map(|l| if bound(l).is_infinite() { masses[l] * factor } else { masses[l] })
                        .collect()
                } else {
                    let way: f64 = (0..masses.len()).map(|l| bound(l) - masses[l]).sum();
                    let share = if way == 0.0 { 0.0 } else { (total - sum) / way };
                    (0..masses.len()).map(|l| masses[l] + share * (bound(l) - masses[l])).collect::<Vec<_>>()
                }
            }
        };
        for (link, (body, mass)) in bodies.iter_mut().zip(masses).enumerate() {
            let mut center = [body[1] / body[0], body[2] / body[0], body[3] / body[0]];
            let old = center;
            for &(_, axis, range) in self.center.iter().filter(|b| b.0 == link) {
                center[axis] = inside(center[axis], range);
            }
            if mass != body[0] || center != old {
                *body = placed(body, mass, center);
            }
            if !is_body(body) {
                return Err(ConsistentError::Bounds {
                    what: format!("link {}: no body could be placed inside", link + 1),
                });
            }
        }
        Ok(())
    }
}

/// Body of the same shape with another mass and centre of mass, m.
fn placed(body: &[f64; 10], mass: f64, center: [f64; 3]) -> [f64; 10] {
    let p = crate::model::pseudo_inertia::pseudo_inertia(body);
    let mut out = nalgebra::Matrix4::zeros();
    for i in 0..3 {
        for j in 0..3 {
            let about_center = p[(i, j)] - body[1 + i] * body[1 + j] / body[0];
            out[(i, j)] = about_center * mass / body[0] + mass * center[i] * center[j];
        }
        out[(i, 3)] = mass * center[i];
        out[(3, i)] = mass * center[i];
    }
    out[(3, 3)] = mass;
    crate::model::pseudo_inertia::body_of(&out)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BALL: [f64; 10] = [2.0, 0.2, 0.0, 0.0, 0.02, 0.04, 0.04, 0.0, 0.0, 0.0];

    #[test]
    fn bodies_are_moved_inside() {
        let bounds = Bounds {
            mass: vec![(0, [3.0, 4.0])],
            center: vec![(1, 0, [-0.1, 0.05]), (1, 2, [0.1, 0.2])],
            total_mass: Some(8.0),
        };
        let mut bodies = [BALL; 3];
        bounds.enforce(&mut bodies).unwrap();
        assert!((bodies.iter().map(|b| b[0]).sum::<f64>() - 8.0).abs() < 1e-12);
        assert!((3.0..4.0).contains(&bodies[0][0]) && bodies.iter().all(is_body));
        let center = [1, 3].map(|k| bodies[1][k] / bodies[1][0]);
        assert!(center[0] < 0.05 && center[1] > 0.1, "{center:?}");
        let mut lighter = [BALL; 3];
        Bounds { total_mass: Some(1.0), ..bounds.clone() }.enforce(&mut lighter).unwrap_err();
        Bounds { total_mass: Some(1.0), ..Bounds::default() }.enforce(&mut lighter).unwrap();
        assert!((lighter.iter().map(|b| b[0]).sum::<f64>() - 1.0).abs() < 1e-12 && lighter.iter().all(is_body));
    }

    /// About its centre the tensor grows with the mass, wherever the centre moves.
    #[test]
    fn a_body_that_is_placed_keeps_its_shape() {
        let about_center = |b: &[f64; 10]| {
            let [m, x, y, z, xx, yy, zz, xy, xz, yz] = *b;
            let (x2, y2, z2) = (x * x / m, y * y / m, z * z / m);
            let (xy2, xz2, yz2) = (x * y / m, x * z / m, y * z / m);
            [xx - y2 - z2, yy - x2 - z2, zz - x2 - y2, xy + xy2, xz + xz2, yz + yz2]
        };
        let body = [2.0, 0.2, -0.1, 0.3, 0.09, 0.1, 0.05, 0.012, -0.02, 0.01];
        let there = placed(&body, 5.0, [0.3, 0.2, -0.1]);
        assert!(there[0] == 5.0 && (there[1] - 1.5).abs() < 1e-12 && (there[3] + 0.5).abs() < 1e-12);
        for (there, here) in about_center(&there).iter().zip(about_center(&body)) {
            assert!((there - 2.5 * here).abs() < 1e-12, "{there} {here}");
        }
    }

    #[test]
    fn contradictions_are_named() {
        let with = |mass, total_mass| Bounds { mass, center: vec![], total_mass }.check(2).unwrap_err().to_string();
        assert!(with(vec![(0, [2.0, 1.0])], None).contains("link 1"));
        assert!(with(vec![(5, [1.0, 2.0])], None).contains("link 6"));
        assert!(with(vec![(0, [1.0, 2.0]), (1, [1.0, 2.0])], Some(5.0)).contains("5 kg"));
        assert!(with(vec![(0, [1.0, 2.0]), (0, [3.0, 4.0])], None).contains("no mass"));
    }
}
