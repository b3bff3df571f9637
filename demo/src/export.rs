//! `pangaea export`: the ground of a square, of tiles or of a box of degrees as files.

use crate::cli::ExportArgs;
use crate::error::CliError;
use crate::ground::{bake_planet, ground};
use crate::inputs::Inputs;
use crate::interrupt;
use crate::output::{say, warn_of_older};
use crate::progress;
use crate::source::load_planet;
use crate::values::{BoxSpec, PixelsSpec, RegionSpec, TilesSpec};
use bevy_pangaea::io::check_outputs;
use bevy_pangaea::io::export::{
    ExportArea, ExportError, ExportFiles, ExportFormat, ExportJob, Exported,
};
use bevy_pangaea::query::{
    AzimuthalEquidistant, DegreeBox, FieldGround, GridProjection, Ground, GroundError, MapGrid,
    MapSquare, TileBlock,
};

/// The warning of tiles that the new manifest does not list.
const OLDER_TILES: &str = "tiles of an older block stay, which the .json does not list any more";

/// Runs the command.
///
/// # Errors
/// If an option or the planet is refused, or the user interrupts it; nothing is written then.
pub fn export(args: &ExportArgs) -> Result<(), CliError> {
    interrupt::watch();
    let shape = Shape::of(args)?;
    check_output(args, &shape)?;
    let climate = args.ground.climate.load()?;
    let state = load_planet(&args.ground.planet)?;
    let radius_m = 1000.0 * state.planet.radius;
    let area = shape.area(radius_m)?;
    let field = args.field.load(radius_m)?;
    let mut job = ExportJob::new(area, &args.out)?;
    if let Some(range) = args.range {
        job = job.with_range(range.0)?;
    }
    if let Some(level) = args.level {
        job = job.at_level(level)?;
    }
    let ground = ground(&bake_planet(state, climate)?)?;
    say(&scale_of(&job.grid()));
    let older = job.files().older_tiles();
    let exported = match field {
        Some(field) => run(&job, &FieldGround::new(ground, field))?,
        None => run(&job, &ground)?,
    };
    report(args, &exported);
    warn_of_older(OLDER_TILES, &older);
    Ok(())
}

/// The area that is asked for, before the size of the planet is known.
enum Shape {
    Square(RegionSpec, usize),
    Tiles(RegionSpec, usize, TilesSpec),
    Box(BoxSpec, [usize; 2]),
}

impl Shape {
    /// Refuses options that do not go together.
    fn of(args: &ExportArgs) -> Result<Self, CliError> {
        match (args.region, args.degrees, args.pixels) {
            (Some(region), _, PixelsSpec::Side(pixels)) => Ok(match args.tiles {
                Some(tiles) => Self::Tiles(region, pixels, tiles),
                None => Self::Square(region, pixels),
            }),
            (None, Some(degrees), PixelsSpec::Size(size)) => Ok(Self::Box(degrees, size)),
            (None, Some(degrees), PixelsSpec::Side(columns)) => {
                let rows = DegreeBox::rows_for(columns, degrees.0)?;
                Ok(Self::Box(degrees, [columns, rows]))
            }
            _ => Err(CliError::input("--pixels: COLUMNSxROWS is for --box")),
        }
    }

    /// Columns and rows of its tiles.
    fn tiles(&self) -> Option<[usize; 2]> {
        match self {
            Self::Tiles(_, _, tiles) => Some(tiles.0),
            Self::Square(..) | Self::Box(..) => None,
        }
    }

    /// Refuses more pixels than a file of the format has.
    fn check(&self, format: ExportFormat) -> Result<(), CliError> {
        match self {
            Self::Square(_, pixels) => format.check(*pixels)?,
            Self::Tiles(_, vertices, tiles) => {
                format.check(*vertices)?;
                TileBlock::check(*vertices, tiles.0)
                    .map_err(|error| CliError::input(format!("--tiles: {error}")))?;
            }
            Self::Box(_, _) if format == ExportFormat::Mesh => {
                return Err(ExportError::MeshOfBox.into());
            }
            Self::Box(_, [columns, rows]) => format
                .check(*columns.max(rows))
                .map_err(|error| CliError::input(format!("--pixels: {error}")))?,
        }
        Ok(())
    }

    /// The area on a planet of `radius_m`.
    fn area(&self, radius_m: f64) -> Result<ExportArea, CliError> {
        match *self {
            Self::Square(region, pixels) => {
                let square = MapSquare::new(about(region, radius_m)?, metres(region), pixels);
                in_options(square, region, pixels).map(ExportArea::from)
            }
            Self::Tiles(region, vertices, TilesSpec(tiles)) => {
                let about = about(region, radius_m)?;
                let block = TileBlock::new(about, metres(region), vertices, tiles);
                in_options(block, region, vertices).map(ExportArea::from)
            }
            Self::Box(BoxSpec(bounds), pixels) => {
                Ok(DegreeBox::new(bounds, radius_m, pixels)?.into())
            }
        }
    }
}

fn about(region: RegionSpec, radius_m: f64) -> Result<AzimuthalEquidistant, GroundError> {
    AzimuthalEquidistant::new(region.middle.lat, region.middle.lon, radius_m)
}

fn metres(region: RegionSpec) -> f64 {
    1000.0 * region.size_km
}

/// Says a refused length in the terms of the options.
fn in_options<T>(
    area: Result<T, GroundError>,
    region: RegionSpec,
    pixels: usize,
) -> Result<T, CliError> {
    area.map_err(|error| match error {
        GroundError::Length { min, max, .. } => CliError::input(format!(
            "--region: with {pixels} pixels SIZE_KM is {} to {:.0}, not {}",
            1e-3 * min,
            1e-3 * max,
            region.size_km
        )),
        error => error.into(),
    })
}

/// Refuses names without a format, options that the format does not take, and places where no file
/// can be, before a planet is loaded.
fn check_output(args: &ExportArgs, shape: &Shape) -> Result<(), CliError> {
    let files = ExportFiles::new(&args.out, shape.tiles())?;
    let format = files.format();
    shape.check(format)?;
    if args.range.is_some() && !format.has_greys() {
        return Err(ExportError::NoGreys(format.name()).into());
    }
    let inputs = Inputs::new(args.ground.files().chain(args.field.files()));
    let outputs = files.outputs();
    for output in &outputs {
        inputs.check(output.path())?;
    }
    Ok(check_outputs(&outputs)?)
}

/// Level and resolution of a grid, for the user.
fn scale_of(grid: &MapGrid) -> String {
    let (level, step) = (grid.level(), grid.step());
    match grid.projection() {
        GridProjection::Azimuthal(_) => format!("level {level}, {:.3} m to a pixel", step.x),
        GridProjection::PlateCarree { .. } => format!(
            "level {level}, {} x {} pixels of {:.6} x {:.6} degrees",
            grid.columns(),
            grid.rows(),
            step.x,
            step.y
        ),
    }
}

/// Writes the files, with a progress bar.
fn run(job: &ExportJob, ground: &impl Ground) -> Result<Exported, CliError> {
    let columns = job.grid().columns();
    let bar = progress::bar(job.grid().rows() as u64, "rows", "amplifying");
    let exported = job.run(ground, |points| {
        bar.set_position((points / columns) as u64);
        interrupt::check().is_ok()
    });
    bar.finish_and_clear();
    // A write that was stopped fails, too.
    interrupt::check()?;
    Ok(exported?)
}

/// Names the files, and says where heights were cut off.
fn report(args: &ExportArgs, exported: &Exported) {
    let [lowest, highest] = exported.heights_m;
    if let (Some(range), true) = (args.range, exported.is_cut_off) {
        let [low, high] = range.0;
        say(&format!(
            "warning: --range {low},{high} cuts off ground from {lowest} to {highest} m"
        ));
    }
    for path in &exported.files {
        say(&path.display().to_string());
    }
}
