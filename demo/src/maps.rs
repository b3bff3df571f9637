//! `pangaea maps`: equirectangular maps of a planet, of which `generate` draws the same.

use crate::cli::MapsArgs;
use crate::error::CliError;
use crate::ground::bake_planet;
use crate::headless::Headless;
use crate::inputs::Inputs;
use crate::interrupt;
use crate::output::{Files, say_written, warn_of_older};
use crate::progress;
use crate::source::load_planet;
use bevy_pangaea::crust::PlanetSurface;
use bevy_pangaea::io::{is_marked, png};
use bevy_pangaea::overlay::{MapProjection, Overlay};
use std::collections::BTreeSet;
use std::fmt::Display;
use std::fs;
use std::path::{Path, PathBuf};

/// The elevation in 16 bits.
const ELEVATION_FILE: &str = "elevation.png";

/// The warning of maps that are not drawn anew.
const OLDER_MAPS: &str = "older maps stay, which may be those of another planet";

/// Maps of a planet: the elevation in 16 bits of grey, and overlays in colours.
pub struct MapSet {
    /// Width in pixels; the height is half of it.
    width: u32,
    overlays: Vec<Overlay>,
}

impl Default for MapSet {
    /// Every overlay.
    fn default() -> Self {
        Self {
            width: 2048,
            overlays: Overlay::ALL.to_vec(),
        }
    }
}

impl MapSet {
    /// The maps that are asked for, each once.
    fn new(args: &MapsArgs) -> Self {
        let all = args.overlay.is_empty();
        let chosen = |overlay: &Overlay| all || args.overlay.contains(overlay);
        Self {
            width: args.size,
            overlays: Overlay::ALL.into_iter().filter(chosen).collect(),
        }
    }

    /// The names of their files.
    pub fn names(&self) -> impl Iterator<Item = String> {
        let overlays = self.overlays.iter().copied().map(file_name);
        core::iter::once(ELEVATION_FILE.into()).chain(overlays)
    }

    /// Maps of ours in a folder that are not among these.
    fn older(&self, folder: &Path) -> Vec<PathBuf> {
        let own: BTreeSet<String> = self.names().collect();
        let all = Self::default();
        let others = all.names().filter(|name| !own.contains(name));
        let paths = others.map(|name| folder.join(name));
        paths
            .filter(|path| path.is_file() && is_marked(path).is_ok_and(|is_ours| is_ours))
            .collect()
    }

    /// Draws the maps of a planet that was baked, with a progress bar.
    ///
    /// # Errors
    /// If the user interrupts it, or a map cannot be encoded.
    pub fn draw(&self, headless: &Headless, files: &mut Files) -> Result<(), CliError> {
        let plates = headless.plates();
        let input = headless.overlay_input(&plates)?;
        let map = MapProjection::new(input.mesh, self.width, self.width / 2);
        let elevation = map.elevation(headless.get::<PlanetSurface>()?);
        let grey = png::elevation_png(map.width(), &elevation).map_err(not_encoded)?;
        files.add(ELEVATION_FILE, grey);
        let bar = progress::bar(self.overlays.len() as u64, "maps", "drawing");
        map.draw_each(&self.overlays, &input, |overlay, picture| {
            interrupt::check()?;
            files.add(
                &file_name(overlay),
                png::rgb_png(&picture).map_err(not_encoded)?,
            );
            bar.inc(1);
            Ok::<_, CliError>(())
        })?;
        bar.finish_and_clear();
        Ok(())
    }
}

/// The file name of an overlay's colour map; `elevation.png` is the grey one.
fn file_name(overlay: Overlay) -> String {
    match overlay {
        Overlay::Elevation => "elevation_color.png".into(),
        other => format!("{}.png", other.name()),
    }
}

fn not_encoded(error: impl Display) -> CliError {
    CliError::Failed(format!("cannot encode a map: {error}"))
}

/// Runs the command.
///
/// # Errors
/// If an option or the planet is refused, or the user interrupts it; nothing is written then.
pub fn maps(args: &MapsArgs) -> Result<(), CliError> {
    interrupt::watch();
    let maps = MapSet::new(args);
    let inputs = Inputs::new(args.ground.files());
    let mut files = Files::new(&args.out, maps.names(), None, &inputs)?;
    let climate = args.ground.climate.load()?;
    let state = load_planet(&args.ground.planet)?;
    maps.draw(&bake_planet(state, climate)?, &mut files)?;
    interrupt::check()?;
    let elevation = || fs::read(args.out.join(ELEVATION_FILE)).ok();
    let older_elevation = elevation();
    say_written(&files.write()?, &args.out);
    // Older maps of the same elevation are those of the same planet.
    if older_elevation != elevation() {
        warn_of_older(OLDER_MAPS, &maps.older(&args.out));
    }
    Ok(())
}
