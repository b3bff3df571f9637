//! The end of memory: one line and exit code 1, where Rust would abort with a backtrace.

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use std::{process, thread};

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
        end(size);
    }
    place
}

/// Says that memory is full, once, and ends the program.
fn end(size: usize) -> ! {
    static HAS_ENDED: AtomicBool = AtomicBool::new(false);
    if HAS_ENDED.swap(true, Ordering::Relaxed) {
        // Another thread ends the program; if it cannot, this one does.
        thread::sleep(Duration::from_secs(5));
        process::abort();
    }
    // It does not allocate, and nobody needs to hear it.
    let _ = writeln!(
        io::stderr(),
        "error: memory is full: {size} bytes more are needed"
    );
    process::exit(1);
}
