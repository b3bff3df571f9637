//! Functions and passes in WGSL beside their twins in Rust, on the same inputs, word by word.
//!
//! Any Vulkan adapter will do, at the limits and features that every WebGPU device has.

mod chain;
mod columns;
mod device;
mod kernel;
mod layout;
mod level;
mod made;
mod pass;
mod ruled;
mod run;
mod whole;
mod words;

pub use chain::assert_chains;
pub use device::Gpu;
pub use kernel::{TwinKernel, parsed, validated};
pub use layout::{FoundBinding, FoundStruct, Reflected};
pub use level::MarkedLevel;
pub use pass::{PassCase, assert_pass, pass_times};
pub use run::{assert_run, each_pass};
pub use whole::{FinishedRun, WholeGround, assert_is_closed};
pub use words::Words;

use fastrand::Rng;
use std::iter::repeat_with;

/// Inputs that a function is tried on; sixteen times as many in a soak.
const INPUTS: usize = 1 << 16;

/// Numbers at which things go wrong.
const EDGES: [u32; 12] = [
    0,
    1,
    u32::MAX,
    1 << 31,
    (1 << 31) - 1,
    1 << 16,
    (1 << 16) - 1,
    (1 << 16) + 1,
    0_u32.wrapping_sub(1 << 16),
    1 << 15,
    1 << 30,
    3 << 30,
];

/// Asserts that a function of a module has the same bits as its twin.
///
/// `input` makes an input of any value, one that the function is defined for; `None` drops it.
/// Without an adapter nothing is asserted, unless `PANGAEA_GPU=require`.
pub fn assert_twin<A: Words, R: Words>(
    path: &str,
    function: &str,
    input: impl Fn(A) -> Option<A>,
    rust: impl Fn(A) -> R,
) {
    assert_call(path, "", function, input, rust);
}

/// The same for a function of `wgsl`, which calls the module's.
pub fn assert_call<A: Words, R: Words>(
    path: &str,
    wgsl: &str,
    function: &str,
    input: impl Fn(A) -> Option<A>,
    rust: impl Fn(A) -> R,
) {
    let Some(gpu) = Gpu::get() else { return };
    let inputs = inputs(function, input);
    let kernel = TwinKernel::new(path, wgsl, function);
    assert_eq!(kernel.words, [A::COUNT, R::COUNT], "words of {function}");
    let words: Vec<u32> = inputs.iter().flat_map(words_of).collect();
    let found = gpu.run(&kernel.wgsl, &words, inputs.len(), R::COUNT);
    for (input, found) in inputs.iter().zip(found.chunks(R::COUNT)) {
        let wanted = words_of(&rust(input.clone()));
        assert_eq!(
            found, wanted,
            "{function}{input:?}: WGSL, then Rust; on {}",
            gpu.name
        );
    }
}

fn words_of<T: Words>(value: &T) -> Vec<u32> {
    let mut words = Vec::with_capacity(T::COUNT);
    value.write(&mut words);
    words
}

/// Inputs that a function is defined for, the same in every run.
fn inputs<A: Words>(function: &str, input: impl Fn(A) -> Option<A>) -> Vec<A> {
    let soak = std::env::var_os("PANGAEA_SOAK").is_some();
    let count = if soak { 16 * INPUTS } else { INPUTS };
    let seed = function.bytes().fold(1, |seed, b| seed * 31 + u64::from(b));
    let mut random = Rng::with_seed(seed);
    let draw = || A::read(&mut repeat_with(|| word(&mut random)));
    let tries = repeat_with(draw).take(64 * count);
    let inputs: Vec<A> = tries.filter_map(input).take(count).collect();
    assert_eq!(inputs.len(), count, "{function} refuses too many inputs");
    inputs
}

/// An edge, or a number of any length and sign.
fn word(random: &mut Rng) -> u32 {
    if random.u32(..4) == 0 {
        return EDGES[random.usize(..EDGES.len())];
    }
    (random.i32(..) >> random.u32(..32)) as u32
}
