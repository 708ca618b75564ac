//! Converts standard parameters of an arm to the coordinates of [`Problem`], and back.

use nalgebra::{DMatrix, DVector};

use super::ConsistentError;
use super::ConsistentSettings;
use super::newton::{Link, Problem, Scalar, Wall};
use crate::model::likely_bodies::PriorBody;
use crate::model::pseudo_inertia::Yardstick;
use crate::model::{BaseParameter, Description, Inertial, StandardParameter};

/// Indices of the links' and drives' parameters among the standard ones.
#[derive(Debug, Clone)]
pub(super) struct Layout {
    /// Ten indices per link.
    pub(super) links: Vec<[usize; 10]>,
    /// Rotor inertias and friction, which are not negative.
    pub(super) positive: Vec<usize>,
    /// Offsets, which may have any sign.
    pub(super) free: Vec<usize>,
    /// Rotor inertias among `positive`.
    pub(super) rotors: Vec<usize>,
    /// Number of all parameters.
    pub(super) count: usize,
}

impl Layout {
    pub(super) fn new(parameters: &[StandardParameter]) -> Result<Self, ConsistentError> {
        let mut used = vec![false; parameters.len()];
        let mut links = Vec::new();
        let masses = parameters.iter().filter_map(|p| match *p {
            StandardParameter::Link(row, Inertial::M) => Some(row),
            _ => None,
        });
        for row in masses {
            let mut link = [0; 10];
            for (place, which) in link.iter_mut().zip(Inertial::ALL) {
                let wanted = StandardParameter::Link(row, which);
                let missing = || ConsistentError::Incomplete { link: row + 1, missing: wanted.to_string() };
                *place = parameters.iter().position(|p| *p == wanted).ok_or_else(missing)?;
                used[*place] = true;
            }
            links.push(link);
        }
        let rest = |positive: bool| -> Vec<usize> {
            let is = |i: &usize| parameters[*i].is_level() == positive;
            (0..parameters.len()).filter(|&i| !used[i]).filter(is).collect()
        };
        let rotors = (0..parameters.len()).filter(|&i| parameters[i].is_rotor()).collect();
        Ok(Self { positive: rest(true), free: rest(false), rotors, links, count: parameters.len() })
    }

    /// Standard parameters of the bodies fixed to links, and the least values of drives, to which
    /// the unknowns are added.
    fn known(&self, settings: &ConsistentSettings) -> Result<Vec<f64>, ConsistentError> {
        let mut known = vec![0.0; 10 * self.links.len() + self.positive.len() + self.free.len()];
        for (link, body) in &settings.carried {
            let places = self.links.get(*link).ok_or(ConsistentError::Length {
                what: "links with a body fixed to them",
                found: link + 1,
                expected: self.links.len(),
            })?;
            places.iter().zip(body).for_each(|(&i, b)| known[i] += b);
        }
        for &(i, least) in settings.floors.iter().filter(|(i, _)| self.positive.contains(i)) {
            known[i] += least;
        }
        Ok(known)
    }
}

/// Data term `1/2 |r beta - z|^2`, in units of the noise.
pub(super) struct Data {
    pub(super) r: DMatrix<f64>,
    pub(super) z: DVector<f64>,
}

/// The problem, its start, and the conversion back to standard parameters.
pub(super) struct Setup {
    pub(super) problem: Problem,
    /// Coordinates of the prior, which are strictly feasible.
    pub(super) start: Vec<f64>,
    pub(super) layout: Layout,
    yardsticks: Vec<Yardstick>,
    scales: Vec<f64>,
    offset: Vec<f64>,
}

/// Matrix `K` from `standard` standard parameters to base parameters.
pub(super) fn grouping(base: &[BaseParameter], standard: usize) -> DMatrix<f64> {
    let mut k = DMatrix::zeros(base.len(), standard);
    for (row, base) in base.iter().enumerate() {
        base.coefficients.iter().for_each(|&(column, c)| k[(row, column)] += c);
    }
    k
}

impl Setup {
    /// Sets up the problem for the base parameters of an arm.
    pub(super) fn of(
        arm: &Description,
        data: &Data,
        prior: &[PriorBody],
        drives: &[f64],
        settings: &ConsistentSettings,
    ) -> Result<Self, ConsistentError> {
        let layout = Layout::new(&arm.standard)?;
        let grouping = grouping(&arm.base, layout.count);
        Self::new(layout, &grouping, data, prior, drives, settings)
    }

    /// Sets up the problem with `grouping`, the matrix `K` from the parameters of `layout` to the
    /// data's unknowns. `drives`: standard parameters of which those of the drives are used.
    pub(super) fn new(
        layout: Layout,
        grouping: &DMatrix<f64>,
        data: &Data,
        prior: &[PriorBody],
        drives: &[f64],
        settings: &ConsistentSettings,
    ) -> Result<Self, ConsistentError> {
        let length = |what, found: usize, expected: usize| match found == expected {
            true => Ok(()),
            false => Err(ConsistentError::Length { what, found, expected }),
        };
        length("prior bodies", prior.len(), layout.links.len())?;
        length("standard parameters", drives.len(), layout.count)?;
        length("base parameters", data.r.ncols(), grouping.nrows())?;
        let unit = |x: f64| x > 0.0 && x < 1.0;
        if !(unit(settings.margin) && settings.prior_weight > 0.0 && settings.geometric_share > 0.0) {
            return Err(ConsistentError::Settings);
        }

        let mut bodies: Vec<[f64; 10]> = prior.iter().map(|p| p.body).collect();
        settings.bounds.enforce(&mut bodies)?;
        let offset = layout.known(settings)?;
        let standard = &data.r * grouping;
        let z = &data.z - &standard * DVector::from_column_slice(&offset);
        let (positive, free) = (layout.positive.len(), layout.free.len());
        let variables = 10 * bodies.len() + positive + free;
        let mut j = DMatrix::zeros(data.r.nrows(), variables);
        let mut start = vec![0.0; variables];
        let (mut yardsticks, mut links) = (Vec::new(), Vec::new());
        for (link, (body, places)) in bodies.iter().zip(&layout.links).enumerate() {
            let yardstick = Yardstick::new(body).ok_or(ConsistentError::PriorBody { link: link + 1 })?;
            let columns = standard.select_columns(places);
            j.columns_mut(10 * link, 10).copy_from(&(columns * yardstick.to_body));
            start[10 * link..10 * link + 4].fill(1.0);
            let share = if prior[link].source.is_guess() { settings.geometric_share } else { 1.0 };
            links.push(Link { start: 10 * link, share });
            yardsticks.push(yardstick);
        }
        let mut scales = vec![1.0; layout.count];
        let mut problem = Problem {
            j,
            z,
            links,
            scalars: Vec::new(),
            free: Vec::new(),
            walls: Vec::new(),
            equal: None,
            margin: settings.margin,
        };
        for (k, &i) in layout.positive.iter().enumerate() {
            let index = 10 * bodies.len() + k;
            let above = drives[i] - offset[i];
            let given = above > 0.0;
            scales[i] = if given { above } else { 0.1 };
            problem.j.set_column(index, &(standard.column(i) * scales[i]));
            // Friction changes with temperature and age: only rotors are regularised towards the
            // file.
            problem.scalars.push(Scalar { index, known: given && layout.rotors.contains(&i) });
            start[index] = 1.0;
        }
        for (k, &i) in layout.free.iter().enumerate() {
            let index = 10 * bodies.len() + positive + k;
            problem.j.set_column(index, &standard.column(i));
            problem.free.push((index, drives[i]));
            start[index] = drives[i];
        }
        let mut setup = Self { problem, start, layout, yardsticks, scales, offset };
        setup.build_walls(settings);
        Ok(setup)
    }

    fn build_walls(&mut self, settings: &ConsistentSettings) {
        // Row of one of the ten parameters in terms of the coordinates.
        let row = |link: usize, which: usize, factor: f64| -> Vec<(usize, f64)> {
            (0..10).map(|k| (10 * link + k, factor * self.yardsticks[link].to_body[(which, k)])).collect()
        };
        let bounds = &settings.bounds;
        let mut walls = Vec::new();
        for &(link, [low, high]) in &bounds.mass {
            walls.push(Wall { a: row(link, 0, 1.0), b: low });
            if high.is_finite() {
                walls.push(Wall { a: row(link, 0, -1.0), b: -high });
            }
        }
        for &(link, axis, [low, high]) in &bounds.center {
            for (limit, sign) in [(low, 1.0), (high, -1.0)] {
                if limit.is_finite() {
                    let (moment, mass) = (row(link, 1 + axis, sign), row(link, 0, sign * limit));
                    let a = moment.iter().zip(mass).map(|(&(i, s), (_, m))| (i, s - m)).collect();
                    walls.push(Wall { a, b: 0.0 });
                }
            }
        }
        let equal = bounds.total_mass.map(|total| {
            let a = (0..self.yardsticks.len()).flat_map(|link| row(link, 0, 1.0)).collect();
            Wall { a, b: total }
        });
        self.problem.walls = walls;
        self.problem.equal = equal;
    }

    /// Converts coordinates to standard parameters.
    pub(super) fn standard(&self, v: &[f64]) -> Vec<f64> {
        let mut x = self.offset.clone();
        for (link, (places, yardstick)) in self.layout.links.iter().zip(&self.yardsticks).enumerate() {
            let body =
                yardstick.to_body * nalgebra::SVector::<f64, 10>::from_column_slice(&v[10 * link..10 * link + 10]);
            places.iter().zip(body.iter()).for_each(|(&i, b)| x[i] += b);
        }
        let rest = self.layout.positive.iter().chain(&self.layout.free);
        rest.zip(&v[10 * self.yardsticks.len()..]).for_each(|(&i, v)| x[i] += self.scales[i] * v);
        x
    }

    /// Smallest eigenvalue of each link's body relative to its prior.
    pub(super) fn margins(&self, v: &[f64]) -> Vec<f64> {
        let smallest =
            |l: &Link| crate::model::pseudo_inertia::symmetric(&v[l.start..l.start + 10]).symmetric_eigenvalues().min();
        self.problem.links.iter().map(smallest).collect()
    }
}
