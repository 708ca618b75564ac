//! Effects of a robot file that an identification takes as known.

use dh_codegen::robot::{EffectKind, Robot};

use crate::data::signal::{Filter, Motion, Prepare};
use crate::identify::KnownEffects;
use crate::model::Arm;
use crate::model::file_torque_model::FileTorqueModel;

/// Gain error of a torque sensor, by which torque errors before and behind it differ.
const GAIN: EffectKind = EffectKind::TorqueGainError;

/// Effects of a robot file that are not fitted.
pub(super) struct FileEffects {
    names: Vec<String>,
    /// Whether there is a gain error of a torque sensor among them.
    scaled: bool,
    /// Model of the effects; `None` if the file has no links, as effects are then inseparable from
    /// the rest.
    model: Option<FileTorqueModel>,
}

impl FileEffects {
    /// Effects of `robot` other than the `fitted` ones; `None` if there are none.
    pub(super) fn of(robot: &Robot, fitted: &[EffectKind]) -> Option<Self> {
        let joints = (1..).zip(&robot.joints);
        let own = joints.flat_map(|(row, joint)| joint.drive.effects.iter().map(move |e| (Some(row), e)));
        let names: Vec<String> = own
            .chain(robot.effects.iter().map(|e| (None, e)))
            .filter(|(_, effect)| !fitted.contains(&effect.kind()))
            .map(|(row, effect)| {
                row.map_or(effect.name().to_string(), |row| format!("{} of joint {row}", effect.name()))
            })
            .chain(robot.all_effects().laws.iter().map(|(row, law)| format!("law {} of joint {}", law.text(), row + 1)))
            .collect();
        let scaled = robot.joints.iter().any(|joint| joint.drive.effects.iter().any(|e| e.kind() == GAIN));
        let model = || Some(FileTorqueModel::new(robot).ok()?.among_walls(robot));
        (!names.is_empty()).then(|| Self { names, scaled, model: model() })
    }

    /// Extends motions by what the effects need: margins for the low-pass, and temperatures.
    pub(super) fn prepare(&self, prepare: &mut Prepare) {
        if self.model.is_some() {
            (prepare.margins, prepare.temperature) = (true, true);
        }
    }

    /// Prepares the subtraction of the effects from a log's torque, which was filtered by `filter`,
    /// with the file's parameters in the arm's order.
    pub(super) fn known<'a>(
        &'a self,
        arm: &'a dyn Arm,
        standard: Option<&[f64]>,
        filter: Option<Filter>,
    ) -> Option<KnownEffects<'a>> {
        KnownEffects::new(self.model.as_ref()?, arm, standard?, filter)
    }

    /// Describes their treatment in a line.
    pub(super) fn sentence(&self, known: bool) -> String {
        let names = self.names.join(", ");
        match known {
            true => format!(
                "effects of the robot file are taken as known: {names}. Their torque is taken out of the measured one; links and plain friction are fitted beside \
                 them, and --delay comes on top of a delay in the file{}",
                if self.scaled {
                    ". Errors of a joint whose sensor has a wrong gain are of the torque before the sensor"
                } else {
                    ""
                }
            ),
            false => format!(
                "effects of the robot file are not used: {names}. Without links in the file their torque can't be computed; the fit is that of the rigid arm"
            ),
        }
    }
}

/// The motion without the known effects.
pub(super) fn without<'a>(known: Option<&KnownEffects<'_>>, motion: &'a Motion) -> std::borrow::Cow<'a, Motion> {
    match known {
        Some(known) => std::borrow::Cow::Owned(known.taken_out(motion)),
        None => std::borrow::Cow::Borrowed(motion),
    }
}
