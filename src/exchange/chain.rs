//! Selection of the serial chain from base to tip, and assignment of every other body to one of its
//! joints.

use std::collections::BTreeMap;

use super::ImportError;
use super::import::ImportOptions;
use super::tip::{Tip, candidates, default_tip};
use super::tree::{Tie, Tree, TreeJointKind};

/// The serial arm in a tree.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    /// Index of the base body.
    pub(super) base: usize,
    /// Index of the tip body.
    pub(super) tip: usize,
    /// Joints of gripper fingers before which the arm was assumed to end.
    pub(super) fingers: Vec<usize>,
    /// Moving joints from base to tip, in order.
    pub(super) moving: Vec<usize>,
    /// Number of moving joints before each body; `None` if it is not below the base.
    pub(super) carried_by: Vec<Option<usize>>,
    /// Joints beside the chain that are held, with their positions, rad or m.
    pub(super) held: Vec<(usize, f64)>,
    /// Positions of all joints, rad or m: the moving ones at their reference.
    pub(super) positions: Vec<f64>,
}

impl Chain {
    /// Selects the chain and the positions of all joints beside it.
    pub(super) fn new(tree: &Tree, options: &ImportOptions) -> Result<Self, ImportError> {
        let base = base(tree, options.base.as_deref())?;
        let Tip { body: tip, fingers } = tip(tree, base, options.tip.as_deref())?;
        let Some(path) = tree.path(base, tip) else {
            let (base, tip) = (&tree.bodies[base].name, &tree.bodies[tip].name);
            return Err(ImportError::arm(
                format!("`{tip}` does not hang below `{base}`"),
                "choose a --base on the way from the root to the tip",
            ));
        };
        serial(tree, &path)?;
        let moving: Vec<usize> = path.iter().copied().filter(|&j| tree.joints[j].moves()).collect();
        if moving.is_empty() {
            let (base, tip) = (&tree.bodies[base].name, &tree.bodies[tip].name);
            let ends = candidates(tree, base_root(tree));
            let ends: Vec<&str> = ends.iter().map(|&(body, _)| tree.bodies[body].name.as_str()).collect();
            return Err(ImportError::arm(
                format!("no joint moves between `{base}` and `{tip}`"),
                format!("links with most moving joints above them: {}", ends.join(", ")),
            ));
        }
        let carried_by = carriers(tree, base, &moving);
        loops(tree, &path, &carried_by)?;
        let mut chain = Self { base, tip, fingers, moving, carried_by, held: Vec::new(), positions: Vec::new() };
        chain.hold(tree, options)?;
        Ok(chain)
    }

    /// Sets the positions of the joints beside the chain.
    fn hold(&mut self, tree: &Tree, options: &ImportOptions) -> Result<(), ImportError> {
        let mut given = BTreeMap::new();
        for (name, q) in &options.at {
            let Some(joint) = tree.joints.iter().position(|j| j.name == *name) else {
                let beside = self.beside(tree).into_iter().map(|j| tree.joints[j].name.clone()).collect::<Vec<_>>();
                let mend = if beside.is_empty() { "no joint needs one".into() } else { beside.join(", ") };
                return Err(ImportError::arm(format!("there is no joint `{name}` to hold"), format!("joints: {mend}")));
            };
            let refused = if self.moving.contains(&joint) {
                Some("moves: it is a joint of the arm")
            } else if tree.joints[joint].mimic.is_some() {
                Some("follows another joint; give the position of that one")
            } else {
                (!tree.joints[joint].moves()).then_some("does not move")
            };
            if let Some(refused) = refused {
                return Err(ImportError::arm(format!("`{name}` {refused}"), "leave its --at out"));
            }
            if let Some([low, high]) = tree.joints[joint].position.filter(|[low, high]| !(low..=high).contains(&q)) {
                return Err(ImportError::arm(
                    format!("`{name}` can't be at {q}: it moves from {low} to {high}"),
                    "give a position within that range",
                ));
            }
            given.insert(joint, *q);
        }
        let missing: Vec<usize> =
            self.beside(tree).into_iter().filter(|j| !given.contains_key(&tree.master(*j))).collect();
        self.ask(tree, &missing, options.at_zero)?;
        for joint in missing.iter().map(|&j| tree.master(j)) {
            given.entry(joint).or_insert(nearest_to_zero(tree.joints[joint].position));
        }
        for &joint in &self.moving {
            given.insert(joint, tree.joints[joint].reference);
        }
        self.positions = tree.positions(&given);
        self.held = self.beside(tree).into_iter().map(|j| (j, self.positions[j])).collect();
        Ok(())
    }

    /// Joints whose position changes the arm's load: they move mass and are carried by a joint of
    /// the arm.
    fn beside(&self, tree: &Tree) -> Vec<usize> {
        let matters = |j: usize| {
            let joint = &tree.joints[j];
            let on_arm = self.carried_by[joint.child].is_some_and(|row| row > 0);
            joint.kind != TreeJointKind::Fixed && on_arm && !self.moving.contains(&j) && has_mass(tree, joint.child)
        };
        (0..tree.joints.len()).filter(|&j| matters(j)).collect()
    }

    /// Rejects joints beside the arm without a position.
    fn ask(&self, tree: &Tree, missing: &[usize], zero: bool) -> Result<(), ImportError> {
        for &joint in missing {
            let read = &tree.joints[joint];
            if let TreeJointKind::Other(kind) = read.kind {
                return Err(ImportError::arm(
                    format!("the {kind} joint `{}` carries bodies beside the arm", read.name),
                    "take it out of the file, or choose a --tip before it",
                ));
            }
            let master = tree.master(joint);
            if self.moving.contains(&master) {
                return Err(ImportError::arm(
                    format!(
                        "the joint `{}` beside the arm follows `{}`, a joint of the arm",
                        read.name, tree.joints[master].name
                    ),
                    "no rigid arm moves so; take its <mimic> out, then hold it with --at",
                ));
            }
        }
        if zero || missing.is_empty() {
            return Ok(());
        }
        let mut masters: Vec<usize> = missing.iter().map(|&j| tree.master(j)).collect();
        masters.sort_unstable();
        masters.dedup();
        let names: Vec<&str> = masters.iter().map(|&j| tree.joints[j].name.as_str()).collect();
        let option = |&j: &usize| format!("--at {}={}", tree.joints[j].name, nearest_to_zero(tree.joints[j].position));
        let list: Vec<String> = masters.iter().map(option).collect();
        let tip = &tree.bodies[self.tip].name;
        Err(ImportError::arm(
            format!("joints beside the arm, which ends at `{tip}`, move bodies that it carries: {}", names.join(", ")),
            format!("say where they stand, as in `{}`, or all at once with `--at zero`", list.join(" ")),
        ))
    }
}

/// Zero, or the limit nearest to it.
pub(super) fn nearest_to_zero(position: Option<[f64; 2]>) -> f64 {
    position.filter(|[lower, upper]| lower < upper).map_or(0.0, |[lower, upper]| 0f64.clamp(lower, upper))
}

/// Whether this body, or one below it, has mass or a shape.
fn has_mass(tree: &Tree, body: usize) -> bool {
    let mut waiting = vec![body];
    let mut seen = vec![false; tree.bodies.len()];
    while let Some(body) = waiting.pop() {
        if std::mem::replace(&mut seen[body], true) {
            continue;
        }
        let zero = |i: &dh_codegen::robot::Inertia| i.to_array().iter().all(|p| *p == 0.0);
        let read = &tree.bodies[body];
        if read.inertia.as_ref().map_or(read.shaped, |i| !zero(i)) {
            return true;
        }
        waiting.extend(tree.joints_below(body).map(|j| tree.joints[j].child));
    }
    false
}

/// Number of moving joints of the chain before each body.
fn carriers(tree: &Tree, base: usize, moving: &[usize]) -> Vec<Option<usize>> {
    let mut carried = vec![None; tree.bodies.len()];
    carried[base] = Some(0);
    let mut waiting = vec![base];
    while let Some(body) = waiting.pop() {
        for joint in tree.joints_below(body) {
            let child = tree.joints[joint].child;
            if carried[child].is_none() {
                let own = moving.iter().position(|&j| j == joint).map(|k| k + 1);
                carried[child] = own.or(carried[body]);
                waiting.push(child);
            }
        }
    }
    carried
}

/// Rejects joints of the chain that a serial arm does not have.
fn serial(tree: &Tree, path: &[usize]) -> Result<(), ImportError> {
    for (k, &index) in path.iter().enumerate() {
        let joint = &tree.joints[index];
        if let TreeJointKind::Other(kind) = joint.kind {
            let [parent, child] = [joint.parent, joint.child].map(|b| &tree.bodies[b].name);
            let other = if path[..k].iter().any(|&j| tree.joints[j].moves()) {
                format!(", or the part before it: --tip {parent}")
            } else {
                String::new()
            };
            return Err(ImportError::arm(
                format!("the joint `{}` is {kind}; an arm has joints that turn or slide", joint.name),
                format!("import the part behind it: --base {child}{other}"),
            ));
        }
        if let Some(mimic) = &joint.mimic {
            let other = &tree.joints[mimic.joint].name;
            return Err(ImportError::arm(
                format!(
                    "the joint `{}` follows `{other}` (mimic), and both cannot be one coordinate of a DH table",
                    joint.name
                ),
                "choose --base and --tip so that it is not between them, or take its <mimic> out",
            ));
        }
    }
    Ok(())
}

/// Rejects loops that involve the arm: with a body of the chain in them, or bodies that move
/// relative to each other when the arm does.
fn loops(tree: &Tree, path: &[usize], carried_by: &[Option<usize>]) -> Result<(), ImportError> {
    let on_path = |body: &str| {
        path.iter().any(|&j| tree.bodies[tree.joints[j].child].name == body || tree.joints[j].name == body)
    };
    // Bodies that are not below the base are stationary, like the base.
    let carrier = |name: &String| tree.body(name).map(|body| carried_by[body].unwrap_or(0));
    let tied = |tie: &&Tie| {
        let mut carriers = tie.bodies.iter().filter_map(carrier);
        let first = carriers.next();
        tie.bodies.iter().chain(&tie.joints).any(|name| on_path(name)) || carriers.any(|other| Some(other) != first)
    };
    match tree.ties.iter().find(tied) {
        Some(tie) => Err(ImportError::arm(
            format!("{}; a DH table describes a serial arm", tie.what),
            "choose --base and --tip beside the loop, or open it in the file",
        )),
        None => Ok(()),
    }
}

/// Index of the first root.
fn base_root(tree: &Tree) -> usize {
    (0..tree.bodies.len()).find(|&b| tree.joint_above(b).is_none()).unwrap_or(0)
}

fn base(tree: &Tree, name: Option<&str>) -> Result<usize, ImportError> {
    if let Some(name) = name {
        return tree.body(name).ok_or_else(|| unknown(tree, "--base", name));
    }
    let roots: Vec<usize> = (0..tree.bodies.len()).filter(|&b| tree.joint_above(b).is_none()).collect();
    match roots[..] {
        [root] => Ok(root),
        [] => Err(ImportError::arm("every link hangs on another one: a closed loop", "name the arm's --base")),
        _ => {
            let names: Vec<&str> = roots.iter().map(|&b| tree.bodies[b].name.as_str()).collect();
            Err(ImportError::arm(
                format!("{} links hang on no other: {}", names.len(), names.join(", ")),
                "name the arm's with --base",
            ))
        }
    }
}

fn tip(tree: &Tree, base: usize, name: Option<&str>) -> Result<Tip, ImportError> {
    let Some(name) = name else { return default_tip(tree, base) };
    let body = tree.body(name).ok_or_else(|| unknown(tree, "--tip", name))?;
    Ok(Tip { body, fingers: Vec::new() })
}

fn unknown(tree: &Tree, option: &str, name: &str) -> ImportError {
    let names: Vec<&str> = tree.bodies.iter().map(|b| b.name.as_str()).collect();
    let shown = if names.len() > 40 { format!("{}, ..", names[..40].join(", ")) } else { names.join(", ") };
    ImportError::arm(format!("{option}: there is no link `{name}`"), format!("links: {shown}"))
}
