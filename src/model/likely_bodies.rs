//! Prior bodies of links, used where the data do not determine them.

use crate::model::pseudo_inertia::{Yardstick, is_body};

/// Source of a link's prior.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// The robot file's body.
    File,
    /// The robot file's body is flat or a line; a thousandth of the geometric one was added.
    Thickened,
    /// The robot file has none: a guess from the geometry.
    Geometric,
    /// The robot file's link is not a possible body: replaced by a guess from the geometry.
    Impossible,
}

impl Source {
    /// Whether the body is a guess.
    pub fn is_guess(self) -> bool {
        matches!(self, Self::Geometric | Self::Impossible)
    }
}

/// A link's prior.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PriorBody {
    /// `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the link's frame, about its origin.
    pub body: [f64; 10],
    /// Source of the body.
    pub source: Source,
}

/// Least thickness of a guessed link, m (radius).
const THIN: f64 = 0.04;
/// Density of a guessed link, kg/m^3: aluminium, motors and air.
const DENSITY: f64 = 1000.0;

/// A guess for each link: a solid cylinder of the density of water from the frame's origin to the
/// link's end, one radius longer at both ends. The radius is a sixteenth of the arm's reach (the
/// sum of the links' lengths), at least 40 mm. Correct within a factor of a few: it gives
/// unidentifiable combinations the size of a robot's link, and has a correspondingly small weight
/// ([`ConsistentSettings::geometric_share`](crate::identify::ConsistentSettings)).
pub fn geometric_bodies(ends: &[[f64; 3]]) -> Vec<[f64; 10]> {
    let length = |p: &[f64; 3]| p.iter().map(|x| x * x).sum::<f64>().sqrt();
    let reach: f64 = ends.iter().map(length).sum();
    let radius = (reach / 16.0).max(THIN);
    ends.iter()
        .map(|end| {
            let long = length(end) + 2.0 * radius;
            let m = DENSITY * std::f64::consts::PI * radius * radius * long;
            let c = end.map(|x| x / 2.0);
            let axis = if length(end) > 0.0 { end.map(|x| x / length(end)) } else { [0.0, 0.0, 1.0] };
            // Second moments: across the axis m r^2 / 4, along it m l^2 / 12; plus those of the
            // centre.
            let (across, along) = (m * radius * radius / 4.0, m * long * long / 12.0);
            let second = |i: usize, j: usize| {
                (if i == j { across } else { 0.0 }) + (along - across) * axis[i] * axis[j] + m * c[i] * c[j]
            };
            let (a, b, d) = (second(0, 0), second(1, 1), second(2, 2));
            let [x, y, z] = c.map(|c| m * c);
            [m, x, y, z, b + d, a + d, a + b, -second(0, 1), -second(0, 2), -second(1, 2)]
        })
        .collect()
}

/// The file's bodies where they are possible, and the guesses for the rest. `file`: per link,
/// `None` where nothing is known.
pub fn prior_bodies(file: &[Option<[f64; 10]>], guesses: &[[f64; 10]]) -> Vec<PriorBody> {
    guesses
        .iter()
        .enumerate()
        .map(|(link, guess)| {
            let stated = file.get(link).copied().flatten().filter(|b| b.iter().any(|x| *x != 0.0));
            let known = stated.filter(|b| b[0] > 0.0);
            let smallest =
                |body: &[f64; 10]| Yardstick::new(guess).map_or(0.0, |y| y.measure(body).symmetric_eigenvalues().min());
            match known {
                Some(body) if smallest(&body) > 1e-6 && is_body(&body) => PriorBody { body, source: Source::File },
                Some(body) if smallest(&body) > -1e-6 => {
                    let share = 1e-3 * body[0] / guess[0];
                    let thick = std::array::from_fn(|k| body[k] + share * guess[k]);
                    match is_body(&thick) {
                        true => PriorBody { body: thick, source: Source::Thickened },
                        false => PriorBody { body: *guess, source: Source::Impossible },
                    }
                }
                _ if stated.is_some() => PriorBody { body: *guess, source: Source::Impossible },
                _ => PriorBody { body: *guess, source: Source::Geometric },
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn guesses_are_bodies_of_a_robots_size() {
        let lwr = [[0.0; 3], [0.0, 0.4, 0.0], [0.0; 3], [0.0, -0.39, 0.0], [0.0; 3], [0.0; 3], [0.0, 0.0, 0.078]];
        let bodies = geometric_bodies(&lwr);
        assert!(bodies.iter().all(is_body));
        let total: f64 = bodies.iter().map(|b| b[0]).sum();
        assert!((5.0..60.0).contains(&total), "{total} kg");
        assert!((bodies[1][2] / bodies[1][0] - 0.2).abs() < 1e-12, "its centre is half way");
    }

    #[test]
    fn rods_are_thickened_and_impossible_bodies_replaced() {
        let guesses = geometric_bodies(&[[0.3, 0.0, 0.0], [0.3, 0.0, 0.0], [0.3, 0.0, 0.0], [0.3, 0.0, 0.0]]);
        let rod = [2.0, 0.3, 0.0, 0.0, 0.0, 0.06, 0.06, 0.0, 0.0, 0.0];
        let ghost = [2.0, 1.0, 0.0, 0.0, 0.01, 0.01, 0.01, 0.0, 0.0, 0.0];
        let prior = prior_bodies(&[Some(rod), Some(ghost), None, Some(guesses[0])], &guesses);
        let sources: Vec<Source> = prior.iter().map(|p| p.source).collect();
        assert_eq!(sources, [Source::Thickened, Source::Impossible, Source::Geometric, Source::File]);
        assert!(prior.iter().all(|p| is_body(&p.body)));
        assert!((prior[0].body[0] - 2.002).abs() < 1e-12);
    }
}
