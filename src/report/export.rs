//! Report of `denavit export`: entries that the format cannot express.

use core::fmt::Write;

use serde_json::{Value, json};

use crate::exchange::Exported;

/// The result as text.
pub fn export_text(name: &str, made: &Exported) -> String {
    let mut t = format!("{name}: written\n");
    if !made.left_out.is_empty() {
        t += "  not in the file:\n";
    }
    for sentence in &made.left_out {
        let _ = writeln!(t, "    {sentence}");
    }
    for sentence in &made.notes {
        let _ = writeln!(t, "  note: {sentence}");
    }
    t
}

/// The result as JSON.
pub fn export_json(name: &str, made: &Exported) -> Value {
    json!({ "name": name, "left_out": made.left_out, "notes": made.notes })
}
