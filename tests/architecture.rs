//! Checks the structure described in ARCHITECTURE.md: order of domains, serialisation, length of
//! functions, unique names, paths in documents.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use dh_codegen::robot::EffectKind;
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// Domains of `src`; each may use those before it.
const DOMAINS: [&str; 12] = [
    "numerics", "model", "exchange", "data", "identify", "simulate", "excite", "control", "diagnose", "apps", "report",
    "cli",
];

/// Modules of `dh-macro/codegen/src`; each may use those before it.
const CODEGEN: [&str; 10] =
    ["runtime", "elementary", "drive", "ik", "robot", "sym", "arm", "interpret", "pullback", "rust"];
// The first four are `denavit-runtime-core`, under the names by which `dh-codegen` re-exports them.

/// Longest permitted function, lines.
const LONGEST: usize = 60;

/// Functions longer than [`LONGEST`]: file, name, lines. When one is shortened, its line must be
/// updated or removed.
const LONG_FUNCTIONS: &str = include_str!("architecture/long_functions.txt");

/// Public types of one domain that share a name: domain and name. The list may only shrink.
const SHARED_NAMES: &str = include_str!("architecture/shared_names.txt");

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Files with this ending below a folder, sorted, relative to the root.
fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    fn walk(folder: &Path, ending: &str, into: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                if !path.ends_with("target") && !path.ends_with(".git") {
                    walk(&path, ending, into);
                }
            } else if path.extension().is_some_and(|e| e == ending) {
                into.push(path.strip_prefix(root()).unwrap().to_path_buf());
            }
        }
    }
    let mut found = Vec::new();
    walk(&root().join(folder), ending, &mut found);
    found.sort();
    found
}

/// Whether an item is compiled for tests only.
fn for_tests(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|a| {
        a.path().is_ident("test") || a.path().is_ident("cfg") && a.to_token_stream().to_string().contains("test")
    })
}

fn attributes(item: &syn::Item) -> &[syn::Attribute] {
    match item {
        syn::Item::Fn(x) => &x.attrs,
        syn::Item::Mod(x) => &x.attrs,
        syn::Item::Use(x) => &x.attrs,
        syn::Item::Impl(x) => &x.attrs,
        syn::Item::Struct(x) => &x.attrs,
        syn::Item::Enum(x) => &x.attrs,
        syn::Item::Const(x) => &x.attrs,
        syn::Item::Static(x) => &x.attrs,
        syn::Item::Trait(x) => &x.attrs,
        syn::Item::Type(x) => &x.attrs,
        _ => &[],
    }
}

/// Source files of a folder, without items that only tests compile.
fn sources(folder: &str) -> Vec<(PathBuf, syn::File)> {
    let test_file = |p: &Path| {
        p.components().any(|c| c.as_os_str() == "tests") || {
            let stem = p.file_stem().unwrap().to_string_lossy();
            stem == "tests" || stem.ends_with("_tests")
        }
    };
    let parse = |path: PathBuf| {
        let text = fs::read_to_string(root().join(&path)).unwrap();
        let mut file = syn::parse_file(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        file.items.retain(|item| !for_tests(attributes(item)));
        (path, file)
    };
    let only_tests: BTreeSet<PathBuf> = files(folder, "rs").iter().flat_map(|p| test_modules(p)).collect();
    files(folder, "rs").into_iter().filter(|p| !test_file(p) && !only_tests.contains(p)).map(parse).collect()
}

/// Files of the modules that a file declares for tests only.
fn test_modules(path: &Path) -> Vec<PathBuf> {
    let file = syn::parse_file(&fs::read_to_string(root().join(path)).unwrap()).unwrap();
    let declared = file.items.iter().filter(|item| for_tests(attributes(item))).filter_map(|item| match item {
        syn::Item::Mod(module) if module.content.is_none() => Some(module.ident.to_string()),
        _ => None,
    });
    declared.map(|name| path.with_extension("").join(name).with_extension("rs")).collect()
}

/// First segments of all paths `crate::x`, also in groups and in macro arguments.
fn crate_paths(tokens: TokenStream, into: &mut BTreeSet<String>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let is = |k: usize, c: char| matches!(trees.get(k), Some(TokenTree::Punct(p)) if p.as_char() == c);
    for (k, tree) in trees.iter().enumerate() {
        match tree {
            TokenTree::Group(group) => crate_paths(group.stream(), into),
            TokenTree::Ident(word) if *word == "crate" && is(k + 1, ':') && is(k + 2, ':') => match trees.get(k + 3) {
                Some(TokenTree::Ident(first)) => drop(into.insert(first.to_string())),
                Some(TokenTree::Group(group)) => {
                    let mut start = true;
                    for tree in group.stream() {
                        match tree {
                            TokenTree::Ident(first) if start => drop(into.insert(first.to_string())),
                            TokenTree::Punct(p) if p.as_char() == ',' => start = true,
                            _ => start = false,
                        }
                    }
                }
                _ => {}
            },
            _ => {}
        }
    }
}

/// First folder or file below `folder` in a path.
fn domain(path: &Path, folder: &str) -> String {
    let below = path.strip_prefix(folder).unwrap();
    let first = below.components().next().unwrap().as_os_str().to_string_lossy().into_owned();
    first.trim_end_matches(".rs").to_string()
}

fn order_holds(folder: &str, order: &[&str]) {
    let mut wrong = Vec::new();
    for (path, file) in sources(folder) {
        let own = domain(&path, folder);
        if own == "lib" || own == "main" {
            continue;
        }
        let place = order.iter().position(|d| *d == own);
        let place = place.unwrap_or_else(|| panic!("{}: {own} is no domain of {folder}", path.display()));
        let mut used = BTreeSet::new();
        crate_paths(file.into_token_stream(), &mut used);
        for other in used {
            if order.iter().position(|d| *d == other).is_some_and(|at| at > place) {
                wrong.push(format!("{}: {own} uses {other}", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "a domain uses one that comes later:\n{}", wrong.join("\n"));
}

#[test]
fn domains_use_only_those_before_them() {
    order_holds("src", &DOMAINS);
}

#[test]
fn codegen_modules_use_only_those_before_them() {
    order_holds("dh-macro/codegen/src", &CODEGEN);
}

/// All identifiers, also in macros.
fn identifiers(tokens: TokenStream, into: &mut BTreeSet<String>) {
    for tree in tokens {
        match tree {
            TokenTree::Ident(word) => drop(into.insert(word.to_string())),
            TokenTree::Group(group) => identifiers(group.stream(), into),
            _ => {}
        }
    }
}

/// Checks identifiers that may only be used in certain domains.
#[test]
fn only_report_serialises_and_only_cli_touches_disk_and_terminal() {
    let rules: [(&[&str], &[&str]); 2] = [
        (&["serde_json", "serde_saphyr", "saphyr_parser"], &["report", "cli"]),
        (&["println", "eprintln", "print", "eprint", "fs", "stdout", "stderr", "clap", "indicatif"], &["cli", "main"]),
    ];
    let mut wrong = Vec::new();
    for (path, file) in sources("src") {
        let own = domain(&path, "src");
        let mut words = BTreeSet::new();
        let macros = |name: &str| ["println", "eprintln", "print", "eprint"].contains(&name);
        let text = file.to_token_stream();
        identifiers(text.clone(), &mut words);
        let text = text.to_string();
        for (forbidden, allowed) in rules {
            for word in forbidden.iter().filter(|w| words.contains(**w) && !allowed.contains(&own.as_str())) {
                if !macros(word) || text.contains(&format!("{word} !")) {
                    wrong.push(format!("{}: {word}", path.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "in the wrong domain:\n{}", wrong.join("\n"));
}

/// String literals, also in macro arguments, without documentation.
fn literals(tokens: TokenStream, into: &mut Vec<String>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    for (k, tree) in trees.iter().enumerate() {
        match tree {
            TokenTree::Group(group) => {
                let attribute =
                    k > 0 && matches!(&trees[k - 1], TokenTree::Punct(p) if p.as_char() == '#' || p.as_char() == '!');
                let mut inner = group.stream().into_iter();
                let documents = matches!(inner.next(), Some(TokenTree::Ident(word)) if word == "doc");
                if !(attribute && documents) {
                    literals(group.stream(), into);
                }
            }
            TokenTree::Literal(literal) => {
                into.extend(syn::parse_str::<syn::LitStr>(&literal.to_string()).map(|text| text.value()));
            }
            _ => {}
        }
    }
}

/// An effect is a type: its name is written only in its own file, and elsewhere in examples for the
/// reader.
#[test]
fn an_effect_is_named_in_its_own_file_alone() {
    let examples = ["src/cli/simulate.rs", "src/report/reproduce/painting.rs"];
    let mut wrong = Vec::new();
    for (path, file) in ["src", "dh-macro/codegen/src"].iter().flat_map(|folder| sources(folder)) {
        let mut texts = Vec::new();
        literals(file.into_token_stream(), &mut texts);
        for name in EffectKind::ALL.iter().map(|kind| kind.name()) {
            let own = path == Path::new("dh-macro/codegen/src/robot/effects").join(name).with_extension("rs");
            // `payload` and `backlash` are ordinary English words too.
            let words = |text: &str| {
                name.contains('_') && text.split(|c: char| !(c.is_alphanumeric() || c == '_')).any(|w| w == name)
            };
            let prose =
                path.starts_with("dh-macro/codegen/src/robot/effects") || examples.iter().any(|e| path == Path::new(e));
            if !own && texts.iter().any(|text| text == name || (!prose && words(text))) {
                wrong.push(format!("{}: {name}", path.display()));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "write the type (`EffectKind::..`, `..::NAME`) in place of the name:\n{}",
        wrong.join("\n")
    );
}

/// A key of an effect is a constant of its type (`effects::JointSpring::KS`), so that a misspelt
/// one does not compile. Keys in small letters are ordinary words too, and those of bodies, rotor
/// and plain friction are the names of standard parameters.
#[test]
fn a_key_of_an_effect_is_written_in_its_own_file_alone() {
    let apart = [EffectKind::LinkInertiaError, EffectKind::Payload];
    let kinds = EffectKind::ALL.iter().filter(|kind| !kind.is_plain() && !apart.contains(kind));
    let keys: BTreeSet<&str> = kinds
        .flat_map(|kind| kind.description().keys)
        .map(|key| key.name)
        .filter(|name| name.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit()))
        .collect();
    let mut wrong = Vec::new();
    for (path, file) in ["src", "dh-macro/codegen/src"].iter().flat_map(|folder| sources(folder)) {
        if path.starts_with("dh-macro/codegen/src/robot/effects") {
            continue;
        }
        let mut texts = Vec::new();
        literals(file.into_token_stream(), &mut texts);
        wrong.extend(texts.iter().filter(|t| keys.contains(t.as_str())).map(|t| format!("{}: {t}", path.display())));
    }
    assert!(wrong.is_empty(), "write the constant (`effects::..::KEY`) in place of the text:\n{}", wrong.join("\n"));
}

/// Functions with their number of lines, closures inside included.
struct Functions<'a> {
    file: &'a str,
    found: Vec<(String, usize)>,
}

impl Functions<'_> {
    fn add(&mut self, name: &syn::Ident, block: &syn::Block) {
        let lines = block.span().end().line - name.span().start().line + 1;
        self.found.push((format!("{} {name}", self.file), lines));
    }
}

impl<'ast> Visit<'ast> for Functions<'_> {
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.add(&item.sig.ident, &item.block);
        visit::visit_item_fn(self, item);
    }
    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.add(&item.sig.ident, &item.block);
        visit::visit_impl_item_fn(self, item);
    }
    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        if let Some(block) = &item.default {
            self.add(&item.sig.ident, block);
        }
    }
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !for_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }
}

/// Checks a list that may only shrink: entries that are no longer true must be removed.
fn only_shrinks(list: &str, listed: &BTreeMap<String, usize>, found: &BTreeMap<String, usize>) {
    let more: Vec<String> = found
        .iter()
        .filter(|(what, size)| listed.get(*what).is_none_or(|allowed| *size > allowed))
        .map(|(what, size)| format!("{what} {size}"))
        .collect();
    assert!(more.is_empty(), "not in {list}, or larger than there; take them apart:\n{}", more.join("\n"));
    let gone: Vec<String> = listed
        .iter()
        .filter(|(what, allowed)| found.get(*what).is_none_or(|size| size < allowed))
        .map(|(what, allowed)| format!("{what} {allowed} -> {:?}", found.get(what)))
        .collect();
    assert!(gone.is_empty(), "better than {list} says; shorten the list:\n{}", gone.join("\n"));
}

fn table(text: &str) -> BTreeMap<String, usize> {
    let row = |line: &str| {
        let (what, size) = line.rsplit_once(' ')?;
        Some((what.to_string(), size.parse().ok()?))
    };
    text.lines().filter_map(row).collect()
}

#[test]
fn functions_are_short() {
    let mut found = BTreeMap::new();
    for folder in ["src", "dh-macro/runtime-core/src", "dh-macro/codegen/src", "dh-macro/src", "fleet/src"] {
        for (path, file) in sources(folder) {
            let mut functions = Functions { file: &path.display().to_string(), found: Vec::new() };
            functions.visit_file(&file);
            for (name, lines) in functions.found.into_iter().filter(|(_, lines)| *lines > LONGEST) {
                let longest: &mut usize = found.entry(name).or_insert(0);
                *longest = lines.max(*longest);
            }
        }
    }
    only_shrinks("tests/architecture/long_functions.txt", &table(LONG_FUNCTIONS), &found);
}

/// Whether the error type of this function is a string.
fn text_error(signature: &syn::Signature) -> bool {
    let output = signature.output.to_token_stream().to_string();
    let text = [", String >", ", & 'static str >", ", & str >", ", Box < dyn"];
    output.contains("Result <") && text.iter().any(|end| output.contains(end))
}

/// Public functions with a string as the error.
struct TextErrors<'a> {
    file: &'a str,
    found: Vec<String>,
}

impl TextErrors<'_> {
    fn add(&mut self, visibility: &syn::Visibility, signature: &syn::Signature) {
        if matches!(visibility, syn::Visibility::Public(_)) && text_error(signature) {
            self.found.push(format!("{} {}", self.file, signature.ident));
        }
    }
}

impl<'ast> Visit<'ast> for TextErrors<'_> {
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.add(&item.vis, &item.sig);
    }
    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.add(&item.vis, &item.sig);
    }
    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        for member in &item.items {
            if let syn::TraitItem::Fn(function) = member {
                self.add(&item.vis, &function.sig);
            }
        }
    }
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !for_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }
}

#[test]
fn public_functions_have_errors_of_a_type() {
    let mut found = Vec::new();
    let folders = ["src", "dh-macro/codegen/src", "dh-macro/runtime-core/src", "dh-macro/runtime/src"];
    for (path, file) in folders.iter().flat_map(|folder| sources(folder)) {
        let mut functions = TextErrors { file: &path.display().to_string(), found: Vec::new() };
        functions.visit_file(&file);
        found.extend(functions.found);
    }
    assert!(found.is_empty(), "give these an error enum in place of a text:\n{}", found.join("\n"));
}

/// `Result` types with a string as the error, wherever they are written.
#[derive(Default)]
struct TextResults(Vec<String>);

impl<'ast> Visit<'ast> for TextResults {
    fn visit_path_segment(&mut self, segment: &'ast syn::PathSegment) {
        if let ("Result", syn::PathArguments::AngleBracketed(types)) = (&*segment.ident.to_string(), &segment.arguments)
        {
            let error = types.args.iter().nth(1).map(|e| e.to_token_stream().to_string());
            if error.is_some_and(|e| ["String", "& 'static str", "& str"].contains(&e.as_str())) {
                self.0.push(segment.to_token_stream().to_string());
            }
        }
        visit::visit_path_segment(self, segment);
    }
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !for_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }
}

/// Covers private functions, closures and aliases, too. In `cli` strings go to the terminal, and
/// `clap` expects them.
#[test]
fn no_error_is_a_text_outside_the_command() {
    let mut wrong = Vec::new();
    let folders = ["src", "dh-macro/codegen/src", "dh-macro/runtime-core/src", "dh-macro/runtime/src", "dh-macro/src"];
    for (path, file) in folders.iter().flat_map(|folder| sources(folder)) {
        if !path.starts_with("src/cli") {
            let mut results = TextResults::default();
            results.visit_file(&file);
            wrong.extend(results.0.into_iter().map(|what| format!("{}: {what}", path.display())));
        }
    }
    assert!(wrong.is_empty(), "give these an enum in place of a text:\n{}", wrong.join("\n"));
}

/// Places that derive a parameter's kind from its name.
#[derive(Default)]
struct ParsedNames {
    found: Vec<String>,
}

impl<'ast> Visit<'ast> for ParsedNames {
    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        let cuts = ["starts_with", "strip_prefix", "strip_suffix", "trim_end_matches", "trim_start_matches"];
        let symbols = ["IA", "FV", "FC", "FO", "IAM", "FVM", "FCM", "M", "MS", "XX", "YY", "ZZ", "F", "R"];
        let argument = call.args.first().map(|a| a.to_token_stream().to_string()).unwrap_or_default();
        let symbol = symbols.iter().any(|s| argument == format!("\"{s}\"") || argument == format!("'{s}'"));
        if symbol && cuts.contains(&call.method.to_string().as_str()) {
            self.found.push(call.to_token_stream().to_string());
        }
        visit::visit_expr_method_call(self, call);
    }
    fn visit_expr_array(&mut self, array: &'ast syn::ExprArray) {
        let terms = ["\"IA\"", "\"FV\"", "\"FC\"", "\"FO\"", "\"MSX\""];
        let named = array.elems.iter().filter(|e| terms.contains(&e.to_token_stream().to_string().as_str())).count();
        let others = array
            .elems
            .iter()
            .any(|e| matches!(e, syn::Expr::Lit(l) if matches!(&l.lit, syn::Lit::Str(s) if s.value() == "TO")));
        if named > 1 && !others {
            self.found.push(array.to_token_stream().to_string());
        }
        visit::visit_expr_array(self, array);
    }
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !for_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }
}

/// Only `StandardParameter` and `arm::param` define what a parameter is.
#[test]
fn no_name_of_a_parameter_is_parsed_back() {
    let mut wrong = Vec::new();
    for (path, file) in ["src", "dh-macro/codegen/src"].iter().flat_map(|folder| sources(folder)) {
        let mut names = ParsedNames::default();
        names.visit_file(&file);
        wrong.extend(names.found.into_iter().map(|what| format!("{}: {what}", path.display())));
    }
    assert!(wrong.is_empty(), "match on `StandardParameter` in place of the name:\n{}", wrong.join("\n"));
}

/// Identifiers with their number of occurrences, including captures in format strings.
fn count_words(tokens: TokenStream, into: &mut BTreeMap<String, usize>) {
    for tree in tokens {
        match tree {
            TokenTree::Ident(word) => *into.entry(word.to_string()).or_default() += 1,
            TokenTree::Group(group) => count_words(group.stream(), into),
            TokenTree::Literal(text) => {
                let text = text.to_string();
                for captured in text.split('{').skip(1).filter_map(|rest| rest.split(['}', ':']).next()) {
                    *into.entry(captured.to_string()).or_default() += 1;
                }
            }
            TokenTree::Punct(_) => {}
        }
    }
}

/// Names of public functions, types and constants.
#[derive(Default)]
struct PublicNames(Vec<String>);

impl<'ast> Visit<'ast> for PublicNames {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        let (visibility, name) = match item {
            syn::Item::Fn(x) => (&x.vis, &x.sig.ident),
            syn::Item::Struct(x) => (&x.vis, &x.ident),
            syn::Item::Enum(x) => (&x.vis, &x.ident),
            syn::Item::Trait(x) => (&x.vis, &x.ident),
            syn::Item::Const(x) => (&x.vis, &x.ident),
            _ => return visit::visit_item(self, item),
        };
        if matches!(visibility, syn::Visibility::Public(_)) && !for_tests(attributes(item)) {
            self.0.push(name.to_string());
        }
        visit::visit_item(self, item);
    }
    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if matches!(item.vis, syn::Visibility::Public(_)) && !for_tests(&item.attrs) {
            self.0.push(item.sig.ident.to_string());
        }
    }
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !for_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }
}

/// Does not count uses in tests only. The rigid-body recursions are the tests' oracle, and public
/// for that purpose.
#[test]
fn public_items_are_used() {
    let mut words = BTreeMap::new();
    let mut defined: Vec<(PathBuf, String)> = Vec::new();
    for folder in ["src", "examples", "benches", "fleet/src"] {
        for (path, mut file) in sources(folder) {
            file.items.retain(|item| !matches!(item, syn::Item::Use(_)));
            count_words(file.to_token_stream(), &mut words);
            if folder == "src" && !path.starts_with("src/model/rigid_body") {
                let mut names = PublicNames::default();
                names.visit_file(&file);
                defined.extend(names.0.into_iter().map(|name| (path.clone(), name)));
            }
        }
    }
    let definitions = |name: &String| defined.iter().filter(|(_, other)| other == name).count();
    let unused = defined.iter().filter(|(_, name)| words.get(name).is_none_or(|n| *n <= definitions(name)));
    let unused: Vec<String> = unused.map(|(path, name)| format!("{}: {name}", path.display())).collect();
    assert!(unused.is_empty(), "no one uses these but tests; take them out:\n{}", unused.join("\n"));
}

#[test]
fn public_types_of_a_domain_have_names_of_their_own() {
    let mut count: BTreeMap<String, usize> = BTreeMap::new();
    for (path, file) in sources("src") {
        let own = domain(&path, "src");
        for item in &file.items {
            let (visibility, name) = match item {
                syn::Item::Struct(x) => (&x.vis, &x.ident),
                syn::Item::Enum(x) => (&x.vis, &x.ident),
                syn::Item::Trait(x) => (&x.vis, &x.ident),
                _ => continue,
            };
            if matches!(visibility, syn::Visibility::Public(_)) {
                *count.entry(format!("{own} {name}")).or_default() += 1;
            }
        }
    }
    count.retain(|_, n| *n > 1);
    only_shrinks("tests/architecture/shared_names.txt", &table(SHARED_NAMES), &count);
}

/// Words in backticks and targets of links that look like files of the repository.
fn named_paths(text: &str) -> BTreeSet<String> {
    let endings = [".rs", ".md", ".yaml", ".py", ".sh", ".png", ".json", ".csv.gz", ".toml"];
    let ticks = text.split('`').skip(1).step_by(2);
    let links = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    ticks
        .filter(|w| !w.contains(|c: char| c.is_whitespace() || "*<>{}$()|,".contains(c)))
        .filter(|w| w.contains('/') && (endings.iter().any(|e| w.ends_with(e)) || w.ends_with('/')))
        .chain(links.filter(|w| !w.contains("://") && !w.starts_with('#')))
        .map(|w| w.split('#').next().unwrap().to_string())
        .collect()
}

/// Files with `unsafe`: path, number of occurrences, and reason.
const UNSAFE: &str = include_str!("architecture/unsafe.txt");

#[test]
fn unsafe_stands_where_it_is_listed() {
    let mut found = BTreeMap::new();
    for folder in ["src", "dh-macro", "tests", "benches", "examples", "fuzz", "fleet"] {
        for path in files(folder, "rs") {
            let text = fs::read_to_string(root().join(&path)).unwrap();
            let Ok(tokens) = text.parse::<TokenStream>() else { continue };
            let mut words = BTreeMap::new();
            count_words(tokens, &mut words);
            if let Some(count) = words.get("unsafe") {
                found.insert(path.display().to_string(), *count);
            }
        }
    }
    let listed = UNSAFE.lines().map(|line| {
        let mut cells = line.splitn(3, ' ');
        let mut next = || cells.next().unwrap_or_default().to_string();
        let (path, count, reason) = (next(), next(), next());
        assert!(!reason.is_empty(), "{path}: say why");
        (path, count.parse().unwrap())
    });
    assert_eq!(found, listed.collect(), "found, and listed in tests/architecture/unsafe.txt");
}

#[test]
fn paths_in_documents_exist() {
    let documents =
        ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "SECURITY.md", "robots/README.md", "data/README.md"];
    let documents = documents.iter().map(PathBuf::from).chain(files("docs", "md"));
    let mut missing = Vec::new();
    for document in documents {
        let text = fs::read_to_string(root().join(&document)).unwrap();
        let beside = document.parent().unwrap();
        for path in named_paths(&text) {
            let folders = ["", "src", "dh-macro", "dh-macro/codegen/src", "dh-macro/runtime-core/src"];
            let mut places = folders.map(|f| Path::new(f).join(&path)).to_vec();
            places.push(beside.join(&path));
            let known = places.iter().any(|p| root().join(p).exists());
            // Files kept beside a checkout, and outputs of the commands in the text.
            if !known && !path.starts_with("..") && !path.starts_with('/') {
                missing.push(format!("{}: {path}", document.display()));
            }
        }
    }
    assert!(missing.is_empty(), "documents name paths that are not there:\n{}", missing.join("\n"));
}
