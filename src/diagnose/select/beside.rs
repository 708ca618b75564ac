//! A model beside the same without one of its causes.
//!
//! A cause is measured on the validating logs. If a joint is missed far more there than on the
//! fitted logs, with the cause and without it, something else has changed between them (a warmer
//! gear, another tool); then these logs can neither confirm nor refute the causes of that joint,
//! and the fitted ones decide.

use super::excess::{CHANGED, EXCESS};
use super::measure::{Measured, Meter, bootstrap, here, leave_out, share};
use super::refine_and_select::Session;
use crate::diagnose::findings::reported_cause::Item;
use crate::diagnose::fit::model::{Chosen, ModelUnderTest};

/// Errors of a model without one of its causes.
pub(in crate::diagnose) struct Without {
    pub(in crate::diagnose) measured: Measured,
    /// Interval of what the cause takes.
    pub(in crate::diagnose) interval: [f64; 2],
    /// Whether they are those on the fitted logs.
    pub(in crate::diagnose) near: bool,
    /// Joints that differ between fitted and validating logs, whether the model has the cause or
    /// not.
    apart: Vec<bool>,
    /// Share that the cause takes on validating logs where its joints differ.
    pub(in crate::diagnose) far_share: Option<f64>,
}

impl Without {
    /// Errors where joints move; on joints that differ those of the model `with` the cause, which
    /// neither confirm nor refute it.
    pub(in crate::diagnose) fn alike(&self, with: &Measured) -> Vec<f64> {
        let joints = self.measured.steady.iter().zip(&with.steady).zip(&self.apart);
        joints.map(|((without, with), apart)| if *apart { *with } else { *without }).collect()
    }

    /// Whether all joints of a place differ between the logs.
    pub(in crate::diagnose) fn differs(&self, place: &[usize]) -> bool {
        !place.is_empty() && place.iter().all(|&j| self.apart[j])
    }
}

/// Measures a model beside the same without one of its causes.
pub(in crate::diagnose) struct Beside<'c, 'a> {
    pub(in crate::diagnose) case: &'c Session<'a>,
    pub(in crate::diagnose) far: Meter<'a>,
    pub(in crate::diagnose) near: Meter<'a>,
    pub(in crate::diagnose) after: &'c Measured,
    pub(in crate::diagnose) after_fit: &'c Measured,
}

impl<'a> Beside<'_, 'a> {
    /// Errors without a cause, on the validating logs; on the fitted ones if the validating ones
    /// can't refute it.
    pub(in crate::diagnose) fn without(
        &mut self,
        bench: &mut ModelUnderTest<'a>,
        chosen: &[Chosen],
        item: &Item,
    ) -> Without {
        let near = here(item, self.after);
        let found = self.on(near, bench, chosen, item);
        if near || !found.differs(&item.place) {
            return found;
        }
        let far = share(&found.measured.steady, &self.after.steady, self.case.noise, &item.place);
        Without { apart: found.apart, far_share: Some(far), ..self.on(true, bench, chosen, item) }
    }

    fn on(&mut self, near: bool, bench: &mut ModelUnderTest<'a>, chosen: &[Chosen], item: &Item) -> Without {
        let Session { plant, fit, noise, own_validation, .. } = *self.case;
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
