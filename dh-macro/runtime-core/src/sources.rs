//! The text of this crate's modules, for generated crates that carry a copy.
//!
//! An arm needs one family of the inverse kinematics. Regions between `// [six]` and `// [/six]`
//! belong to robots of that family; `six|swivel` stands for either. The families are `six`,
//! `swivel`, `plane`, `general` and `numerical`; `nearby` is for arms that are only nearly of their family.

/// A module: its path below `src/`, its text, and the families that need it (empty: every robot).
pub type Source = (&'static str, &'static str, &'static str);

/// Modules for robots with effects.
pub const WITH_EFFECTS: &[Source] =
    &[("drive.rs", include_str!("drive.rs"), ""), ("elementary.rs", include_str!("elementary.rs"), "")];

/// Modules for every robot, or for those of the named families.
pub const FILES: &[Source] = &[
    ("ik.rs", include_str!("ik.rs"), ""),
    ("ik/arm.rs", include_str!("ik/arm.rs"), ""),
    ("ik/axis.rs", include_str!("ik/axis.rs"), ""),
    ("ik/candidates.rs", include_str!("ik/candidates.rs"), ""),
    ("ik/dense.rs", include_str!("ik/dense.rs"), "general"),
    ("ik/differential.rs", include_str!("ik/differential.rs"), ""),
    ("ik/doubt.rs", include_str!("ik/doubt.rs"), ""),
    ("ik/elimination.rs", include_str!("ik/elimination.rs"), "general"),
    ("ik/general.rs", include_str!("ik/general.rs"), "general"),
    ("ik/harmonics.rs", include_str!("ik/harmonics.rs"), "general"),
    ("ik/homotopy.rs", include_str!("ik/homotopy.rs"), "nearby"),
    ("ik/interval.rs", include_str!("ik/interval.rs"), "swivel"),
    ("ik/lanes.rs", include_str!("ik/lanes.rs"), ""),
    ("ik/list.rs", include_str!("ik/list.rs"), ""),
    ("ik/nearby.rs", include_str!("ik/nearby.rs"), "nearby"),
    ("ik/newton.rs", include_str!("ik/newton.rs"), "general"),
    ("ik/numerical.rs", include_str!("ik/numerical.rs"), "numerical"),
    ("ik/orient.rs", include_str!("ik/orient.rs"), "six|swivel"),
    ("ik/plane.rs", include_str!("ik/plane.rs"), "plane"),
    ("ik/polish.rs", include_str!("ik/polish.rs"), ""),
    ("ik/pose.rs", include_str!("ik/pose.rs"), ""),
    ("ik/quartic.rs", include_str!("ik/quartic.rs"), "six"),
    ("ik/real.rs", include_str!("ik/real.rs"), ""),
    ("ik/redundancy.rs", include_str!("ik/redundancy.rs"), "six|general"),
    ("ik/reference.rs", include_str!("ik/reference.rs"), ""),
    ("ik/regional.rs", include_str!("ik/regional.rs"), "six"),
    ("ik/six.rs", include_str!("ik/six.rs"), "six"),
    ("ik/slides.rs", include_str!("ik/slides.rs"), "general"),
    ("ik/solution.rs", include_str!("ik/solution.rs"), ""),
    ("ik/subproblem.rs", include_str!("ik/subproblem.rs"), ""),
    ("ik/swivel.rs", include_str!("ik/swivel.rs"), "swivel"),
    ("ik/vector.rs", include_str!("ik/vector.rs"), ""),
    ("robot.rs", include_str!("robot.rs"), ""),
    ("runtime.rs", include_str!("runtime.rs"), ""),
    ("runtime/block.rs", include_str!("runtime/block.rs"), ""),
    ("runtime/dispatch.rs", include_str!("runtime/dispatch.rs"), ""),
    ("runtime/pack.rs", include_str!("runtime/pack.rs"), ""),
    ("runtime/registers.rs", include_str!("runtime/registers.rs"), ""),
    ("runtime/scalar.rs", include_str!("runtime/scalar.rs"), ""),
    ("runtime/sincos.rs", include_str!("runtime/sincos.rs"), ""),
];
