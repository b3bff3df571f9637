//! The end of memory: one line and exit code 1, and nothing left behind.
//!
//! Code that asks whether there is room is told that there is none, and says so. Where none asks, no
//! answer can help: the thread waits until the program is cleaned up and ended.

use crate::ending;
use bevy_pangaea::room::is_asking;
use std::alloc::{GlobalAlloc, Layout, System};
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

/// The system's allocator; where it has nothing left, and nobody asked, the program ends.
pub struct FiniteMemory;

#[global_allocator]
static MEMORY: FiniteMemory = FiniteMemory;

// SAFETY: every call is handed on to `System` as it came, and every answer as it was given.
unsafe impl GlobalAlloc for FiniteMemory {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promises are those that `System` asks for.
        given(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        // SAFETY: as above; `place` is from `System`.
        unsafe { System.dealloc(place, layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        given(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as above; `place` is from `System`.
        given(unsafe { System.realloc(place, layout, size) }, size)
    }
}

fn given(place: *mut u8, size: usize) -> *mut u8 {
    if place.is_null() && !is_asking() {
        end(size);
    }
    place
}

/// Whether the caller is the first to say why the program ends; one line is enough.
pub fn has_last_word() -> bool {
    static IS_SAID: AtomicBool = AtomicBool::new(false);
    !IS_SAID.swap(true, Ordering::SeqCst)
}

/// Says that memory is full, once, and waits for the end of the program.
fn end(size: usize) -> ! {
    if has_last_word() {
        // It does not allocate, and nobody needs to hear it.
        let _ = writeln!(
            io::stderr(),
            "error: memory is full: {size} bytes more are needed"
        );
    }
    ending::ask(ending::NO_MEMORY);
    loop {
        thread::sleep(Duration::from_secs(1));
    }
}
