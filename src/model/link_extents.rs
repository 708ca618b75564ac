//! Approximate extents of the links and ranges of the joints, from geometry alone.

/// Approximate extents of an arm's bodies, from geometry alone.
pub trait LinkExtents {
    /// For each link, in its own frame: end of the body that begins at the frame's origin, m. This
    /// is the next joint for the modified convention, the previous joint for the standard one, the
    /// tool (or the origin) for the last link.
    fn ends(&self) -> Vec<[f64; 3]>;

    /// For each moving joint: least and largest position, and largest speed. Missing values of the
    /// file default to half a turn, or half a metre, to both sides, and to 1 rad/s or m/s.
    fn ranges(&self) -> Vec<[f64; 3]>;
}
