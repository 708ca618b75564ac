//! What depends on the arm's posture alone in each window: torques of unit wrenches, positions of
//! the tool.

use std::ops::Range;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use nalgebra::{Matrix3, Matrix3xX, Vector3};

use super::windowed_data::WindowedData;
use crate::model::Contact;

/// Number of postures in which the directions without torque are sought.
const POSTURES: usize = 16;

/// Number of postures in which the reach is sought.
const REACHES: usize = 8;

/// Contact of the tool, in axes of the base.
const ON_TOOL: Contact = Contact { link: None, in_base: true };

/// Number of windows whose wrenches are computed at once: an hour at once would take 120 MB.
const AT_ONCE: usize = 1024;

/// Number of parts of that many windows that are cached, 350 kB each with seven joints.
const CACHED: usize = 96;

/// Largest sum of squared torques, relative to the maximum, of a direction that counts as without
/// torque.
const IDLE: f64 = 1e-9;

/// Ranges of windows whose wrenches are computed at once.
pub(in crate::diagnose) fn parts(windows: usize) -> impl Iterator<Item = Range<usize>> {
    (0..windows).step_by(AT_ONCE).map(move |first| first..(first + AT_ONCE).min(windows))
}

/// Torques of unit wrenches in one part of the windows.
struct Part {
    contact: Contact,
    first: usize,
    torques: Arc<Vec<f64>>,
}

/// Cached results of the functions below.
#[derive(Default)]
pub(super) struct Postures {
    wrenches: Mutex<Vec<Part>>,
    forces: OnceLock<Vec<f64>>,
    positions: OnceLock<Vec<f64>>,
    idle: OnceLock<Vec<Vector3<f64>>>,
    reach: OnceLock<f64>,
}

impl WindowedData<'_> {
    /// [`PerturbableArm::wrench_columns`](crate::model::PerturbableArm::wrench_columns) at some
    /// windows.
    pub fn wrenches(&self, span: Range<usize>, contact: Contact) -> Vec<f64> {
        let mut out = vec![0.0; 6 * self.dof() * span.len()];
        let common = |part: &Range<usize>| part.start.max(span.start)..part.end.min(span.end);
        for part in parts(self.len).filter(|part| !common(part).is_empty()) {
            let common = common(&part);
            let torques = self.wrenches_of_part(part.clone(), contact);
            let [to, from] = [&span, &part].map(|all| common.start - all.start..common.end - all.start);
            for (out, row) in out.chunks_exact_mut(span.len()).zip(torques.chunks_exact(part.len())) {
                out[to.clone()].copy_from_slice(&row[from.clone()]);
            }
        }
        out
    }

    /// The same at one of the [`parts`], from the cache.
    fn wrenches_of_part(&self, part: Range<usize>, contact: Contact) -> Arc<Vec<f64>> {
        let cached = || self.postures.wrenches.lock().unwrap_or_else(PoisonError::into_inner);
        let known = |known: &&Part| known.contact == contact && known.first == part.start;
        if let Some(known) = cached().iter().find(known) {
            return known.torques.clone();
        }
        let torques = Arc::new(self.computed_wrenches(part.clone(), contact));
        let mut cached = cached();
        if cached.len() >= CACHED {
            cached.remove(0);
        }
        cached.push(Part { contact, first: part.start, torques: torques.clone() });
        torques
    }

    fn computed_wrenches(&self, span: Range<usize>, contact: Contact) -> Vec<f64> {
        let mut out = vec![0.0; 6 * self.dof() * span.len()];
        if let Some(states) = self.states.first() {
            self.plant.wrench_columns(&states.part(span.start, span.end), contact, &mut out);
        }
        out
    }

    /// Torques of unit forces at the tool along the base's axes: `[(axis * dof + joint) * len +
    /// window]`, N m/N.
    pub fn forces(&self) -> &[f64] {
        self.postures.forces.get_or_init(|| {
            let mut out = vec![0.0; 3 * self.dof() * self.len];
            for span in parts(self.len) {
                let unit = self.wrenches_of_part(span.clone(), ON_TOOL);
                for (row, part) in out.chunks_exact_mut(self.len).zip(unit.chunks_exact(span.len())) {
                    row[span.clone()].copy_from_slice(part);
                }
            }
            out
        })
    }

    /// [`PerturbableArm::tool_positions`](crate::model::PerturbableArm::tool_positions) in all
    /// windows.
    pub fn tool_positions(&self) -> &[f64] {
        self.postures.positions.get_or_init(|| {
            let mut out = vec![0.0; 3 * self.len];
            if let Some(states) = self.states.first() {
                self.plant.tool_positions(states, &mut out);
            }
            out
        })
    }

    /// Torques of unit forces on the tool along the base's axes (rows) in one of `count` postures
    /// from all over the data, per joint.
    fn forces_in_postures(&self, count: usize) -> impl Iterator<Item = Matrix3xX<f64>> + '_ {
        (0..self.len).step_by((self.len / count).max(1)).map(|w| {
            let unit = self.computed_wrenches(w..w + 1, ON_TOOL);
            Matrix3xX::from_fn(self.dof(), |c, j| unit[c * self.dof() + j])
        })
    }

    /// Directions in which a force on the tool causes no torque in any posture, in axes of the
    /// base. A planar arm has one, normal to its plane.
    pub fn directions_without_torque(&self) -> &[Vector3<f64>] {
        self.postures.idle.get_or_init(|| {
            let squares: Matrix3<f64> =
                self.forces_in_postures(POSTURES).map(|torque| &torque * torque.transpose()).sum();
            let axes = squares.symmetric_eigen();
            let most = axes.eigenvalues.amax();
            let idle = (0..3).filter(|&k| axes.eigenvalues[k] <= IDLE * most);
            idle.map(|k| axes.eigenvectors.column(k).into_owned()).collect()
        })
    }

    /// The longest lever arm at the last frame about any joint, over some of the postures, m.
    pub fn reach(&self) -> f64 {
        *self.postures.reach.get_or_init(|| {
            let longest = |torque: Matrix3xX<f64>| torque.column_iter().map(|c| c.norm()).fold(0.0, f64::max);
            self.forces_in_postures(REACHES).map(longest).fold(0.0, f64::max)
        })
    }
}
