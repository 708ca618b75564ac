#![no_main]
//! libFuzzer on `targets::identified`, which `cargo test --test fuzz` feeds, too.

#[allow(dead_code)] // the other targets
#[path = "../../tests/fuzz/targets.rs"]
mod targets;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    targets::identified(bytes);
});
