//! Modules of WGSL that compute passes are put together from.
//!
//! A module `x.wgsl` stands beside the Rust module `x.rs` whose twin it is. It is plain WGSL,
//! without preprocessor directives and imports: a shader is the texts of the modules that it needs,
//! one after the other, so it parses with naga alone and is known to no dialect. A constant is
//! written once, in Rust; `shared!` lists those of a module that its twin has, and [`compose`] puts
//! them before the twin's text.

/// A module of WGSL.
#[derive(Clone, Copy, Debug)]
pub struct WgslModule {
    /// Path below `src`, without its ending: that of the Rust module beside it.
    pub path: &'static str,
    /// The text.
    pub wgsl: &'static str,
    /// Paths of the modules whose functions, types and constants it uses itself.
    pub needs: &'static [&'static str],
    /// Declares the constants that the Rust module shares with it.
    pub constants: fn() -> String,
}

/// The constants of a Rust module that its twin shares: `shared!(ONE, Q16)`. Another name or a
/// value of another type is written out: `shared!(LEAF = SplitMark::Leaf as u32)`.
macro_rules! shared {
    ($($name:ident $(= $value:expr)?),* $(,)?) => {
        /// The constants that the WGSL twin shares, in its language.
        pub(crate) fn shared_constants() -> String {
            [$(crate::wgsl::shared!(@declare $name $(= $value)?)),*].concat()
        }
    };
    (@declare $name:ident) => {
        crate::wgsl::declaration(stringify!($name), $name)
    };
    (@declare $name:ident = $value:expr) => {
        crate::wgsl::declaration(stringify!($name), $value)
    };
}

pub(crate) use shared;

/// A type of Rust that WGSL has, too.
pub(crate) trait WgslValue {
    /// Name of the type.
    fn type_name() -> String;

    /// The value as an expression.
    fn expression(&self) -> String;
}

impl WgslValue for i32 {
    fn type_name() -> String {
        "i32".into()
    }

    fn expression(&self) -> String {
        self.to_string()
    }
}

impl WgslValue for u32 {
    fn type_name() -> String {
        "u32".into()
    }

    fn expression(&self) -> String {
        format!("{self}u")
    }
}

impl<T: WgslValue, const N: usize> WgslValue for [T; N] {
    fn type_name() -> String {
        format!("array<{}, {N}>", T::type_name())
    }

    fn expression(&self) -> String {
        let items: Vec<String> = self.iter().map(T::expression).collect();
        format!("{}({})", Self::type_name(), items.join(", "))
    }
}

/// A line of WGSL that declares a constant.
pub(crate) fn declaration<T: WgslValue>(name: &str, value: T) -> String {
    format!(
        "const {name}: {} = {};\n",
        T::type_name(),
        value.expression()
    )
}

/// A shader put together of modules.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ComposedWgsl {
    /// The whole text.
    pub wgsl: String,
    parts: Vec<WgslPart>,
}

/// Where a module stands in a composed text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct WgslPart {
    path: &'static str,
    /// Lines before its constants.
    constants: usize,
    /// Lines before its text.
    text: usize,
}

impl ComposedWgsl {
    /// The module that a line of the whole text comes from, and the line there, both counted from
    /// 1: 0 for a constant that Rust gives. For messages of compilers.
    pub fn place(&self, line: usize) -> Option<(&'static str, usize)> {
        let after = self.parts.partition_point(|part| part.constants < line);
        let part = self.parts.get(after.checked_sub(1)?)?;
        Some((part.path, line.saturating_sub(part.text)))
    }

    fn add(&mut self, module: &WgslModule) {
        let constants = self.wgsl.lines().count();
        self.wgsl += &(module.constants)();
        let text = self.wgsl.lines().count();
        self.wgsl += module.wgsl;
        // The next module begins a line of its own.
        if !self.wgsl.ends_with('\n') {
            self.wgsl.push('\n');
        }
        self.parts.push(WgslPart {
            path: module.path,
            constants,
            text,
        });
    }
}

/// The shader of some modules and of all that they need. `modules` are all that there are, each
/// after those that it needs; a path that none of them has is left out.
///
/// ```
/// use pangaea_shaders::amplify::twins::MODULES;
/// use pangaea_shaders::wgsl::compose;
///
/// let shader = compose(&MODULES, &["amplify/seed"]);
/// assert!(shader.wgsl.contains("const Q16: i32 = 65536;"));
/// assert!(shader.wgsl.contains("fn between(a: u32, b: u32) -> u32"));
/// ```
pub fn compose(modules: &[WgslModule], wanted: &[&str]) -> ComposedWgsl {
    let mut needed: Vec<&str> = wanted.to_vec();
    // From the last to the first: whoever needs a module has then named it.
    for module in modules.iter().rev() {
        if needed.contains(&module.path) {
            needed.extend(module.needs);
        }
    }
    let mut shader = ComposedWgsl::default();
    for module in modules.iter().filter(|m| needed.contains(&m.path)) {
        shader.add(module);
    }
    shader
}

#[cfg(test)]
mod tests {
    use super::*;

    fn module(path: &'static str, needs: &'static [&'static str]) -> WgslModule {
        WgslModule {
            path,
            wgsl: "// One.\n// Two.",
            needs,
            constants: String::new,
        }
    }

    #[test]
    fn constants_are_declared_in_wgsl() {
        assert_eq!(declaration("A", -7), "const A: i32 = -7;\n");
        assert_eq!(declaration("B", u32::MAX), "const B: u32 = 4294967295u;\n");
        let pair = "const C: array<i32, 2> = array<i32, 2>(1, -2);\n";
        assert_eq!(declaration("C", [1, -2]), pair);
    }

    #[test]
    fn a_shader_has_what_it_needs_once_and_in_order() {
        let modules = [
            module("a", &[]),
            module("unused", &["a"]),
            module("b", &["a"]),
            module("c", &["a", "b"]),
        ];
        let shader = compose(&modules, &["c"]);
        let paths: Vec<&str> = shader.parts.iter().map(|part| part.path).collect();
        assert_eq!(paths, ["a", "b", "c"]);
    }

    #[test]
    fn a_line_is_found_in_its_module() {
        let declares = WgslModule {
            constants: || declaration("A", 1),
            ..module("b", &["a"])
        };
        let shader = compose(&[module("a", &[]), declares], &["b"]);
        let places = [1, 2, 3, 4, 5].map(|line| shader.place(line));
        let want = [("a", 1), ("a", 2), ("b", 0), ("b", 1), ("b", 2)];
        assert_eq!(places, want.map(Some));
        assert_eq!(shader.place(0), None);
    }
}
