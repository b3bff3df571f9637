//! The twins in WGSL of this folder's modules.
//!
//! A function has its Rust twin's name; a method has its type's name before it, in snake case; a
//! function whose name another module has, too, or WGSL reserves, has its module's before it. A
//! type has its name and fields, with `i32` and `u32` for smaller integers. Caches, which save
//! work on the CPU, have no twin.
//!
//! Every name is global in WGSL; it may hide a built-in function, as `mix` and `length` do.

mod numbers;
mod passes;
mod rules;

use crate::wgsl::WgslModule;

/// A module beside which a twin stands: `twin!("path", constants, [needs])`.
macro_rules! twin {
    ($path:literal, $constants:expr, [$($needs:literal),* $(,)?]) => {
        WgslModule {
            path: concat!("amplify/", $path),
            wgsl: include_str!(concat!("../", $path, ".wgsl")),
            needs: &[$(concat!("amplify/", $needs)),*],
            constants: $constants,
        }
    };
}

use twin;

/// Numbers of modules up to the rules, and up to the passes.
const RULES: usize = numbers::MODULES.len();
const PASSES: usize = RULES + rules::MODULES.len();

/// All modules, each after those that it needs.
pub const MODULES: [WgslModule; PASSES + passes::MODULES.len()] = {
    let mut all = [numbers::MODULES[0]; _];
    let mut at = 0;
    while at < all.len() {
        all[at] = if at < RULES {
            numbers::MODULES[at]
        } else if at < PASSES {
            rules::MODULES[at - RULES]
        } else {
            passes::MODULES[at - PASSES]
        };
        at += 1;
    }
    all
};
