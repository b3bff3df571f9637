//! Progress bars on stderr, where that is a terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar of `count` units, whose plural is given.
pub fn bar(count: u64, units: &'static str, what: &str) -> ProgressBar {
    let bar = ProgressBar::new(count);
    let style =
        ProgressStyle::with_template("{msg} [{bar:32}] {pos} of {len} {prefix}, {eta} left");
    if let Ok(style) = style {
        bar.set_style(style.progress_chars("=> "));
    }
    bar.set_prefix(units);
    bar.set_message(what.to_string());
    bar
}
