//! Messages about elevation models.

use crate::output::say;
use bevy_pangaea::io::Dem;
use std::path::Path;

/// Says that a model has more pixels than are held, if it has.
pub fn tell_means(path: &Path, model: &Dem) {
    if !model.is_shrunk() {
        return;
    }
    let [columns, rows] = model.pixels;
    let (width, height) = (model.grid.width, model.grid.height);
    say(&format!(
        "warning: {}: its {columns} x {rows} pixels are read as {width} x {height} means",
        path.display()
    ));
}
