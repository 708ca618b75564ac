//! Rough sizes and ranges of the links, known without any weighing.

/// Where the bodies of an arm are, roughly: what is known of them without any weighing.
pub trait LinkExtents {
    /// For each link, in its own frame: where its body ends that begins at the frame's origin, m.
    /// The next joint for the modified convention, the joint before for the standard one, the tool
    /// (or the origin) for the last link.
    fn ends(&self) -> Vec<[f64; 3]>;

    /// Of each moving joint: least and largest position (half a turn, or half a metre, to both
    /// sides where the file has none), and largest speed (1 rad/s or m/s where the file has none).
    fn ranges(&self) -> Vec<[f64; 3]>;
}
