//! Is the wall there?

use super::machine::Touch;

/// Limits of the search for a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Search {
    /// Force that means contact, N.
    pub(super) contact: f64,
    /// Contact that is gone for this long is lost, s.
    pub(super) lost_after: f64,
    /// How long it is looked for, s.
    pub(super) give_up: f64,
    /// How far the displacement may follow a contact that was lost, m.
    pub(super) regain: f64,
    /// End of the displacement's range, m.
    pub(super) end: f64,
}

/// What the force has said so far.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Contact {
    touched: bool,
    /// Since it was there, or at the end of the range without it, s.
    away: f64,
    /// Displacement where it was lost, m.
    anchor: f64,
    /// At the end of the range with too little force, s.
    exhausted: f64,
}

impl Contact {
    /// Takes in a force, `wanted` being the desired one (N), at a displacement (m), `dt` seconds
    /// after the one before.
    pub(super) fn step(&mut self, force: f64, wanted: f64, displacement: f64, dt: f64, search: &Search) -> Touch {
        let at_end = displacement >= search.end;
        self.exhausted = if at_end && force < wanted { self.exhausted + dt } else { 0.0 };
        if force >= search.contact {
            (self.touched, self.away) = (true, 0.0);
        } else if self.touched {
            if self.away == 0.0 {
                self.anchor = displacement;
            }
            self.away += dt;
        } else {
            // At the end of its range there is no wall to be found.
            self.away = if at_end { self.away + dt } else { 0.0 };
        }
        match self.touched {
            _ if self.away.max(self.exhausted) > search.give_up => Touch::GivenUp,
            false => Touch::NotYet,
            true if self.away > search.lost_after => Touch::Lost,
            true => Touch::Touches,
        }
    }

    /// Farthest displacement, m.
    pub(super) fn ceiling(&self, search: &Search) -> f64 {
        if self.touched && self.away > 0.0 { self.anchor + search.regain } else { f64::MAX }
    }

    /// Whether the tool touches now.
    pub(super) fn touches(&self) -> bool {
        self.touched && self.away == 0.0
    }
}
