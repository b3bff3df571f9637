//! What a compiler finds in a text of WGSL: how structs lie, what entry points bind.

use super::validated;
use naga::proc::Layouter;
use naga::valid::ModuleInfo;
use naga::{AddressSpace, EntryPoint, Module, StorageAccess, Type, TypeInner};
use pangaea_shaders::amplify::twins::MODULES;
use pangaea_shaders::wgsl::compose;

/// A struct as it lies in a buffer.
#[derive(Debug, PartialEq, Eq)]
pub struct FoundStruct {
    /// Bytes from one to the next.
    pub size: usize,
    /// Names, offsets and sizes of its members, in bytes.
    pub members: Vec<(String, usize, usize)>,
}

/// A buffer that an entry point uses.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct FoundBinding {
    /// Group and binding.
    pub place: [u32; 2],
    /// Name of the variable.
    pub name: String,
    /// Whether it may be written; `None` for a uniform.
    pub is_written: Option<bool>,
    /// Bytes from one of its items to the next; of a uniform, of all of it.
    pub stride: usize,
}

/// A module of the ground with all that it needs, as the compiler sees it.
pub struct Reflected {
    module: Module,
    info: ModuleInfo,
}

impl Reflected {
    /// The module of a path.
    pub fn new(path: &str) -> Self {
        let (module, info) = validated(path, &compose(&MODULES, &[path]));
        Self { module, info }
    }

    /// Names of its entry points.
    pub fn entries(&self) -> Vec<&str> {
        let entries = self.module.entry_points.iter();
        entries.map(|entry| entry.name.as_str()).collect()
    }

    /// Items in a group of an entry point.
    pub fn group_size(&self, entry: &str) -> Option<[u32; 3]> {
        self.entry(entry).map(|(_, entry)| entry.workgroup_size)
    }

    fn entry(&self, name: &str) -> Option<(usize, &EntryPoint)> {
        let mut entries = self.module.entry_points.iter().enumerate();
        entries.find(|(_, entry)| entry.name == name)
    }

    /// The struct of a name.
    pub fn found_struct(&self, name: &str) -> Option<FoundStruct> {
        let mut types = self.module.types.iter().map(|(_, ty)| ty);
        let found = types.find(|ty| ty.name.as_deref() == Some(name))?;
        let TypeInner::Struct { members, span } = &found.inner else {
            return None;
        };
        let members = members.iter().map(|member| {
            let ty = &self.module.types[member.ty];
            let name = member.name.clone().unwrap_or_default();
            (name, member.offset as usize, self.size(ty))
        });
        Some(FoundStruct {
            size: *span as usize,
            members: members.collect(),
        })
    }

    fn size(&self, ty: &Type) -> usize {
        ty.inner.size(self.module.to_ctx()) as usize
    }

    /// The buffers that an entry point uses, by their places.
    pub fn bindings(&self, entry: &str) -> Vec<FoundBinding> {
        let Some((index, _)) = self.entry(entry) else {
            return Vec::new();
        };
        let uses = self.info.get_entry_point(index);
        let mut found: Vec<FoundBinding> = Vec::new();
        for (handle, variable) in self.module.global_variables.iter() {
            let Some(binding) = &variable.binding else {
                continue;
            };
            if uses[handle].is_empty() {
                continue;
            }
            let ty = &self.module.types[variable.ty];
            let is_written = match variable.space {
                AddressSpace::Storage { access } => Some(access.contains(StorageAccess::STORE)),
                _ => None,
            };
            found.push(FoundBinding {
                place: [binding.group, binding.binding],
                name: variable.name.clone().unwrap_or_default(),
                is_written,
                stride: match ty.inner {
                    TypeInner::Array { stride, .. } => stride as usize,
                    _ => self.size(ty),
                },
            });
        }
        found.sort();
        found
    }

    /// Bytes that the groups of an entry point have in common.
    pub fn group_memory(&self, entry: &str) -> usize {
        let Some((index, _)) = self.entry(entry) else {
            return 0;
        };
        let uses = self.info.get_entry_point(index);
        let mut layouter = Layouter::default();
        layouter
            .update(self.module.to_ctx())
            .expect("a valid module has a layout");
        let variables = self.module.global_variables.iter();
        let shared = variables.filter(|(handle, variable)| {
            variable.space == AddressSpace::WorkGroup && !uses[*handle].is_empty()
        });
        shared
            .map(|(_, variable)| layouter[variable.ty].size as usize)
            .sum()
    }
}
