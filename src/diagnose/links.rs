//! Links that are not the file's: a cause where all base parameters were taken anew.

use super::calibration;
use super::evidence;
use super::judge::chosen_of;
use super::measure::{Meter, bootstrap, matters, root_mean_square, share, taken_of};
use super::model::{Mode, ModelUnderTest};
use super::result::{Cause, measured_on};
use crate::diagnose::attribution::MOST_MARGIN;
use crate::diagnose::refine_and_select::{Case, Settled};
use dh_codegen::robot::effects;

impl Case<'_> {
    /// The cause, where base parameters differ from the file's, and the file's beside everything
    /// else that was found are worse.
    pub(super) fn links(&self, model: &Settled<'_>) -> Option<Cause> {
        let joints = evidence::changed_links(&model.bench, &model.fitted, &model.fitted.covariance());
        if joints.is_empty() {
            return None;
        }
        // What the file's links would leave beside all other causes.
        let delays = &model.bench.scene.delays;
        let mut believed = ModelUnderTest::new(self.plant, self.fit, self.settings.rate, Mode::Trusted, delays, false);
        believed.frozen = model.bench.frozen.clone();
        let mut others = chosen_of(&model.accepted);
        let trusting = believed.fit(&mut others);
        let without = Meter::new(self.plant, self.validate, &believed).of(&believed, &trusting, &others, true);
        let after = &model.after;
        let told = model.left_out.less(&believed.left_out(&others, &trusting), self.ground);
        // It has to pay like any other.
        let gains = taken_of(&without.steady, &after.steady, self.scale) > 0.0;
        if !(told.worth_refit() && gains && matters(&without.steady, &after.steady, self.noise, self.motion)) {
            return None;
        }
        Some(Cause {
            cause: effects::LinkInertiaError::NAME,
            evidence: format!(
                "the base parameters of joint{} {} differ from the file's by more than five of their standard deviations; with the file's own and everything else that was found {} N m are missed on {} (RMS over joints), with these {} N m",
                if joints.len() > 1 { "s" } else { "" },
                joints.iter().map(usize::to_string).collect::<Vec<_>>().join(", "),
                evidence::short(root_mean_square(&without.rms)),
                measured_on("validate", self.own_validation),
                evidence::short(root_mean_square(&after.rms)),
            ),
            joints,
            probability: calibration::LINKS,
            support: MOST_MARGIN,
            margin: MOST_MARGIN,
            share: share(&without.rms, &after.rms, self.noise, &[]),
            parameters: Vec::new(),
            keys: Vec::new(),
            interval: bootstrap(&without, after, &[]),
            rms_before: without.rms.clone(),
            rms_after: after.rms.clone(),
            on: "validate",
            not_distinguished_from: Vec::new(),
            shown_by: "an exciting motion for the base parameters",
            curve: None,
        })
    }
}
