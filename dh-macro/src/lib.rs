//! `#[derive(DhRobot)]`: closed-form kinematics and dynamics of a robot from its DH table, at
//! compile time.
//!
//! ```
//! use dh_macro::DhRobot;
//!
//! /// Two links in a plane.
//! #[derive(DhRobot)]
//! #[dh(file = "../robots/planar2r.yaml")]
//! pub struct Planar2r;
//!
//! fn main() {
//!     let pose = planar2r::forward_kinematics(&[0.3, 0.4]);
//!     assert!((pose[0][0] - 0.7_f64.cos()).abs() < 1e-12);
//! }
//! ```
//!
//! A module with the struct's name in snake case is generated beside it, with the text that
//! `denavit generate` writes as a crate. The struct implements the traits of that module's `robot`.
//! The path is relative to the crate's `Cargo.toml`; the crate is rebuilt when the file changes.
//!
//! The derive macro of this crate includes its runtime. That of `denavit-runtime` (feature
//! `derive`) uses the runtime from there, so that all robots share their types and traits.

// The struct of the example must be outside `main`.
#![allow(clippy::needless_doctest_main)]

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use dh_codegen::Runtime;
use dh_codegen::robot::Robot;
use proc_macro::TokenStream;
use quote::quote;
use syn::ext::IdentExt;
use syn::{DeriveInput, Error, Ident, LitStr, parse_macro_input};

/// Generates the module with the robot's functions, `NAME` and `DOF` of the struct, and its traits.
#[proc_macro_derive(DhRobot, attributes(dh))]
pub fn dh_robot(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    expand(&input, &Runtime::Shipped).unwrap_or_else(|error| error.to_compile_error()).into()
}

/// Variant for the crate `denavit-runtime`, which re-exports it as `DhRobot`.
#[doc(hidden)]
#[proc_macro_derive(DhRobotOnRuntime, attributes(dh))]
pub fn dh_robot_on_runtime(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    let runtime = Runtime::Crate(String::new());
    expand(&input, &runtime).unwrap_or_else(|error| error.to_compile_error()).into()
}

fn expand(input: &DeriveInput, runtime: &Runtime) -> syn::Result<proc_macro2::TokenStream> {
    let file = file_of(input)?;
    let at_path = |message: String| Error::new(file.span(), message);
    let root = std::env::var("CARGO_MANIFEST_DIR").map_err(|e| at_path(format!("CARGO_MANIFEST_DIR: {e}")))?;
    let path = Path::new(&root).join(file.value());
    // Every file that is read is recorded as an input of the crate, so that cargo detects edits.
    let inputs = RefCell::new(Vec::<String>::new());
    let read = |path: PathBuf, shown: &str| {
        inputs.borrow_mut().push(path.display().to_string());
        std::fs::read_to_string(&path).map_err(|e| std::io::Error::new(e.kind(), format!("{shown}: {e}")))
    };
    let text = read(path.clone(), &file.value())
        .map_err(|e| at_path(format!("{e}; the path starts at the folder of the crate's Cargo.toml")))?;
    let reading = Robot::from_yaml(&text, &|other| read(path.with_file_name(other), other))
        .map_err(|problems| at_path(problems.in_file(&file.value()).to_string()))?;
    let code = dh_codegen::module_on(&reading.robot, &text, runtime);
    let tokens = |text: &str| -> syn::Result<proc_macro2::TokenStream> {
        text.parse().map_err(|e| at_path(format!("generated text: {e}")))
    };
    let body = tokens(&code.body)?;
    let (name, visibility, inputs) = (&input.ident, &input.vis, inputs.into_inner());
    let module = snake(&name.unraw().to_string());
    // A struct named `Loop` needs the raw form of its module's name.
    let module = syn::parse_str(&module).unwrap_or_else(|_| Ident::new_raw(&module, name.span()));
    let traits = tokens(&code.implementations(&name.to_string(), "__robot"))?;
    Ok(quote! {
        #[allow(missing_docs, clippy::all)]
        #visibility mod #module { #body }
        const _: () = { #( let _ = include_bytes!(#inputs); )* };
        const _: () = {
            use #module as __robot;
            #traits
        };
        impl #name {
            /// Name of the robot.
            pub const NAME: &'static str = #module::NAME;
            /// Degrees of freedom.
            pub const DOF: usize = #module::DOF;
        }
    })
}

/// Literal of `#[dh(file = "...")]`.
fn file_of(input: &DeriveInput) -> syn::Result<LitStr> {
    let mut file = None;
    for attribute in input.attrs.iter().filter(|a| a.path().is_ident("dh")) {
        attribute.parse_nested_meta(|meta| match meta.path.is_ident("file") {
            true => meta.value()?.parse().map(|path| file = Some(path)),
            false => Err(meta.error("unknown key; write #[dh(file = \"robots/my-arm.yaml\")]")),
        })?;
    }
    file.ok_or_else(|| Error::new(input.ident.span(), "which robot? add #[dh(file = \"robots/my-arm.yaml\")]"))
}

/// Converts `KukaLwr4` to `kuka_lwr4`.
fn snake(name: &str) -> String {
    let word = |(i, c): (usize, char)| if i > 0 && c.is_uppercase() { format!("_{c}") } else { c.to_string() };
    name.char_indices().map(word).collect::<String>().to_lowercase()
}
