//! The state machine of the controller: one pure function from a state and what a step has shown to
//! the next state. docs/control.md has it as a table.
//!
//! Nothing here knows a robot. `tests/machine.rs` walks all states under all guards.

/// Why it does not press any more.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Fault {
    /// No positions for too long, or too few of them.
    Position,
    /// A measured position does not change by a bit while its joint is sent away.
    Frozen,
    /// Time stamps and steps disagree.
    Clock,
    /// The model gives no numbers for too long.
    Model,
    /// A joint is beyond its range.
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
    /// The force does not change by a bit while the tool is sent deeper, or along the wall.
    Stuck,
    /// No force for too long.
    Force,
    /// No contact for too long.
    Contact,
}

/// What is left to stop an arm with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Reaction {
    /// Positions, model and plan can be relied on: the tool leaves the wall while the plan's path
    /// is followed to a stop, then the posture is held.
    Path,
    /// Positions can be relied on, but not what the arm is sent to: damping and gravity.
    Damped,
    /// Nothing is known of the motion: gravity, and the brakes at once.
    Blind,
}

impl Fault {
    /// All of them, the most severe first.
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

    /// How it is answered.
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
    /// Has nothing to follow yet: damping and gravity.
    Waiting,
    /// Follows the plan; no force was asked for.
    Free,
    /// On the way to the wall.
    Approaching,
    /// Presses.
    Pressing,
    /// Looks for a contact that is lost.
    Lost,
    /// Waits for a sample, a force or the model, no longer than the patience lasts.
    Holding,
    /// Leaves the wall while the plan's path is followed to a stop.
    Leaving(Fault),
    /// Comes to rest.
    Stopping(Fault),
    /// Rests, or hangs on gravity where positions are missing, until [`Controller::reset`].
    ///
    /// [`Controller::reset`]: super::Controller::reset
    Stopped(Fault),
}

impl Status {
    /// Why it leaves, stops or has stopped.
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
    /// Can be used.
    Good,
    /// Missing, stale, no number, or a leap.
    Bad,
    /// Another one of too many.
    Gone,
    /// Its stamp and the count of steps disagree.
    Jumped,
}

/// What the plan asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Wanted {
    /// There was no target yet.
    Nothing,
    /// Motion away from the wall.
    Free,
    /// A force.
    Press,
}

/// What the force says of the contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Touch {
    /// None so far.
    NotYet,
    /// There is, or was a moment ago.
    Touches,
    /// Lost, and looked for.
    Lost,
    /// Looked for in vain.
    GivenUp,
}

/// The guards: what one step has shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Seen {
    /// The sample.
    pub arrival: Arrival,
    /// Whether the model gave numbers when it was last asked.
    pub model: bool,
    /// Whether this step's target is sound and within the limits.
    pub plan: bool,
    /// What the last sound target asks for.
    pub wanted: Wanted,
    /// Whether there is a force.
    pub force: bool,
    /// The contact.
    pub touch: Touch,
    /// The most severe limit that is exceeded: any but [`Fault::Position`], [`Fault::Clock`] and
    /// [`Fault::Contact`]. [`Fault::Model`], [`Fault::Plan`] and [`Fault::Force`] are among them
    /// where the patience is never over and yet too many steps fail.
    pub limit: Option<Fault>,
    /// Whether the tool is off the wall and the path has come to its stop.
    pub clear: bool,
    /// Whether the joints rest and the path has come to its stop.
    pub rest: bool,
}

/// Longest stays, in steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Bounds {
    /// Steps in a row that samples, force, model or targets may fail.
    pub patience: u32,
    /// In [`Status::Leaving`].
    pub leave: u32,
    /// In [`Status::Stopping`].
    pub stop: u32,
}

/// The state with its counters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Machine {
    status: Status,
    /// Steps in a row without a sample or a model, so that torques were held; without a target; and
    /// without a force.
    held: u32,
    unplanned: u32,
    blind: u32,
    /// Steps that are left in [`Status::Leaving`] and [`Status::Stopping`].
    left: u32,
}

impl Default for Machine {
    fn default() -> Self {
        Self { status: Status::Waiting, held: 0, unplanned: 0, blind: 0, left: 0 }
    }
}

impl Machine {
    /// The state.
    pub fn status(self) -> Status {
        self.status
    }

    /// The state after a step.
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
            // One count for both: held by turns is held all the same.
            held: count(self.held, !arrived || !seen.model),
            unplanned: count(self.unplanned, !seen.plan && seen.wanted != Wanted::Nothing),
            // Without a sample nothing is known of the force.
            blind: if looked { count(self.blind, !seen.force && seen.wanted == Wanted::Press) } else { self.blind },
            left: self.left,
        }
    }

    /// The gravest of what is wrong.
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

    /// A fault is only replaced by one that leaves less to stop with.
    fn is_graver(&self, fault: Fault) -> bool {
        self.status.fault().is_none_or(|old| fault.reaction() > old.reaction())
    }

    fn failed(self, fault: Fault, seen: &Seen, bounds: &Bounds) -> Self {
        let (status, left) = match (fault.reaction(), self.status) {
            (Reaction::Blind, _) | (_, Status::Stopped(_)) => (Status::Stopped(fault), 0),
            // The time to come to rest is not begun again.
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

/// Without a fault the state follows from what is seen.
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
