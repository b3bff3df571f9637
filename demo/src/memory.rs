//! The end of memory: one line and exit code 1, where Rust would abort with a backtrace.

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::Write;

/// The system's allocator; where it has nothing left, the program says so and ends.
pub struct FiniteMemory;

#[global_allocator]
static MEMORY: FiniteMemory = FiniteMemory;

// SAFETY: every call is handed on to `System` as it came, and every answer but null as it was given.
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

/// The memory that was asked for; the program ends where there is none.
fn given(place: *mut u8, size: usize) -> *mut u8 {
    if place.is_null() {
        // Neither allocates, and nobody needs to hear it.
        let _ = writeln!(
            std::io::stderr(),
            "error: memory is full: {size} bytes more are needed; nothing is written"
        );
        std::process::exit(1);
    }
    place
}
