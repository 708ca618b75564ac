//! STUB until the runtime lands.
/// Eight.
#[derive(Clone, Copy)]
pub struct Pack(pub [f64; 8]);
