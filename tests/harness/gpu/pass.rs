//! One compute pass alone, on the columns that its Rust twin reads; the first word that differs is
//! named.

use super::Gpu;
use super::columns::{STALE, stale_sizes};
use bevy::render::render_resource::{Buffer, BufferUsages, ComputePipeline};
use pangaea_shaders::amplify::columns::{
    ComputePass, GpuColumn, LEVELS, WRITTEN, column_named, pass_named,
};
use pangaea_shaders::amplify::rows::{LevelCaps, LevelSizes, words};
use pangaea_shaders::amplify::rules::Rules;
use pangaea_shaders::amplify::sight::Sight;
use pangaea_shaders::amplify::twins::MODULES;
use pangaea_shaders::amplify::uniform::level_words;
use pangaea_shaders::wgsl::compose;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Words of columns, by their names.
pub(super) type ColumnWords = BTreeMap<&'static str, Vec<u32>>;

/// The column that passes read as a uniform.
pub(super) const SIZES: &str = "level_sizes";

/// Words after every column that is written, which no pass may touch.
const GUARD: usize = 64;

/// A pass over a level, as its Rust twin does it.
pub struct PassCase<'a> {
    /// The entry point.
    pub entry: &'static str,
    /// The view.
    pub sight: &'a Sight,
    /// The rules.
    pub rules: Rules,
    /// The level.
    pub level: u32,
    /// Sizes of the level, with all that is known of it when the pass runs.
    pub sizes: LevelSizes,
    /// Groups that it runs with.
    pub groups: u32,
    /// Columns that it reads or writes, before.
    pub before: ColumnWords,
    /// Columns that it writes, after.
    pub after: ColumnWords,
}

/// Times of a pass, seconds: a run of it with its submission, and an item.
#[derive(Clone, Debug, Default)]
struct PassTimes {
    items: Vec<u64>,
    runs: Vec<f64>,
}

/// Times of passes by their entry points.
static TIMES: Mutex<BTreeMap<&'static str, PassTimes>> = Mutex::new(BTreeMap::new());

/// A line for each pass that has run in this process: how often, over how many items, how long half
/// of the runs took at most, and how long an item of the fastest.
pub fn pass_times() -> String {
    let times = TIMES.lock().unwrap_or_else(PoisonError::into_inner);
    times
        .iter()
        .map(|(entry, times)| times.line(entry))
        .collect()
}

impl PassTimes {
    fn line(&self, entry: &str) -> String {
        let mut runs = self.runs.clone();
        runs.sort_by(f64::total_cmp);
        let half = runs[runs.len() / 2] * 1e6;
        let each = self.items.iter().zip(&self.runs);
        let each = each.map(|(&items, run)| run / items.max(1) as f64 * 1e9);
        let fastest = each.fold(f64::MAX, f64::min);
        let items: u64 = self.items.iter().sum();
        let count = runs.len();
        format!(
            "{entry:<12} {count:>5} runs, {items:>9} items, {half:>7.0} us, {fastest:>6.1} ns\n"
        )
    }
}

/// Asserts that a pass writes what its Rust twin does, and nothing else. Without an adapter nothing
/// is asserted, unless `PANGAEA_GPU=require`.
pub fn assert_pass(case: &PassCase) {
    let Some(gpu) = Gpu::get() else { return };
    let pass = pass_named(case.entry).expect(case.entry);
    let found = run(gpu, &pass, case);
    for &name in pass.writes {
        let column = column_named(name).expect(name);
        assert_words(case.entry, case, column, &found[name], &case.after[name]);
    }
}

/// Asserts that a column has the words that it should have, and after them the guards.
pub(super) fn assert_words(
    who: &str,
    case: &PassCase,
    column: GpuColumn,
    found: &[u32],
    wanted: &[u32],
) {
    let wanted = guarded(wanted);
    assert_eq!(found.len(), wanted.len(), "{who}: {}", column.name);
    if let Some(at) = (0..wanted.len()).find(|&i| found[i] != wanted[i]) {
        let per_row = column.row.size / 4;
        let member = member_at(column, at % per_row * 4);
        panic!(
            "{who} of level {}: {}[{}].{member}: {:#x}, in Rust {:#x}; {:?}",
            case.level,
            column.name,
            at / per_row,
            found[at],
            wanted[at],
            case.sizes
        );
    }
}

/// The member of a row that a byte belongs to.
fn member_at(column: GpuColumn, byte: usize) -> String {
    let mut members = column.row.members.iter();
    let member = members.find(|&&(_, offset, size)| (offset..offset + size).contains(&byte));
    match member {
        Some((name, offset, _)) => format!("{name}[{}]", (byte - offset) / 4),
        None => format!("[{}]", byte / 4),
    }
}

/// Words with guards after them.
pub(super) fn guarded(words: &[u32]) -> Vec<u32> {
    let mut words = words.to_vec();
    words.resize(words.len() + GUARD, STALE);
    words
}

/// The columns that a pass writes, after it.
fn run(gpu: &Gpu, pass: &ComputePass, case: &PassCase) -> ColumnWords {
    let pipeline = pipeline(gpu, pass);
    let bound = Bound::new(gpu, pass, case);
    let common = gpu.group(&pipeline, 0, &[(0, &bound.uniform)]);
    let columns = bound.columns.iter().map(|(_, at, buffer)| (*at, buffer));
    let columns = gpu.group(&pipeline, 1, &columns.collect::<Vec<_>>());
    gpu.wait();
    let start = Instant::now();
    gpu.dispatch(&pipeline, &[common, columns], case.groups);
    gpu.wait();
    let took = start.elapsed();
    let mut times = TIMES.lock().unwrap_or_else(PoisonError::into_inner);
    let entry = times.entry(pass.entry).or_default();
    entry.items.push(u64::from(case.groups) * pass.group as u64);
    entry.runs.push(took.as_secs_f64());
    drop(times);
    bound.written(gpu)
}

/// The pipeline of a pass, which is made once.
pub(super) fn pipeline(gpu: &Gpu, pass: &ComputePass) -> ComputePipeline {
    static PIPELINES: Mutex<BTreeMap<&str, ComputePipeline>> = Mutex::new(BTreeMap::new());
    let mut pipelines = PIPELINES.lock().unwrap_or_else(PoisonError::into_inner);
    let known = pipelines.entry(pass.entry);
    let make = || gpu.pipeline(&compose(&MODULES, &[pass.module]).wgsl, pass.entry);
    known.or_insert_with(make).clone()
}

/// The buffers of a pass.
struct Bound {
    uniform: Buffer,
    /// Names, bindings, buffers.
    columns: Vec<(&'static str, u32, Buffer)>,
}

impl Bound {
    fn new(gpu: &Gpu, pass: &ComputePass, case: &PassCase) -> Self {
        let uniform = level_words(case.sight, case.level, &case.rules, &LevelCaps::default());
        let read = |name: &&'static str| {
            let buffer = if *name == SIZES {
                gpu.upload(&words(all_sizes(case)), BufferUsages::UNIFORM)
            } else {
                gpu.upload(&guarded(&case.before[name]), BufferUsages::STORAGE)
            };
            (*name, 0, buffer)
        };
        let written = |name: &&'static str| {
            let usage = BufferUsages::STORAGE | BufferUsages::COPY_SRC;
            let words = guarded(&case.before[name]);
            (*name, WRITTEN, gpu.upload(&words, usage))
        };
        let columns = pass.reads.iter().map(read);
        let columns = columns.chain(pass.writes.iter().map(written));
        let columns = columns.map(|(name, offset, buffer)| {
            let column = column_named(name).expect(name);
            (name, column.binding + offset, buffer)
        });
        Self {
            uniform: gpu.upload(&uniform, BufferUsages::UNIFORM),
            columns: columns.collect(),
        }
    }

    fn written(&self, gpu: &Gpu) -> ColumnWords {
        let written = self.columns.iter().filter(|(_, at, _)| *at >= WRITTEN);
        let (names, buffers): (Vec<_>, Vec<_>) =
            written.map(|(name, _, buffer)| (*name, buffer)).unzip();
        names.into_iter().zip(gpu.download(&buffers)).collect()
    }
}

/// Sizes of all levels, of which the pass may read its own.
fn all_sizes(case: &PassCase) -> [LevelSizes; LEVELS] {
    let mut sizes = [stale_sizes(); LEVELS];
    sizes[case.level as usize] = case.sizes;
    sizes
}
