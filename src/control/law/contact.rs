//! Contact state of the tool: found, lost, or given up.

use super::machine::Touch;

/// Limits of the search for a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Search {
    /// Force above which there is contact, N.
    pub(super) contact: f64,
    /// Time without contact after which it counts as lost, s.
    pub(super) lost_after: f64,
    /// Duration of the search for contact, s.
    pub(super) give_up: f64,
    /// Farthest displacement beyond the point where contact was lost, m.
    pub(super) regain: f64,
    /// End of the displacement's range, m.
    pub(super) end: f64,
}

/// State of the contact so far.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Contact {
    touched: bool,
    /// Time since contact ended, or at the end of the range without contact, s.
    away: f64,
    /// Displacement at which contact was lost, m.
    anchor: f64,
    /// Time at the end of the range with less than the desired force, s.
    exhausted: f64,
}

impl Contact {
    /// Processes a force, N, with the desired one `wanted`, N, at a displacement, m, `dt` s after
    /// the previous one.
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
            // At the end of the range there is no wall to find.
            self.away = if at_end { self.away + dt } else { 0.0 };
        }
        match self.touched {
            _ if self.away.max(self.exhausted) > search.give_up => Touch::GivenUp,
            false => Touch::NotYet,
            true if self.away > search.lost_after => Touch::Lost,
            true => Touch::Touches,
        }
    }

    /// Largest permitted displacement, m.
    pub(super) fn ceiling(&self, search: &Search) -> f64 {
        if self.touched && self.away > 0.0 { self.anchor + search.regain } else { f64::MAX }
    }

    /// Whether the tool is in contact now.
    pub(super) fn touches(&self) -> bool {
        self.touched && self.away == 0.0
    }
}
