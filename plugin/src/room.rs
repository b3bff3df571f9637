//! Room in memory that is asked for: whether there is any may be answered with no.
//!
//! A program's allocator can ask [`is_asking`] to tell such a question from a demand, whose failure
//! nobody can handle.

use core::cell::Cell;
use std::collections::TryReserveError;

std::thread_local! {
    static IS_ASKING: Cell<bool> = const { Cell::new(false) };
}

/// Makes room for `more` values.
///
/// ```
/// let mut values = Vec::<f32>::new();
/// assert!(bevy_pangaea::room::try_reserve(&mut values, 1000).is_ok());
/// assert!(values.capacity() >= 1000);
/// assert!(bevy_pangaea::room::try_reserve(&mut values, usize::MAX / 8).is_err());
/// ```
///
/// # Errors
/// If there is none.
pub fn try_reserve<T>(values: &mut Vec<T>, more: usize) -> Result<(), TryReserveError> {
    IS_ASKING.set(true);
    let answer = values.try_reserve(more);
    IS_ASKING.set(false);
    answer
}

/// Whether this thread asks for room just now, and can be told that there is none.
pub fn is_asking() -> bool {
    IS_ASKING.get()
}
