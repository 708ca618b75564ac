//! The state machine of the controller: a pure function from a state and the observations of a step
//! to the next state. docs/control.md has it as a table.
//!
//! It is independent of the robot. `tests/machine.rs` checks all states under all guards.

/// Reason for which the controller stopped pressing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Fault {
    /// No positions for too long, or too few of them.
    Position,
    /// A measured position stays bit-identical while its joint is commanded to move.
    Frozen,
    /// Time stamps and steps disagree.
    Clock,
    /// The model returns no numbers for too long.
    Model,
    /// A joint is outside its range.
    Joint,
    /// A joint is too fast for too long.
    Speed,
    /// Torques are at their limits, of size or of rate, for too long.
    Torque,
    /// No target within the limits for too long.
    Plan,
    /// No posture for the displaced target for too long.
    Reach,
    /// Too much force.
    Excess,
    /// The force stays bit-identical while the tool is moved deeper, or along the wall.
    Stuck,
    /// No force for too long.
    Force,
    /// No contact for too long.
    Contact,
}

/// Reaction to a fault: the information that is left to stop the arm with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Reaction {
    /// Positions, model and plan are reliable: the tool leaves the wall while the plan's path is
    /// followed to a stop; then the posture is held.
    Path,
    /// Positions are reliable, but not the targets: damping and gravity.
    Damped,
    /// The motion is unknown: gravity, and the brakes at once.
    Blind,
}

impl Fault {
    /// All faults, the most severe first.
    pub const ALL: [Self; 13] = [
        Self::Position,
        Self::Frozen,
        Self::Clock,
        Self::Model,
        Self::Joint,
        Self::Speed,
        Self::Torque,
        Self::Plan,
        Self::Reach,
        Self::Excess,
        Self::Stuck,
        Self::Force,
        Self::Contact,
    ];

    /// Reaction to the fault.
    pub fn reaction(self) -> Reaction {
        match self {
            Self::Position | Self::Frozen => Reaction::Blind,
            Self::Clock | Self::Model | Self::Joint | Self::Speed | Self::Torque => Reaction::Damped,
            Self::Plan | Self::Reach | Self::Excess | Self::Stuck | Self::Force | Self::Contact => Reaction::Path,
        }
    }
}

/// State of the controller.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Status {
    /// No target yet: damping and gravity.
    Waiting,
    /// Follows the plan; no force is desired.
    Free,
    /// Moves towards the wall.
    Approaching,
    /// Presses on the wall.
    Pressing,
    /// Searches for a lost contact.
    Lost,
    /// Holds while a sample, a force or the model is missing, for at most the patience.
    Holding,
    /// Leaves the wall while the plan's path is followed to a stop.
    Leaving(Fault),
    /// Brings the arm to rest.
    Stopping(Fault),
    /// At rest, or held by gravity torques where positions are missing, until
    /// [`Controller::reset`].
    ///
    /// [`Controller::reset`]: super::Controller::reset
    Stopped(Fault),
}

impl Status {
    /// Fault for which the arm leaves the wall, stops or has stopped.
    pub fn fault(self) -> Option<Fault> {
        match self {
            Self::Leaving(fault) | Self::Stopping(fault) | Self::Stopped(fault) => Some(fault),
            _ => None,
        }
    }

    /// Whether the brakes are requested.
    pub fn brakes(self) -> bool {
        matches!(self, Self::Stopped(_))
    }
}

/// Outcome of a step's sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Arrival {
    /// Usable.
    Good,
    /// Missing, stale, not a number, or discontinuous.
    Bad,
    /// One of too many bad samples.
    Gone,
    /// Time stamp and step count disagree.
    Jumped,
}

/// What the plan requests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Wanted {
    /// No target yet.
    Nothing,
    /// Motion away from the wall.
    Free,
    /// Pressing with a force.
    Press,
}

/// State of the contact according to the force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Touch {
    /// No contact so far.
    NotYet,
    /// In contact now, or a moment ago.
    Touches,
    /// Lost; the search is running.
    Lost,
    /// Search given up.
    GivenUp,
}

/// The guards: observations of one step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Seen {
    /// Outcome of the sample.
    pub arrival: Arrival,
    /// Whether the last evaluation of the model gave valid numbers.
    pub model: bool,
    /// Whether this step's target is valid and within the limits.
    pub plan: bool,
    /// Request of the last valid target.
    pub wanted: Wanted,
    /// Whether there is a force value.
    pub force: bool,
    /// State of the contact.
    pub touch: Touch,
    /// Most severe limit that is exceeded: any but [`Fault::Position`], [`Fault::Clock`] and
    /// [`Fault::Contact`]. [`Fault::Model`], [`Fault::Plan`] and [`Fault::Force`] are included for
    /// the case that too many steps fail although the patience never runs out.
    pub limit: Option<Fault>,
    /// Whether the tool is off the wall and the path has been followed to its stop.
    pub clear: bool,
    /// Whether the joints are at rest and the path has been followed to its stop.
    pub rest: bool,
}

/// Longest durations of states, in steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Bounds {
    /// Number of consecutive steps in which samples, force, model or targets may fail.
    pub patience: u32,
    /// Longest stay in [`Status::Leaving`].
    pub leave: u32,
    /// Longest stay in [`Status::Stopping`].
    pub stop: u32,
}

/// The state with its counters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Machine {
    status: Status,
    /// Consecutive steps without a sample or a model, in which torques were held; `unplanned`:
    /// without a target; `blind`: without a force.
    held: u32,
    unplanned: u32,
    blind: u32,
    /// Steps left in [`Status::Leaving`] and [`Status::Stopping`].
    left: u32,
}

impl Default for Machine {
    fn default() -> Self {
        Self { status: Status::Waiting, held: 0, unplanned: 0, blind: 0, left: 0 }
    }
}

impl Machine {
    /// Current state.
    pub fn status(self) -> Status {
        self.status
    }

    /// Returns the state after a step.
    #[must_use]
    pub fn next(self, seen: &Seen, bounds: &Bounds) -> Self {
        let counted = self.counted(seen, bounds.patience);
        match counted.worst(seen, bounds.patience) {
            Some(fault) if counted.is_graver(fault) => counted.failed(fault, seen, bounds),
            _ => counted.gone_on(seen, bounds),
        }
    }

    fn counted(self, seen: &Seen, patience: u32) -> Self {
        let count = |n: u32, fails: bool| if fails { n.saturating_add(1).min(patience.saturating_add(1)) } else { 0 };
        let arrived = matches!(seen.arrival, Arrival::Good | Arrival::Jumped);
        let looked = arrived || seen.wanted != Wanted::Press;
        Self {
            status: self.status,
            // One count for both: alternating failures hold the torques all the same.
            held: count(self.held, !arrived || !seen.model),
            unplanned: count(self.unplanned, !seen.plan && seen.wanted != Wanted::Nothing),
            // Without a sample there is no information about the force.
            blind: if looked { count(self.blind, !seen.force && seen.wanted == Wanted::Press) } else { self.blind },
            left: self.left,
        }
    }

    /// Returns the most severe fault of this step.
    fn worst(&self, seen: &Seen, patience: u32) -> Option<Fault> {
        let over = |n: u32| n > patience;
        let arrived = seen.arrival != Arrival::Bad;
        let grave = |fault: &Fault| fault.reaction() != Reaction::Path;
        let presses = seen.wanted == Wanted::Press;
        [
            (seen.arrival == Arrival::Gone || (over(self.held) && !arrived)).then_some(Fault::Position),
            seen.limit.filter(|fault| fault.reaction() == Reaction::Blind),
            (seen.arrival == Arrival::Jumped).then_some(Fault::Clock),
            over(self.held).then_some(Fault::Model),
            seen.limit.filter(grave),
            over(self.unplanned).then_some(Fault::Plan),
            seen.limit,
            (presses && over(self.blind)).then_some(Fault::Force),
            (presses && seen.touch == Touch::GivenUp).then_some(Fault::Contact),
        ]
        .into_iter()
        .flatten()
        .next()
    }

    /// Whether a fault replaces the present one: only if it leaves less to stop the arm with.
    fn is_graver(&self, fault: Fault) -> bool {
        self.status.fault().is_none_or(|old| fault.reaction() > old.reaction())
    }

    fn failed(self, fault: Fault, seen: &Seen, bounds: &Bounds) -> Self {
        let (status, left) = match (fault.reaction(), self.status) {
            (Reaction::Blind, _) | (_, Status::Stopped(_)) => (Status::Stopped(fault), 0),
            // The time to come to rest is not restarted.
            (_, Status::Stopping(_)) if self.left > 1 => (Status::Stopping(fault), self.left - 1),
            (_, Status::Stopping(_)) => (Status::Stopped(fault), 0),
            (Reaction::Path, _) if seen.wanted == Wanted::Press => (Status::Leaving(fault), bounds.leave),
            _ => (Status::Stopping(fault), bounds.stop),
        };
        Self { status, left, ..self }
    }

    fn gone_on(self, seen: &Seen, bounds: &Bounds) -> Self {
        let left = self.left.saturating_sub(1);
        let (status, left) = match self.status {
            Status::Leaving(fault) if seen.clear || left == 0 => (Status::Stopping(fault), bounds.stop),
            Status::Stopping(fault) if seen.rest || left == 0 => (Status::Stopped(fault), 0),
            status @ (Status::Leaving(_) | Status::Stopping(_)) => (status, left),
            status @ Status::Stopped(_) => (status, 0),
            _ => (working(seen), 0),
        };
        Self { status, left, ..self }
    }
}

/// State without a fault, determined by the observations.
fn working(seen: &Seen) -> Status {
    match (seen.arrival, seen.wanted) {
        (Arrival::Good, Wanted::Nothing) => Status::Waiting,
        (Arrival::Good, _) if !seen.model => Status::Holding,
        (Arrival::Good, Wanted::Free) => Status::Free,
        (Arrival::Good, Wanted::Press) if seen.force => match seen.touch {
            Touch::NotYet => Status::Approaching,
            Touch::Touches => Status::Pressing,
            Touch::Lost | Touch::GivenUp => Status::Lost,
        },
        _ => Status::Holding,
    }
}
