//! Rows, bindings and groups of the passes, as Rust and WGSL have them. Needs no adapter.

use pangaea_shaders::amplify::columns::{COLUMNS, ComputePass, GpuColumn, PASSES, WRITTEN};
use pangaea_shaders::amplify::count::LevelCounts;
use pangaea_shaders::amplify::rows::{Row, RowLayout};
use pangaea_shaders::amplify::twins::MODULES;
use pangaea_tests::gpu::{FoundBinding, Reflected};
use std::collections::BTreeSet;

/// Storage buffers that every WebGPU device binds at once.
const STORAGE_BUFFERS: usize = 8;

/// Bytes that every WebGPU device has for what a group has in common.
const GROUP_MEMORY: usize = 16_384;

/// Items of a group that every WebGPU device runs.
const MOST_ITEMS: usize = 256;

fn column(name: &str) -> GpuColumn {
    let mut columns = COLUMNS.into_iter();
    columns.find(|column| column.name == name).expect(name)
}

#[test]
fn rows_lie_as_their_structs() {
    let found = Reflected::new("amplify/columns");
    let rows = COLUMNS.map(|column| column.row);
    let structs = rows.iter().filter(|row| !row.members.is_empty());
    for &RowLayout {
        name,
        size,
        members,
    } in structs.chain([&LevelCounts::LAYOUT])
    {
        let wgsl = found.found_struct(name).expect(name);
        let members = members
            .iter()
            .map(|&(name, offset, size)| (name.to_string(), offset, size));
        assert_eq!(wgsl.size, size, "{name}");
        assert_eq!(wgsl.members, members.collect::<Vec<_>>(), "{name}");
    }
}

#[test]
fn passes_bind_what_the_table_says() {
    for pass in PASSES {
        let found = Reflected::new(pass.module).bindings(pass.entry);
        assert_eq!(found, wanted(&pass), "{}", pass.entry);
    }
}

/// The bindings of a pass: the uniform of its level, and its columns.
fn wanted(pass: &ComputePass) -> Vec<FoundBinding> {
    let uniform = FoundBinding {
        place: [0, 0],
        name: "level_uniform".into(),
        is_written: None,
        stride: 224,
    };
    let reads = pass.reads.iter().map(|name| {
        let column = column(name);
        FoundBinding {
            place: [1, column.binding],
            name: column.name.into(),
            is_written: (!column.is_uniform).then_some(false),
            stride: column.row.size,
        }
    });
    let writes = pass.writes.iter().map(|name| {
        let column = column(name);
        FoundBinding {
            place: [1, column.binding + WRITTEN],
            name: format!("out_{name}"),
            is_written: Some(true),
            stride: column.row.size,
        }
    });
    let mut wanted: Vec<FoundBinding> = [uniform].into_iter().chain(reads).chain(writes).collect();
    wanted.sort();
    wanted
}

#[test]
fn passes_keep_the_limits_of_every_device() {
    for pass in PASSES {
        let found = Reflected::new(pass.module);
        let storage = found.bindings(pass.entry).into_iter();
        let storage = storage
            .filter(|binding| binding.is_written.is_some())
            .count();
        assert!(storage <= STORAGE_BUFFERS, "{}: {storage}", pass.entry);
        let memory = found.group_memory(pass.entry);
        assert!(memory <= GROUP_MEMORY, "{}: {memory}", pass.entry);
        let group = [pass.group as u32, 1, 1];
        assert_eq!(found.group_size(pass.entry), Some(group), "{}", pass.entry);
        assert!(pass.group <= MOST_ITEMS, "{}", pass.entry);
    }
}

/// A column that is read and written at once would be bound twice.
#[test]
fn no_pass_reads_a_column_that_it_writes() {
    for pass in PASSES {
        let reads: BTreeSet<&str> = pass.reads.iter().copied().collect();
        let twice = pass.writes.iter().find(|name| reads.contains(*name));
        assert_eq!(twice, None, "{}", pass.entry);
    }
}

#[test]
fn every_entry_point_is_a_pass() {
    let mut found = BTreeSet::new();
    for module in MODULES {
        let entries = module.wgsl.split("@compute").skip(1);
        let entry = |text: &str| {
            let name = text.split("fn ").nth(1).expect("a function");
            name.split('(').next().expect("a name").to_string()
        };
        found.extend(entries.map(|text| (module.path.to_string(), entry(text))));
    }
    let wanted = PASSES.map(|pass| (pass.module.to_string(), pass.entry.to_string()));
    assert_eq!(found, BTreeSet::from(wanted));
}
