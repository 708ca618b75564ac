//! The runtime's text, as it is compiled into this crate.

/// Path below `src/` of a generated crate, and text.
pub const FILES: &[(&str, &str)] = &[
    ("runtime.rs", include_str!("../runtime.rs")),
    ("runtime/pack.rs", include_str!("../runtime/pack.rs")),
    ("runtime/scalar.rs", include_str!("../runtime/scalar.rs")),
    ("runtime/sincos.rs", include_str!("../runtime/sincos.rs")),
];
