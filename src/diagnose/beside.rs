//! A model beside the same without one of its causes.
//!
//! A cause is measured on the validating logs. If a joint is missed far more there than on the
//! fitted logs, with the cause and without it, something else has changed between them (a warmer
//! gear, another tool); then these logs can neither confirm nor refute the causes of that joint,
//! and the fitted ones decide.

use super::excess::{CHANGED, EXCESS};
use super::measure::{Measured, Meter, bootstrap, here, leave_out, share};
use super::model::{Chosen, ModelUnderTest};
use super::refine_and_select::Case;
use super::reported_cause::Item;

/// Errors of a model without one of its causes.
pub(super) struct Without {
    pub(super) measured: Measured,
    /// Interval of what the cause takes.
    pub(super) interval: [f64; 2],
    /// Whether they are those on the fitted logs.
    pub(super) near: bool,
    /// Joints that differ between fitted and validating logs, whether the model has the cause or
    /// not.
    apart: Vec<bool>,
    /// Share that the cause takes on validating logs where its joints differ.
    pub(super) far_share: Option<f64>,
}

impl Without {
    /// Errors where joints move; on joints that differ those of the model `with` the cause, which
    /// neither confirm nor refute it.
    pub(super) fn alike(&self, with: &Measured) -> Vec<f64> {
        let joints = self.measured.steady.iter().zip(&with.steady).zip(&self.apart);
        joints.map(|((without, with), apart)| if *apart { *with } else { *without }).collect()
    }

    /// Whether all joints of a place differ between the logs.
    pub(super) fn differs(&self, place: &[usize]) -> bool {
        !place.is_empty() && place.iter().all(|&j| self.apart[j])
    }
}

/// Measures a model beside the same without one of its causes.
pub(super) struct Beside<'c, 'a> {
    pub(super) case: &'c Case<'a>,
    pub(super) far: Meter<'a>,
    pub(super) near: Meter<'a>,
    pub(super) after: &'c Measured,
    pub(super) after_fit: &'c Measured,
}

impl<'a> Beside<'_, 'a> {
    /// Errors without a cause, on the validating logs; on the fitted ones if the validating ones
    /// can't refute it.
    pub(super) fn without(&mut self, bench: &mut ModelUnderTest<'a>, chosen: &[Chosen], item: &Item) -> Without {
        let near = here(item, self.after);
        let found = self.on(near, bench, chosen, item);
        if near || !found.differs(&item.place) {
            return found;
        }
        let far = share(&found.measured.steady, &self.after.steady, self.case.noise, &item.place);
        Without { apart: found.apart, far_share: Some(far), ..self.on(true, bench, chosen, item) }
    }

    fn on(&mut self, near: bool, bench: &mut ModelUnderTest<'a>, chosen: &[Chosen], item: &Item) -> Without {
        let Case { plant, fit, noise, own_validation, .. } = *self.case;
        let (meter, with) = if near { (&mut self.near, self.after_fit) } else { (&mut self.far, self.after) };
        let measured = leave_out(plant, fit, meter, bench, chosen, item, !near);
        let apart = |j: usize| {
            let both = self.after.steady[j].min(measured.steady[j]);
            own_validation && !near && both > CHANGED * self.after_fit.steady[j].max(EXCESS * noise[j])
        };
        let apart = (0..noise.len()).map(apart).collect();
        Without { interval: bootstrap(&measured, with, &item.place), measured, near, apart, far_share: None }
    }
}
