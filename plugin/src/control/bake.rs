//! A bake: from the crust as it is now, or from a user's maps, to the control mesh.

use super::pack::{ControlInput, control_mesh};
use super::rivers::RiverRule;
use super::topology::Topology;
use crate::climate::{Climate, ClimateMaps, MapError};
use crate::crust::Surface;
use crate::hydrology::{BaseMesh, Drainage, RiverNetwork, Terrain, TerrainMaps, Transfer};
use crate::sphere::{SphereError, SphereMesh};
use bevy::reflect::{Reflect, TypePath};
use pangaea_shaders::amplify::control::ControlMesh;
use std::sync::Arc;

/// The part that all bakes of a planet share: it depends on the seed, the spacing and the lattice
/// alone.
#[derive(Clone, Debug)]
pub struct BakeFrame {
    /// The base mesh.
    pub base: BaseMesh,
    /// Its edges and faces.
    pub topology: Topology,
    /// Where its vertices lie in the lattice of the crust; `None` for planets of maps.
    pub transfer: Option<Transfer>,
    /// Smallest distance of vertices in radians.
    pub spacing: f64,
}

impl BakeFrame {
    /// The frame of a planet with this seed; `lattice` holds the samples of its crust.
    ///
    /// # Errors
    /// [`SphereError`] if the spacing leaves too few vertices.
    pub fn new(seed: u64, spacing: f64, lattice: Option<&SphereMesh>) -> Result<Self, SphereError> {
        Ok(Self::with_base(
            BaseMesh::new(seed, spacing)?,
            spacing,
            lattice,
        ))
    }

    /// The frame on a base mesh that was made with this spacing.
    pub fn with_base(base: BaseMesh, spacing: f64, lattice: Option<&SphereMesh>) -> Self {
        let (topology, transfer) = rayon::join(
            || Topology::new(&base.mesh, base.seed),
            || lattice.map(|lattice| Transfer::new(lattice, &base.mesh)),
        );
        Self {
            base,
            topology,
            transfer,
            spacing,
        }
    }
}

/// Where the terrain comes from.
pub enum BakeSource<'a> {
    /// The crust of a simulated planet.
    Surface(&'a Surface),
    /// A user's maps.
    Maps(&'a TerrainMaps),
}

/// Climate, drainage and control maps of a planet at one moment.
#[derive(Clone, Debug, TypePath)]
pub struct Bake {
    /// [`Surface::version`] that it was made from.
    pub version: u64,
    /// Geological time in My.
    pub time: f64,
    /// The base mesh and what belongs to it.
    pub frame: Arc<BakeFrame>,
    /// Ground and landforms.
    pub terrain: Terrain,
    /// Climate.
    pub climate: Climate,
    /// Rivers and lakes.
    pub drainage: Drainage,
    /// The input of the amplifier.
    pub control: ControlMesh,
}

/// How a bake is made.
#[derive(Clone, Debug, Default, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BakeRules {
    /// How the network of rivers is found.
    pub network: RiverNetwork,
    /// Which vertices are rivers.
    pub rivers: RiverRule,
}

/// Why there is no bake.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BakeError {
    /// A radius that is not above 0, or beyond [`Bake::MAX_RADIUS`].
    #[error(
        "the planet's radius must be above 0 and at most {max} km, not {0}",
        max = Bake::MAX_RADIUS
    )]
    Radius(f64),
    /// A spacing that is not above 0, infinite, or NaN.
    #[error("the spacing of the base mesh must be a number of radians above 0, not {0}")]
    Spacing(f64),
    /// There is no base mesh of that spacing.
    #[error(transparent)]
    Mesh(#[from] SphereError),
    /// A user's map has values out of range.
    #[error(transparent)]
    Map(#[from] MapError),
}

impl BakeError {
    /// Refuses radii in km that no planet has.
    pub(crate) fn check_radius(radius: f64) -> Result<(), Self> {
        if radius > 0.0 && radius <= Bake::MAX_RADIUS {
            Ok(())
        } else {
            Err(Self::Radius(radius))
        }
    }
}

impl Bake {
    /// Largest radius in km: on larger planets the water of a year would not fit into 64 bits.
    pub const MAX_RADIUS: f64 = 100_000.0;

    /// Bakes a planet of `radius` km, in whose climate `maps` replace fields. (Ground there is only
    /// for radii of 50 to 10,000 km.)
    ///
    /// # Errors
    /// [`BakeError::Radius`], and [`BakeError::Map`] for maps with values out of range.
    ///
    /// ```
    /// use bevy_pangaea::climate::{ClimateMaps, EquirectMap};
    /// use bevy_pangaea::control::{Bake, BakeFrame, BakeRules, BakeSource};
    /// use bevy_pangaea::hydrology::TerrainMaps;
    /// use std::sync::Arc;
    ///
    /// // A coarse planet of a user's map: land in the north, sea in the south.
    /// let crust = EquirectMap::from_fn(32, |lat, _| lat as f32 / 60.0)?;
    /// let terrain = TerrainMaps { crust, age: None, plateau: None, hills: None };
    /// let frame = Arc::new(BakeFrame::new(1, 0.06, None)?);
    /// let (source, rules) = (BakeSource::Maps(&terrain), BakeRules::default());
    /// let bake = Bake::new(&frame, 6370.0, &source, &ClimateMaps::default(), &rules)?;
    /// assert_eq!(bake.control.vertices.len(), bake.mesh().len());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        frame: &Arc<BakeFrame>,
        radius: f64,
        source: &BakeSource,
        maps: &ClimateMaps,
        rules: &BakeRules,
    ) -> Result<Self, BakeError> {
        BakeError::check_radius(radius)?;
        // Maps come from users: refused before anything is built on them.
        maps.check()?;
        if let BakeSource::Maps(terrain) = source {
            terrain.check()?;
        }
        let base = &frame.base;
        let terrain = source.terrain(frame);
        let elevation = terrain.elevation_km();
        let climate = Climate::new(&base.mesh, &base.winds, &elevation, maps);
        let drainage = Drainage::new(base, radius, &terrain, &climate, rules.network);
        let control = control_mesh(&ControlInput {
            mesh: &base.mesh,
            topology: &frame.topology,
            terrain: &terrain,
            climate: &climate,
            drainage: &drainage,
            rule: rules.rivers,
        });
        let (version, time) = source.moment();
        Ok(Self {
            version,
            time,
            frame: frame.clone(),
            terrain,
            climate,
            drainage,
            control,
        })
    }

    /// The base mesh.
    pub fn mesh(&self) -> &SphereMesh {
        &self.frame.base.mesh
    }
}

impl BakeSource<'_> {
    fn terrain(&self, frame: &BakeFrame) -> Terrain {
        match (self, &frame.transfer) {
            (Self::Surface(surface), Some(transfer)) => {
                Terrain::from_surface(&frame.base, transfer, surface)
            }
            (Self::Maps(maps), _) => Terrain::from_maps(&frame.base, maps),
            // Without a lattice there is no crust to read: an ocean.
            (Self::Surface(_), None) => Terrain::ocean(frame.base.mesh.len()),
        }
    }

    /// Version of the surface, and geological time in My; both 0 for maps.
    fn moment(&self) -> (u64, f64) {
        match self {
            Self::Surface(surface) => (surface.version, surface.time),
            Self::Maps(_) => (0, 0.0),
        }
    }
}
