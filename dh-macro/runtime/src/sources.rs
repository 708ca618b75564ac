//! The text of this crate's modules, for generated crates that carry a copy.

/// Path below `src/` and text of the modules for robots with effects.
pub const WITH_EFFECTS: &[(&str, &str)] =
    &[("drive.rs", include_str!("drive.rs")), ("elementary.rs", include_str!("elementary.rs"))];

/// Path below `src/` and text of the modules that every generated crate has.
pub const FILES: &[(&str, &str)] = &[
    ("ik.rs", include_str!("ik.rs")),
    ("ik/arm.rs", include_str!("ik/arm.rs")),
    ("ik/axis.rs", include_str!("ik/axis.rs")),
    ("ik/candidates.rs", include_str!("ik/candidates.rs")),
    ("ik/doubt.rs", include_str!("ik/doubt.rs")),
    ("ik/homotopy.rs", include_str!("ik/homotopy.rs")),
    ("ik/interval.rs", include_str!("ik/interval.rs")),
    ("ik/lanes.rs", include_str!("ik/lanes.rs")),
    ("ik/list.rs", include_str!("ik/list.rs")),
    ("ik/nearby.rs", include_str!("ik/nearby.rs")),
    ("ik/numerical.rs", include_str!("ik/numerical.rs")),
    ("ik/orient.rs", include_str!("ik/orient.rs")),
    ("ik/plane.rs", include_str!("ik/plane.rs")),
    ("ik/polish.rs", include_str!("ik/polish.rs")),
    ("ik/pose.rs", include_str!("ik/pose.rs")),
    ("ik/quartic.rs", include_str!("ik/quartic.rs")),
    ("ik/real.rs", include_str!("ik/real.rs")),
    ("ik/regional.rs", include_str!("ik/regional.rs")),
    ("ik/six.rs", include_str!("ik/six.rs")),
    ("ik/solution.rs", include_str!("ik/solution.rs")),
    ("ik/subproblem.rs", include_str!("ik/subproblem.rs")),
    ("ik/swivel.rs", include_str!("ik/swivel.rs")),
    ("ik/vector.rs", include_str!("ik/vector.rs")),
    ("runtime.rs", include_str!("runtime.rs")),
    ("runtime/block.rs", include_str!("runtime/block.rs")),
    ("runtime/pack.rs", include_str!("runtime/pack.rs")),
    ("runtime/scalar.rs", include_str!("runtime/scalar.rs")),
    ("runtime/sincos.rs", include_str!("runtime/sincos.rs")),
];
