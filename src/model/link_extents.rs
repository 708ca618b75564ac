//! Rough sizes and ranges of the links, known without any weighing.

/// Rough places of an arm's bodies, without any weighing.
pub trait LinkExtents {
    /// For each link, in its own frame: where its body ends that begins at the frame's origin, m.
    /// The next joint for the modified convention, the joint before for the standard one, the tool
    /// (or the origin) for the last link.
    fn ends(&self) -> Vec<[f64; 3]>;

    /// Of each moving joint: least and largest position, and largest speed. Missing entries of the
    /// file are half a turn, or half a metre, to both sides, and 1 rad/s or m/s.
    fn ranges(&self) -> Vec<[f64; 3]>;
}
