//! Errors in the controller's settings.

use core::fmt::{Display, Formatter};

/// The first invalid setting of a controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ControllerError {
    /// [`Settings::period`](super::Settings::period).
    Period,
    /// [`Settings::joints`](super::Settings::joints): a negative gain.
    JointGains,
    /// [`Settings::force`](super::Settings::force): a negative gain.
    ForceGains,
    /// The range of the displacement does not hold 0.
    Range,
    /// Speed of the displacement.
    Rate,
    /// [`Settings::torque`](super::Settings::torque),
    /// [`Settings::velocity`](super::Settings::velocity) or
    /// [`Settings::limits`](super::Settings::limits).
    Limits,
    /// A limit of the contact.
    Contact,
    /// A feed-forward share.
    Share,
    /// [`Settings::aside_pole`](super::Settings::aside_pole).
    AsidePole,
    /// [`Settings::corner`](super::Settings::corner).
    Corner,
    /// [`Settings::stop`](super::Settings::stop).
    Stop,
}

impl Display for ControllerError {
    fn fmt(&self, f: &mut Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Period => "the period must be greater than 0",
            Self::JointGains => "the gains of the joints must not be negative",
            Self::ForceGains => "the gains of the force loop must not be negative",
            Self::Range => "the range of the displacement must hold 0",
            Self::Rate => "the displacement's speed must be greater than 0",
            Self::Limits => {
                "limits of torque, velocity and motion must be greater than 0, ranges of position not empty"
            }
            Self::Contact => "the limits of contact must not be negative",
            Self::Share => "shares that are fed forward must be from 0 to 1",
            Self::AsidePole => "the pole of the force aside must not be negative",
            Self::Corner => "the corner of the estimate's low-pass must be greater than 0",
            Self::Stop => "the time of a stop must be greater than 0",
        })
    }
}

impl core::error::Error for ControllerError {}
