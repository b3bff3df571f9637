//! The compute shader that calls one function of a module on many inputs.

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{ArraySize, Function, Handle, Module, Scalar, ScalarKind, Type, TypeInner};
use pangaea_shaders::amplify::twins::MODULES;
use pangaea_shaders::wgsl::{ComposedWgsl, compose};

/// A shader that calls a function.
pub struct TwinKernel {
    /// The shader; its entry point is `call_twin`.
    pub wgsl: String,
    /// Words of an input and of an output.
    pub words: [usize; 2],
}

/// A composed text as a valid module. Fails with the place of the mistake.
pub fn parsed(name: &str, shader: &ComposedWgsl) -> Module {
    validated(name, shader).0
}

/// The same, with all that the validator found out about it.
pub fn validated(name: &str, shader: &ComposedWgsl) -> (Module, ModuleInfo) {
    let module = naga::front::wgsl::parse_str(&shader.wgsl).unwrap_or_else(|error| {
        let line = error.location(&shader.wgsl).map(|at| at.line_number);
        let place = line.and_then(|line| shader.place(line as usize));
        panic!("{name}: {place:?}: {}", error.emit_to_string(&shader.wgsl))
    });
    // The limits of every WebGPU device: no 64-bit numbers, no subgroups.
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(&shader.wgsl)));
    (module, info)
}

impl TwinKernel {
    /// The shader that calls a function of a module of amplification, or of `wgsl` after it.
    pub fn new(path: &str, wgsl: &str, function: &str) -> Self {
        let mut shader = compose(&MODULES, &[path]);
        shader.wgsl += wgsl;
        let module = parsed(path, &shader);
        let mut functions = module.functions.iter().map(|(_, f)| f);
        let called = functions.find(|f| f.name.as_deref() == Some(function));
        let called = called.unwrap_or_else(|| panic!("{path} has no function {function}"));
        let call = Call::of(&module, called);
        Self {
            wgsl: shader.wgsl + &call.entry_point(function),
            words: [call.inputs, call.outputs.len()],
        }
    }
}

/// A call of a function: its arguments read from words, its result as words.
struct Call {
    arguments: Vec<String>,
    inputs: usize,
    outputs: Vec<String>,
}

impl Call {
    fn of(module: &Module, function: &Function) -> Self {
        let mut call = Self {
            arguments: Vec::new(),
            inputs: 0,
            outputs: Vec::new(),
        };
        for argument in &function.arguments {
            let argument = call.read(module, argument.ty);
            call.arguments.push(argument);
        }
        let result = function.result.as_ref().expect("a function has a result");
        call.write(module, result.ty, "result");
        call
    }

    /// An expression that reads a value from the next words.
    fn read(&mut self, module: &Module, ty: Handle<Type>) -> String {
        let parts: Vec<String> = match &module.types[ty].inner {
            TypeInner::Scalar(scalar) => vec![self.read_scalar(*scalar)],
            TypeInner::Vector { size, scalar } => (0..*size as u32)
                .map(|_| self.read_scalar(*scalar))
                .collect(),
            TypeInner::Array { base, size, .. } => (0..count(*size))
                .map(|_| self.read(module, *base))
                .collect(),
            TypeInner::Struct { members, .. } => {
                members.iter().map(|m| self.read(module, m.ty)).collect()
            }
            other => panic!("an argument of type {other:?}"),
        };
        format!("{}({})", type_name(module, ty), parts.join(", "))
    }

    fn read_scalar(&mut self, scalar: Scalar) -> String {
        let word = format!("twin_inputs[first + {}u]", self.inputs);
        self.inputs += 1;
        match scalar.kind {
            ScalarKind::Bool => format!("{word} != 0u"),
            _ => format!("bitcast<{}>({word})", scalar_name(scalar)),
        }
    }

    /// Adds the words of a value.
    fn write(&mut self, module: &Module, ty: Handle<Type>, value: &str) {
        match &module.types[ty].inner {
            TypeInner::Scalar(scalar) => self.outputs.push(word(*scalar, value)),
            TypeInner::Vector { size, scalar } => {
                let parts = (0..*size as u32).map(|i| word(*scalar, &format!("{value}[{i}]")));
                self.outputs.extend(parts);
            }
            TypeInner::Array { base, size, .. } => {
                for i in 0..count(*size) {
                    self.write(module, *base, &format!("{value}[{i}]"));
                }
            }
            TypeInner::Struct { members, .. } => {
                for member in members {
                    let name = member.name.as_deref().unwrap_or_default();
                    self.write(module, member.ty, &format!("{value}.{name}"));
                }
            }
            other => panic!("a result of type {other:?}"),
        }
    }

    fn entry_point(&self, function: &str) -> String {
        let (inputs, outputs) = (self.inputs, self.outputs.len());
        let stores: String = (0..)
            .zip(&self.outputs)
            .map(|(i, word)| format!("    twin_outputs[id.x * {outputs}u + {i}u] = {word};\n"))
            .collect();
        format!(
            "@group(0) @binding(0) var<storage, read> twin_inputs: array<u32>;
@group(0) @binding(1) var<storage, read_write> twin_outputs: array<u32>;

@compute @workgroup_size(64)
fn call_twin(@builtin(global_invocation_id) id: vec3<u32>) {{
    if id.x * {outputs}u >= arrayLength(&twin_outputs) {{
        return;
    }}
    let first = id.x * {inputs}u;
    let result = {function}({});
{stores}}}
",
            self.arguments.join(", ")
        )
    }
}

fn count(size: ArraySize) -> u32 {
    match size {
        ArraySize::Constant(count) => count.get(),
        other => panic!("an array of {other:?} items"),
    }
}

/// A scalar as a word.
fn word(scalar: Scalar, value: &str) -> String {
    match scalar.kind {
        ScalarKind::Bool => format!("select(0u, 1u, {value})"),
        _ => format!("bitcast<u32>({value})"),
    }
}

fn scalar_name(scalar: Scalar) -> &'static str {
    match scalar.kind {
        ScalarKind::Sint => "i32",
        ScalarKind::Uint => "u32",
        ScalarKind::Bool => "bool",
        other => panic!("a number of kind {other:?}"),
    }
}

fn type_name(module: &Module, ty: Handle<Type>) -> String {
    let ty = &module.types[ty];
    match &ty.inner {
        TypeInner::Scalar(scalar) => scalar_name(*scalar).into(),
        TypeInner::Vector { size, scalar } => {
            format!("vec{}<{}>", *size as u32, scalar_name(*scalar))
        }
        TypeInner::Array { base, size, .. } => {
            format!("array<{}, {}>", type_name(module, *base), count(*size))
        }
        _ => ty.name.clone().expect("a struct has a name"),
    }
}
