//! Plans against the numeric recursion, which shares no code with what made them.
