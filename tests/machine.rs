//! Exhaustive test of the controller's state machine: all states under all guards.

use std::collections::{HashMap, HashSet};
use std::sync::OnceLock;

use denavit::control::law::{Arrival, Bounds, Fault, Machine, Reaction, Seen, Status, Touch, Wanted};

/// Bounds for the tests of single transitions; `SHORT` is for the exploration of all states.
const BOUNDS: Bounds = Bounds { patience: 2, leave: 3, stop: 4 };
const SHORT: Bounds = Bounds { patience: 1, leave: 2, stop: 2 };
/// The shortest bounds that settings can give.
const NONE: Bounds = Bounds { patience: 0, leave: 1, stop: 1 };

const WELL: Seen = Seen {
    arrival: Arrival::Good,
    model: true,
    plan: true,
    wanted: Wanted::Press,
    force: true,
    touch: Touch::Touches,
    limit: None,
    clear: false,
    rest: false,
};

/// Faults that the controller can report as a limit.
const LIMITS: [Fault; 10] = [
    Fault::Frozen,
    Fault::Model,
    Fault::Joint,
    Fault::Speed,
    Fault::Torque,
    Fault::Plan,
    Fault::Reach,
    Fault::Excess,
    Fault::Stuck,
    Fault::Force,
];

/// All guard values.
fn guards() -> Vec<Seen> {
    let both = [false, true];
    let limits: Vec<Option<Fault>> = [None].into_iter().chain(LIMITS.map(Some)).collect();
    let mut all = Vec::new();
    for arrival in [Arrival::Good, Arrival::Bad, Arrival::Gone, Arrival::Jumped] {
        for wanted in [Wanted::Nothing, Wanted::Free, Wanted::Press] {
            for touch in [Touch::NotYet, Touch::Touches, Touch::Lost, Touch::GivenUp] {
                for &limit in &limits {
                    for [model, plan, force] in
                        both.iter().flat_map(|a| both.map(|b| both.map(|c| [*a, b, c]))).flatten()
                    {
                        for [clear, rest] in both.map(|a| both.map(|b| [a, b])).concat() {
                            all.push(Seen { arrival, model, plan, wanted, force, touch, limit, clear, rest });
                        }
                    }
                }
            }
        }
    }
    all
}

/// Successors of a state.
#[derive(Default)]
struct Next {
    all: HashSet<Machine>,
    /// Successors by steps in which torques are held: no sample or no model, and no fault whose
    /// reaction does not need them.
    held: HashSet<Machine>,
}

/// States with their successors.
type Graph = HashMap<Machine, Next>;

/// Every state that is reachable with short bounds, with its successors. The bounds are the only
/// numbers in the machine.
fn explored() -> &'static [(Bounds, Graph); 2] {
    static GRAPHS: OnceLock<[(Bounds, Graph); 2]> = OnceLock::new();
    GRAPHS.get_or_init(|| [SHORT, NONE].map(|bounds| (bounds, explore(&bounds))))
}

fn explore(bounds: &Bounds) -> Graph {
    let guards = guards();
    let mut found = Graph::new();
    let mut open = vec![Machine::default()];
    while let Some(state) = open.pop() {
        if found.contains_key(&state) {
            continue;
        }
        let mut next = Next::default();
        for seen in &guards {
            let after = state.next(seen, bounds);
            invariant(state, seen, after);
            if holds(seen) && after.status().fault().is_none_or(|fault| fault.reaction() == Reaction::Path) {
                next.held.insert(after);
            }
            next.all.insert(after);
        }
        open.extend(next.all.iter().filter(|m| !found.contains_key(m)));
        found.insert(state, next);
    }
    found
}

/// Whether torques are held for lack of a sample or of a model.
fn holds(seen: &Seen) -> bool {
    matches!(seen.arrival, Arrival::Bad | Arrival::Gone) || !seen.model
}

/// Invariant of every step.
fn invariant(state: Machine, seen: &Seen, next: Machine) {
    let (before, after) = (state.status(), next.status());
    // A fault is never left, nor replaced by one with a milder reaction.
    if let Some(fault) = before.fault() {
        assert!(after.fault().is_some_and(|then| then.reaction() >= fault.reaction()), "{state:?} {seen:?}");
        assert!(!before.brakes() || after.brakes(), "{state:?} {seen:?}");
        assert!(!matches!((before, after), (Status::Stopping(_), Status::Leaving(_))), "{state:?} {seen:?}");
    }
    // A fault has its cause, and no immediate cause is ignored.
    match (before.fault(), after.fault()) {
        (None, Some(fault)) => assert!(is_cause(seen, fault), "{state:?} {seen:?} {after:?}"),
        (_, None) => {
            let at_once = [Fault::Clock, Fault::Contact].iter().any(|fault| is_cause(seen, *fault));
            assert!(!at_once && seen.limit.is_none() && seen.arrival != Arrival::Gone, "{state:?} {seen:?}");
        }
        _ => {}
    }
    // It presses and follows only with all required inputs.
    if matches!(after, Status::Free | Status::Approaching | Status::Pressing | Status::Lost) {
        assert!(seen.arrival == Arrival::Good && seen.model && seen.limit.is_none(), "{state:?} {seen:?}");
        assert!(after == Status::Free || (seen.wanted == Wanted::Press && seen.force), "{state:?} {seen:?}");
    }
}

/// Whether the observations cause a fault, perhaps after more such steps.
fn is_cause(seen: &Seen, fault: Fault) -> bool {
    let presses = seen.wanted == Wanted::Press;
    let missing = match fault {
        Fault::Position => matches!(seen.arrival, Arrival::Bad | Arrival::Gone),
        Fault::Clock => seen.arrival == Arrival::Jumped,
        Fault::Model => !seen.model,
        Fault::Plan => !seen.plan && seen.wanted != Wanted::Nothing,
        Fault::Force => presses && !seen.force,
        Fault::Contact => presses && seen.touch == Touch::GivenUp,
        _ => false,
    };
    missing || seen.limit == Some(fault)
}

/// Largest number of steps on all paths from a state along these edges, until there is none or the
/// brakes are requested; a cycle fails.
fn longest(
    graph: &Graph,
    state: Machine,
    along: fn(&Next) -> &HashSet<Machine>,
    known: &mut HashMap<Machine, u32>,
) -> u32 {
    if state.status().brakes() {
        return 0;
    }
    if let Some(&steps) = known.get(&state) {
        assert_ne!(steps, u32::MAX, "a circle: {state:?}");
        return steps;
    }
    known.insert(state, u32::MAX);
    let steps = along(&graph[&state]).iter().map(|next| 1 + longest(graph, *next, along, known)).max().unwrap_or(0);
    known.insert(state, steps);
    steps
}

#[test]
fn every_fault_ends_in_brakes_and_only_a_reset_ends_a_fault() {
    for (bounds, graph) in explored() {
        let mut known = HashMap::new();
        let failed: Vec<Machine> = graph.keys().filter(|m| m.status().fault().is_some()).copied().collect();
        let kinds: HashSet<Fault> = failed.iter().filter_map(|m| m.status().fault()).collect();
        assert_eq!(kinds.len(), Fault::ALL.len(), "{kinds:?}");
        let all = |state: &Machine, known: &mut _| longest(graph, *state, |next| &next.all, known);
        let worst = failed.iter().map(|state| all(state, &mut known)).max().unwrap();
        assert!(worst <= bounds.leave + bounds.stop, "{worst}");
        println!("{} states, {} guard values, {worst} steps to the brakes at most", graph.len(), guards().len());
    }
}

/// docs/control.md has the number of states and guards explored.
#[test]
fn the_document_says_what_is_walked() {
    let text = include_str!("../docs/control.md").replace('\n', " ");
    let [states, none] = [0, 1].map(|k| explored()[k].1.len());
    let guards = guards().len();
    let said = format!(
        "({},{:03} of them, each limit by itself; {states} states, counters included, with stays of 1 and 2 steps, and {none} without patience",
        guards / 1000,
        guards % 1000
    );
    assert!(text.contains(&said), "docs/control.md doesn't say: {said}");
}

/// For any sequence of steps; one more step would show that the patience is exceeded.
#[test]
fn no_torque_is_held_for_longer_than_the_patience() {
    for (bounds, graph) in explored() {
        let mut known = HashMap::new();
        let worst = graph.keys().map(|state| longest(graph, *state, |next| &next.held, &mut known)).max().unwrap();
        assert_eq!(worst, bounds.patience);
    }
}

/// State after a number of steps with the same observations.
fn after(state: Machine, seen: Seen, steps: u32) -> Machine {
    (0..steps).fold(state, |at, _| at.next(&seen, &BOUNDS))
}

/// A machine in a state without a fault.
fn working(seen: Seen) -> Machine {
    after(Machine::default(), seen, 1)
}

/// The table of docs/control.md, row by row: states without a fault.
#[test]
fn transitions_without_a_fault() {
    let free = Seen { wanted: Wanted::Free, ..WELL };
    let rows = [
        (Seen { wanted: Wanted::Nothing, ..WELL }, Status::Waiting),
        (free, Status::Free),
        (Seen { touch: Touch::NotYet, ..WELL }, Status::Approaching),
        (WELL, Status::Pressing),
        (Seen { touch: Touch::Lost, ..WELL }, Status::Lost),
        (Seen { arrival: Arrival::Bad, ..WELL }, Status::Holding),
        (Seen { arrival: Arrival::Bad, ..free }, Status::Holding),
        (Seen { model: false, ..WELL }, Status::Holding),
        (Seen { model: false, ..free }, Status::Holding),
        (Seen { force: false, ..WELL }, Status::Holding),
        // If no force is desired, none is needed; a single target that is not followed is held.
        (Seen { force: false, ..free }, Status::Free),
        (Seen { plan: false, ..WELL }, Status::Pressing),
        (Seen { plan: false, ..free }, Status::Free),
    ];
    // From each of these states to each other in one step.
    for (from, _) in &rows {
        for (to, status) in &rows {
            assert_eq!(working(*from).next(to, &BOUNDS).status(), *status, "{from:?} {to:?}");
        }
    }
    assert_eq!(Machine::default().status(), Status::Waiting);
}

/// Causes of each fault, with the number of steps until it occurs.
fn causes(base: Seen) -> Vec<(Fault, Seen, u32)> {
    let many = BOUNDS.patience + 1;
    let mut all = vec![
        (Fault::Position, Seen { arrival: Arrival::Bad, ..base }, many),
        (Fault::Position, Seen { arrival: Arrival::Gone, ..base }, 1),
        (Fault::Clock, Seen { arrival: Arrival::Jumped, ..base }, 1),
        (Fault::Model, Seen { model: false, ..base }, many),
        (Fault::Plan, Seen { plan: false, ..base }, many),
    ];
    all.extend(LIMITS.map(|limit| (limit, Seen { limit: Some(limit), ..base }, 1)));
    if base.wanted == Wanted::Press {
        all.push((Fault::Force, Seen { force: false, ..base }, many));
        all.push((Fault::Contact, Seen { touch: Touch::GivenUp, ..base }, 1));
    }
    all
}

/// Each fault from each working state: not earlier than its guard, and with the state of its
/// reaction.
#[test]
fn transitions_to_each_fault() {
    let mut met = HashSet::new();
    for wanted in [Wanted::Free, Wanted::Press] {
        let base = Seen { wanted, ..WELL };
        for touch in [Touch::NotYet, Touch::Touches, Touch::Lost] {
            let base = Seen { touch, ..base };
            for (fault, seen, steps) in causes(base) {
                let before = after(working(base), seen, steps - 1);
                assert_eq!(before.status().fault(), None, "{fault:?} {seen:?}");
                let status = before.next(&seen, &BOUNDS).status();
                let expected = match fault.reaction() {
                    Reaction::Blind => Status::Stopped(fault),
                    Reaction::Path if wanted == Wanted::Press => Status::Leaving(fault),
                    Reaction::Damped | Reaction::Path => Status::Stopping(fault),
                };
                assert_eq!(status, expected, "{seen:?}");
                met.insert(fault);
                // One good step in between restarts the count.
                if steps > 1 {
                    let again = after(before.next(&base, &BOUNDS), seen, steps - 1);
                    assert_eq!(again.status().fault(), None, "{fault:?}");
                }
            }
        }
    }
    assert_eq!(met.len(), Fault::ALL.len());
    // Without a plan none can be missing.
    let nothing = Seen { wanted: Wanted::Nothing, plan: false, ..WELL };
    assert_eq!(after(Machine::default(), nothing, 10).status(), Status::Waiting);
    let blind = Seen { wanted: Wanted::Free, force: false, ..WELL };
    assert_eq!(after(Machine::default(), blind, 10).status(), Status::Free);
}

/// From each fault to its end: by the guard, by the time, and by a more severe fault.
#[test]
fn transitions_from_each_fault() {
    for (fault, seen, steps) in causes(WELL) {
        let failed = after(working(WELL), seen, steps);
        match failed.status() {
            Status::Leaving(_) => {
                let clear = Seen { clear: true, ..WELL };
                assert_eq!(failed.next(&clear, &BOUNDS).status(), Status::Stopping(fault));
                assert_eq!(after(failed, WELL, BOUNDS.leave - 1).status(), Status::Leaving(fault));
                assert_eq!(after(failed, WELL, BOUNDS.leave).status(), Status::Stopping(fault));
                // Rest on the wall does not end it.
                assert_eq!(failed.next(&Seen { rest: true, ..WELL }, &BOUNDS).status(), Status::Leaving(fault));
            }
            Status::Stopping(_) => {
                let rest = Seen { rest: true, ..WELL };
                assert_eq!(failed.next(&rest, &BOUNDS).status(), Status::Stopped(fault));
                assert_eq!(after(failed, WELL, BOUNDS.stop - 1).status(), Status::Stopping(fault));
                assert_eq!(after(failed, WELL, BOUNDS.stop).status(), Status::Stopped(fault));
            }
            status => assert_eq!(after(failed, WELL, 50).status(), status),
        }
        for (other, seen, steps) in causes(WELL) {
            let then = after(failed, seen, steps);
            let graver = other.reaction() > fault.reaction();
            assert_eq!(then.status().fault(), Some(if graver { other } else { fault }), "{fault:?} {other:?}");
        }
    }
    // The time to come to rest is not restarted by a more severe fault.
    let stopping = after(working(WELL), Seen { wanted: Wanted::Free, limit: Some(Fault::Reach), ..WELL }, 1);
    let graver = after(stopping, WELL, 2).next(&Seen { limit: Some(Fault::Speed), ..WELL }, &BOUNDS);
    assert_eq!(graver.status(), Status::Stopping(Fault::Speed));
    assert_eq!(after(graver, WELL, BOUNDS.stop - 2).status(), Status::Stopped(Fault::Speed));
}

/// Of several faults at once the most severe counts.
#[test]
fn the_gravest_fault_counts() {
    let all_at_once = Seen { arrival: Arrival::Gone, limit: Some(Fault::Stuck), touch: Touch::GivenUp, ..WELL };
    assert_eq!(working(WELL).next(&all_at_once, &BOUNDS).status(), Status::Stopped(Fault::Position));
    let jumped = Seen { arrival: Arrival::Jumped, limit: Some(Fault::Frozen), ..WELL };
    assert_eq!(working(WELL).next(&jumped, &BOUNDS).status(), Status::Stopped(Fault::Frozen));
    let jumped = Seen { arrival: Arrival::Jumped, limit: Some(Fault::Speed), ..WELL };
    assert_eq!(working(WELL).next(&jumped, &BOUNDS).status(), Status::Stopping(Fault::Clock));
    let fast = Seen { limit: Some(Fault::Speed), touch: Touch::GivenUp, ..WELL };
    assert_eq!(working(WELL).next(&fast, &BOUNDS).status(), Status::Stopping(Fault::Speed));
    for pair in Fault::ALL.windows(2) {
        assert!(pair[0].reaction() >= pair[1].reaction(), "{pair:?}");
    }
}
