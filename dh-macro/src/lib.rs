//! `#[derive(DhRobot)]`: the door to `dh-codegen`.
