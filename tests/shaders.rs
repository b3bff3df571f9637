//! Every WGSL source is sound: parsed and validated by naga, libraries alone and passes with
//! stand-ins for the renderer.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use pangaea_shaders::globe::{LIBRARIES, PASSES, WgslSource};

/// Stand-ins for the modules of the renderer that passes import.
const RENDERER: &str = "
    struct View { world_position: vec3<f32>, viewport: vec4<f32>, }
    @group(0) @binding(0) var<uniform> view: View;
    @group(2) @binding(0) var<storage, read> transforms: array<mat4x4<f32>>;
    fn get_world_from_local(instance: u32) -> mat4x4<f32> { return transforms[instance]; }
    fn position_world_to_clip(p: vec3<f32>) -> vec4<f32> { return vec4(p, 1.0); }
";

/// Plain WGSL: without imports, and with the parts that `defined` asks for.
fn plain(source: &str, defined: &[&str]) -> String {
    let mut keep = vec![true];
    let mut lines = Vec::new();
    for line in source.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.first().copied() {
            Some("#import" | "#define_import_path") => {}
            Some("#ifdef") => keep.push(defined.contains(&words[1])),
            Some("#else") => {
                let on = keep.pop().expect("#else without #ifdef");
                keep.push(!on);
            }
            Some("#endif") => drop(keep.pop()),
            _ if keep.iter().all(|&on| on) => {
                lines.push(line.replace("#{MATERIAL_BIND_GROUP}", "3"))
            }
            _ => {}
        }
    }
    assert_eq!(keep, [true], "unbalanced #ifdef");
    lines.join("\n")
}

fn validate(name: &str, wgsl: &str) -> naga::Module {
    let module = naga::front::wgsl::parse_str(wgsl)
        .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(wgsl)));
    Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(wgsl)));
    module
}

#[test]
fn libraries_stand_alone() {
    for WgslSource { path, wgsl } in LIBRARIES {
        let import_path = path.trim_end_matches(".wgsl").replace('/', "::");
        assert!(
            wgsl.contains(&format!("#define_import_path {import_path}\n")),
            "{path}"
        );
        assert!(!wgsl.contains("#import"), "{path} imports");
        assert!(!validate(path, &plain(wgsl, &[])).functions.is_empty());
    }
}

#[test]
fn passes_are_sound_in_every_variant() {
    let libraries: String = LIBRARIES
        .iter()
        .map(|library| plain(library.wgsl, &[]))
        .collect();
    for WgslSource { path, wgsl } in PASSES {
        for defined in [&[][..], &["WIREFRAME"]] {
            let whole = format!("{RENDERER}{libraries}{}", plain(wgsl, defined));
            let module = validate(path, &whole);
            let stages: Vec<&str> = module
                .entry_points
                .iter()
                .map(|entry| entry.name.as_str())
                .collect();
            assert_eq!(stages, ["vertex", "fragment"], "{path}");
        }
    }
}

#[test]
fn passes_import_what_libraries_have() {
    for WgslSource { path, wgsl } in PASSES {
        for import in wgsl
            .lines()
            .filter_map(|line| line.strip_prefix("#import pangaea_shaders::"))
        {
            let (module, names) = import.rsplit_once("::").expect("an item is imported");
            let file = format!("pangaea_shaders/{}.wgsl", module.replace("::", "/"));
            let library = LIBRARIES
                .iter()
                .find(|library| library.path == file)
                .expect("a library");
            for name in names.trim_matches(['{', '}']).split(',').map(str::trim) {
                assert!(
                    library.wgsl.contains(&format!("fn {name}(")),
                    "{path}: {name} is not in {file}"
                );
            }
        }
    }
}
