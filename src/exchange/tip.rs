//! End of an arm: the leaf behind the most joints, before the fingers of a gripper.

use std::collections::BTreeSet;

use super::ImportError;
use super::displacement::Displacement;
use super::tree::{Tree, TreeJointKind};

/// Longest stroke of a gripper's finger, m; a longer slide counts as an axis of the arm.
const STROKE: f64 = 0.2;

/// Limit on the joints searched behind a joint: more than a finger has.
const FINGER: usize = 20;

/// Default end of an arm.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tip {
    /// Index of the body.
    pub(super) body: usize,
    /// Joints of gripper fingers behind it.
    pub(super) fingers: Vec<usize>,
}

/// A possible end link of the arm, and the number of moving joints before it.
type End = (usize, usize);

/// Joints that leave one rigid part, each the first of a branch that moves independently.
#[derive(Debug, Clone, PartialEq)]
struct Fork {
    /// Last body that carries all branches.
    carrier: usize,
    branches: Vec<usize>,
}

/// The only leaf behind the most moving joints; if it is a finger, the link that carries the
/// gripper's fingers.
pub(super) fn default_tip(tree: &Tree, base: usize) -> Result<Tip, ImportError> {
    let grippers = grippers(tree, base);
    let best = best(tree, base, &grippers);
    if best.first().is_none_or(|(_, joints)| *joints == 0) {
        let base = &tree.bodies[base].name;
        return Err(ImportError::arm(
            format!("no joint moves below `{base}`"),
            "choose another --base, or another file",
        ));
    }
    match best[..] {
        [(body, _)] if arm_end(tree, base, body, Some(&grippers)).is_none() => {
            let fingers = grippers.iter().filter(|g| g.carrier == body).flat_map(|g| g.branches.clone()).collect();
            Ok(Tip { body, fingers })
        }
        _ => Err(several(tree, &best, &candidates(tree, base))),
    }
}

/// Error that names the ends to choose from.
fn several(tree: &Tree, best: &[End], candidates: &[End]) -> ImportError {
    let mend = "choose one with --tip, or any link on the way to it";
    let most = best.first().map_or(0, |(_, joints)| *joints);
    let name = |body: usize| &tree.bodies[body].name;
    if candidates.iter().all(|(_, joints)| *joints == most) {
        let names: Vec<&str> = candidates.iter().map(|&(body, _)| name(body).as_str()).collect();
        let what = format!("{} links end a chain of {most} moving joints: {}", names.len(), names.join(", "));
        return ImportError::arm(what, mend);
    }
    let names: Vec<String> = candidates.iter().map(|&(body, joints)| format!("{} ({joints})", name(body))).collect();
    ImportError::arm(
        format!(
            "several links may be the end, first that before the branches, with moving joints: {}",
            names.join(", ")
        ),
        mend,
    )
}

/// Ends with the most moving joints, those before a branching first.
pub(super) fn candidates(tree: &Tree, base: usize) -> Vec<End> {
    let grippers = grippers(tree, base);
    let best = best(tree, base, &grippers);
    let only = (best.len() == 1).then_some(&grippers[..]);
    let before = best.iter().filter_map(|&(body, _)| arm_end(tree, base, body, only));
    let mut ends: Vec<End> = Vec::new();
    for end in before.chain(best.iter().copied()) {
        if !ends.contains(&end) {
            ends.push(end);
        }
    }
    ends
}

/// Leaves behind the most moving joints; for a gripper's finger, the link that carries it.
fn best(tree: &Tree, base: usize, grippers: &[Fork]) -> Vec<End> {
    let mut ends: Vec<End> = Vec::new();
    for leaf in leaves(tree, base) {
        let path = tree.path(base, leaf).unwrap_or_default();
        let gripper = path.iter().find_map(|joint| grippers.iter().find(|g| g.branches.contains(joint)));
        let end = gripper.map_or(leaf, |g| g.carrier);
        let end = (end, moving_before(tree, base, end));
        if !ends.contains(&end) {
            ends.push(end);
        }
    }
    let most = ends.iter().map(|(_, joints)| *joints).max().unwrap_or(0);
    ends.retain(|(_, joints)| *joints == most);
    ends
}

/// The first link on the way to a body where the chain branches and fewer joints are behind than
/// before, as with the fingers of a hand. With grippers, only where one of them is.
fn arm_end(tree: &Tree, base: usize, body: usize, grippers: Option<&[Fork]>) -> Option<End> {
    let all = moving_before(tree, base, body);
    let moving = tree.path(base, body)?.into_iter().filter(|&j| tree.joints[j].moves());
    let parts = moving.enumerate().map(|(k, joint)| (k + 1, tree.joints[joint].child));
    let fork = |(before, part): (usize, usize)| {
        let branches = branches(tree, part);
        let here = grippers.is_none_or(|all| all.iter().any(|g| g.branches.iter().any(|j| branches.contains(j))));
        (before < all && all - before < before && branches.len() > 1 && here)
            .then(|| (common(tree, base, &branches), before))
    };
    parts.filter_map(fork).next()
}

/// Bodies below `base` that carry no joint.
fn leaves(tree: &Tree, base: usize) -> Vec<usize> {
    let ends =
        |&b: &usize| !tree.bodies[b].site && tree.joints_below(b).all(|j| tree.bodies[tree.joints[j].child].site);
    (0..tree.bodies.len()).filter(ends).filter(|&b| tree.path(base, b).is_some()).collect()
}

fn moving_before(tree: &Tree, base: usize, body: usize) -> usize {
    tree.path(base, body).unwrap_or_default().iter().filter(|&&j| tree.joints[j].moves()).count()
}

/// Grippers: fingers that one actuator moves, or that slide along one direction, behind a joint.
fn grippers(tree: &Tree, base: usize) -> Vec<Fork> {
    let all = below(tree, base, usize::MAX, |_| true);
    let moving = all.into_iter().filter(|&j| tree.joints[j].moves());
    moving
        .map(|j| tree.joints[j].child)
        .flat_map(|part| {
            let branches = branches(tree, part);
            [followers(tree, &branches), sliders(tree, &branches)]
        })
        .filter(|branches| branches.len() > 1)
        .map(|branches| Fork { carrier: common(tree, base, &branches), branches })
        .collect()
}

/// Branches of a rigid part in which all joints follow one actuator of these branches.
fn followers(tree: &Tree, branches: &[usize]) -> Vec<usize> {
    let actuator = |branch: usize| {
        let joints = moved_by(tree, branch);
        let first = tree.master(branch);
        joints.iter().all(|&j| tree.joints[j].moves() && tree.master(j) == first).then_some(first)
    };
    let tied: Vec<(usize, usize)> = branches.iter().filter_map(|&b| Some((b, actuator(b)?))).collect();
    let of = |actuator: usize| -> Vec<usize> {
        tied.iter().filter(|(_, other)| *other == actuator).map(|(branch, _)| *branch).collect()
    };
    let whole = |fingers: &Vec<usize>, actuator: usize| {
        let inside: Vec<usize> = fingers.iter().flat_map(|&f| moved_by(tree, f)).collect();
        (0..tree.joints.len()).filter(|&j| tree.master(j) == actuator).all(|j| inside.contains(&j))
    };
    let all = tied.iter().map(|&(_, actuator)| (of(actuator), actuator));
    all.filter(|(fingers, actuator)| fingers.len() > 1 && whole(fingers, *actuator))
        .map(|(fingers, _)| fingers)
        .next()
        .unwrap_or_default()
}

/// Branches of a rigid part that are one short slide each, all parallel.
fn sliders(tree: &Tree, branches: &[usize]) -> Vec<usize> {
    let short = |&&j: &&usize| {
        let joint = &tree.joints[j];
        joint.kind == TreeJointKind::Prismatic
            && joint.mimic.is_none()
            && moved_by(tree, j).len() == 1
            && joint.position.is_some_and(|[low, high]| high - low <= STROKE)
    };
    let slides: Vec<usize> = branches.iter().filter(short).copied().collect();
    let [first, _, ..] = slides[..] else { return Vec::new() };
    let Some(part) = rigid_root(tree, first) else { return Vec::new() };
    let along = |j: usize| {
        let joint = &tree.joints[j];
        let fixed = tree.path(part, joint.parent)?.into_iter().map(|f| tree.joints[f].displacement(0.0));
        let pose = fixed.fold(Displacement::identity(), |pose, next| pose.then(&next));
        Some(pose.then(&joint.origin).rotation * joint.axis)
    };
    let axes: Vec<_> = slides.iter().filter_map(|&j| along(j)).collect();
    let parallel = axes.len() == slides.len() && axes.iter().all(|axis| axis.cross(&axes[0]).norm() < 0.01);
    if parallel { slides } else { Vec::new() }
}

/// First body of the rigid part to which a joint is attached.
fn rigid_root(tree: &Tree, joint: usize) -> Option<usize> {
    let mut body = tree.joints[joint].parent;
    for _ in 0..tree.joints.len() {
        match tree.joint_above(body) {
            Some(above) if tree.joints[above].kind == TreeJointKind::Fixed => body = tree.joints[above].parent,
            _ => return Some(body),
        }
    }
    None
}

/// First joints of everything that moves relative to the rigid part beginning with `body`.
fn branches(tree: &Tree, body: usize) -> Vec<usize> {
    below(tree, body, usize::MAX, |kind| kind == TreeJointKind::Fixed)
        .into_iter()
        .filter(|&j| tree.joints[j].kind != TreeJointKind::Fixed)
        .collect()
}

/// Non-fixed joints that move with a joint, itself included. The search is limited to the number of
/// joints of fingers, so that large trees take no longer.
fn moved_by(tree: &Tree, joint: usize) -> Vec<usize> {
    let behind = below(tree, tree.joints[joint].child, FINGER, |_| true);
    std::iter::once(joint).chain(behind).filter(|&j| tree.joints[j].kind != TreeJointKind::Fixed).collect()
}

/// Joints below a body, through joints of the kinds that `passed` accepts, until there are `most`.
fn below(tree: &Tree, body: usize, most: usize, passed: impl Fn(TreeJointKind) -> bool) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    let mut seen = BTreeSet::from([body]);
    let mut waiting = vec![body];
    while let Some(body) = waiting.pop().filter(|_| found.len() < most) {
        for joint in tree.joints_below(body) {
            found.push(joint);
            let read = &tree.joints[joint];
            if passed(read.kind) && seen.insert(read.child) {
                waiting.push(read.child);
            }
        }
    }
    found.sort_unstable();
    found
}

/// Last body common to the paths to all of these joints.
fn common(tree: &Tree, base: usize, joints: &[usize]) -> usize {
    let paths: Vec<Vec<usize>> = joints.iter().filter_map(|&j| tree.path(base, tree.joints[j].parent)).collect();
    let Some(first) = paths.first() else { return base };
    let shared = first.iter().enumerate().take_while(|(k, joint)| paths.iter().all(|p| p.get(*k) == Some(joint)));
    shared.last().map_or(base, |(_, &joint)| tree.joints[joint].child)
}
