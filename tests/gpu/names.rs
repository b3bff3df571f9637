//! Names and contents of the modules in WGSL.

use pangaea_shaders::amplify::twins::MODULES;
use pangaea_shaders::wgsl::{WgslModule, compose};
use pangaea_source::{files_below, workspace};
use pangaea_tests::gpu::parsed;
use syn::{ImplItem, Item, Type, Visibility};

/// Public functions of modules with twins that no shader calls.
const CPU_ONLY: [(&str, &str); 33] = [
    ("amplify/fixed", "q16"),
    ("amplify/fixed", "tan_deg"),
    ("amplify/fixed", "metres"),
    ("amplify/fixed", "million_years"),
    // They make uniforms.
    ("amplify/scale", "planet_scale_new"),
    ("amplify/scale", "planet_scale_words"),
    ("amplify/view", "view_whole"),
    ("amplify/view", "view_disc"),
    ("amplify/view", "view_square"),
    ("amplify/view", "view_words"),
    ("amplify/sight", "sight_new"),
    ("amplify/sight", "sight_words"),
    // They pick the faces of the control mesh, which is whole on a GPU.
    ("amplify/sight", "sight_reach"),
    ("amplify/sight", "horizon"),
    // They make vertices of level 0, and uniforms.
    ("amplify/vertex", "vertex_from_control"),
    ("amplify/rules/preset", "rules_words"),
    ("amplify/rules/ocean/mod", "swell"),
    ("amplify/rules/estuary", "mouth"),
    ("amplify/rules/estuary", "upstream"),
    // It answers for single directions.
    ("amplify/rules/meander", "wander_at"),
    ("amplify/uniform", "level_words"),
    ("amplify/columns", "column_named"),
    ("amplify/columns", "pass_named"),
    // They make views, and look at single faces.
    ("amplify/mark", "view_camera"),
    ("amplify/mark", "view_distance"),
    ("amplify/mark", "view_splits"),
    // Their passes do the same of a whole list.
    ("amplify/face_decide", "decide"),
    ("amplify/vertex_resolve/mod", "settled_write"),
    ("amplify/vertex_resolve/mod", "resolve"),
    // They draw.
    ("amplify/carve", "sheet"),
    ("amplify/emit", "refined_ground_triangles"),
    ("amplify/emit", "water"),
    ("amplify/emit", "is_resolved"),
];

/// The module without a twin: what Rust's own integers have.
const STANDARD: &str = "amplify/integer";

#[test]
fn every_module_is_valid_with_what_it_needs() {
    for module in MODULES {
        parsed(module.path, &compose(&MODULES, &[module.path]));
    }
}

#[test]
fn all_modules_together_are_valid() {
    let paths = MODULES.map(|module| module.path);
    let module = parsed("all", &compose(&MODULES, &paths));
    assert!(module.functions.len() > 50, "{}", module.functions.len());
}

#[test]
fn every_file_of_wgsl_is_a_module() {
    let mut found = files_below("shaders/src/amplify");
    found.retain(|path| path.ends_with(".wgsl"));
    let mut paths = MODULES.map(|module| format!("shaders/src/{}.wgsl", module.path));
    paths.sort();
    assert_eq!(found, paths);
}

#[test]
fn constants_come_from_rust_and_directives_from_nowhere() {
    for WgslModule { path, wgsl, .. } in MODULES {
        for line in wgsl.lines() {
            let first = line.split_whitespace().next().unwrap_or_default();
            let refused = first == "const" || first.starts_with('#');
            assert!(!refused, "{path}: {line}");
        }
    }
}

#[test]
fn every_public_function_has_its_twin() {
    for module in MODULES.into_iter().filter(|m| m.path != STANDARD) {
        let mut missing = functions(module.path);
        missing.retain(|name| !has_function(&module, name));
        let listed = CPU_ONLY.iter().filter(|(path, _)| *path == module.path);
        let listed: Vec<&str> = listed.map(|(_, name)| *name).collect();
        assert_eq!(missing, listed, "{} has no twins of", module.path);
    }
}

/// Whether it has a function of a name, or of the name after that of the module or of its folder.
fn has_function(module: &WgslModule, name: &str) -> bool {
    let has = |name: &str| module.wgsl.contains(&format!("fn {name}("));
    let mut around = module.path.rsplit('/').take(2);
    has(name) || around.any(|place| has(&format!("{place}_{name}")))
}

/// The public functions of a Rust module, by the names of their twins.
fn functions(path: &str) -> Vec<String> {
    let text = std::fs::read_to_string(workspace().join(format!("shaders/src/{path}.rs")));
    let file = syn::parse_file(&text.expect("a Rust module")).expect("Rust");
    file.items.iter().flat_map(public_functions).collect()
}

fn public_functions(item: &Item) -> Vec<String> {
    match item {
        Item::Fn(function) if is_public(&function.vis) => vec![function.sig.ident.to_string()],
        Item::Impl(block) if block.trait_.is_none() => {
            let Type::Path(of) = &*block.self_ty else {
                return Vec::new();
            };
            let of = of.path.segments.last().expect("a name").ident.to_string();
            let methods = block.items.iter().filter_map(public_method);
            methods
                .map(|name| format!("{}_{name}", snake(&of)))
                .collect()
        }
        _ => Vec::new(),
    }
}

fn public_method(item: &ImplItem) -> Option<String> {
    match item {
        ImplItem::Fn(method) if is_public(&method.vis) => Some(method.sig.ident.to_string()),
        _ => None,
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// `StripeNoise` -> `stripe_noise`.
fn snake(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars() {
        if c.is_uppercase() && !out.is_empty() {
            out.push('_');
        }
        out.extend(c.to_lowercase());
    }
    out
}
