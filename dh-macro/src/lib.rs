//! `#[derive(DhRobot)]`: closed-form kinematics and dynamics of a robot from its DH table, at compile time.
//!
//! ```ignore
//! use dh_macro::DhRobot;
//!
//! #[derive(DhRobot)]
//! #[dh(file = "robots/kuka-lwr4.yaml")]
//! pub struct KukaLwr4;
//!
//! let w = kuka_lwr4::base_regressor(&q, &dq, &ddq);
//! ```
//!
//! Beside the struct stands a module with its name in snake case: the text that `denavit generate` writes as a crate. The path
//! is relative to the crate's `Cargo.toml`; the crate is rebuilt when the file changes.

use std::path::{Path, PathBuf};

use dh_codegen::robot::Robot;
use proc_macro::TokenStream;
use quote::{format_ident, quote};
use syn::{DeriveInput, LitStr, parse_macro_input};

/// Writes the module with the robot's functions, and `NAME` and `DOF` of the struct.
#[proc_macro_derive(DhRobot, attributes(dh))]
pub fn dh_robot(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    expand(&input).unwrap_or_else(|error| error.to_compile_error()).into()
}

fn expand(input: &DeriveInput) -> syn::Result<proc_macro2::TokenStream> {
    let file = file_of(input)?;
    let at_path = |message: String| syn::Error::new(file.span(), message);
    let root = std::env::var("CARGO_MANIFEST_DIR").map_err(|e| at_path(format!("CARGO_MANIFEST_DIR: {e}")))?;
    let path = Path::new(&root).join(file.value());
    let text = std::fs::read_to_string(&path).map_err(|e| at_path(format!("{}: {e}", path.display())))?;
    let mut read: Vec<PathBuf> = vec![path.clone()];
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let others = std::cell::RefCell::new(&mut read);
    let reading = Robot::from_yaml(&text, &|name| {
        let other = folder.join(name);
        let text = std::fs::read_to_string(&other).map_err(|e| format!("{}: {e}", other.display()));
        others.borrow_mut().push(other);
        text
    })
    .map_err(|problems| at_path(problems.to_string()))?;
    let body: proc_macro2::TokenStream =
        dh_codegen::module(&reading.robot, &text).parse().map_err(|e| at_path(format!("generated text: {e}")))?;

    let name = &input.ident;
    let module = format_ident!("{}", snake(&name.to_string()));
    let visibility = &input.vis;
    // Every file that was read is an input of the crate: cargo then notices edits.
    let tracked = read.iter().map(|p| p.display().to_string());
    Ok(quote! {
        #[allow(missing_docs, clippy::all)]
        #visibility mod #module { #body }
        const _: () = { #( let _ = include_bytes!(#tracked); )* };
        impl #name {
            /// Name of the robot.
            pub const NAME: &'static str = #module::NAME;
            /// Degrees of freedom.
            pub const DOF: usize = #module::DOF;
        }
    })
}

/// The literal in `#[dh(file = "...")]`.
fn file_of(input: &DeriveInput) -> syn::Result<LitStr> {
    let mut file = None;
    for attribute in input.attrs.iter().filter(|a| a.path().is_ident("dh")) {
        attribute.parse_nested_meta(|meta| {
            if !meta.path.is_ident("file") {
                return Err(meta.error("unknown key; write #[dh(file = \"robots/my-arm.yaml\")]"));
            }
            file = Some(meta.value()?.parse()?);
            Ok(())
        })?;
    }
    file.ok_or_else(|| syn::Error::new(input.ident.span(), "which robot? add #[dh(file = \"robots/my-arm.yaml\")]"))
}

/// `KukaLwr4` to `kuka_lwr4`.
fn snake(name: &str) -> String {
    let parts = name.char_indices().map(|(i, c)| match c.is_uppercase() && i > 0 {
        true => format!("_{}", c.to_lowercase()),
        false => c.to_lowercase().to_string(),
    });
    parts.collect()
}
