//! Overlays of a bake: climate, rivers, basins and lakes, on the base mesh of the ground.
//!
//! Maps look at the base mesh itself, which may be finer than the crust's samples; on it lie the
//! lines of `rivers`. A colour per sample of the crust shows what lies at the sample. Without a
//! bake there is nothing to show, and all is grey.

use super::map::Raster;
use super::palette::{self, Rgba};
use super::{Overlay, field, rivers};
use crate::climate::EARTH_RADIUS;
use crate::control::Bake;
use crate::hydrology::{NO_VERTEX, ShoreClass};
use crate::math;
use crate::parallel;
use crate::random::mix;
use crate::sphere::{Location, SphereMesh};
use bevy::math::DVec3;
use rayon::prelude::*;

/// Temperatures at the ends of the ramp in °C.
pub(super) const TEMPERATURE: (f32, f32) = (-40.0, 35.0);
/// Rain at the end of the ramp in mm per year.
pub(super) const RAIN_MAX: f32 = 4000.0;
/// Discharge in m³/s at the end of the ramp, on an Earth-sized planet: that of the Amazon.
const DISCHARGE_MAX: f64 = 200_000.0;
/// Lakes, by the number of their [`LakeKind`](crate::hydrology::LakeKind): blue is what drains to
/// the sea.
pub(super) const LAKE: [Rgba; 3] = [[44, 112, 196, 255], [92, 98, 184, 255], [140, 84, 172, 255]];
/// The sea behind rivers, basins and lakes.
pub(super) const SEA: Rgba = [38, 48, 66, 255];
/// The land behind rivers and lakes.
pub(super) const LAND: Rgba = [206, 202, 190, 255];
/// Water that never reaches the sea darkens towards this.
const CLOSED: Rgba = [96, 40, 40, 255];

/// Whether an overlay shows a bake.
pub(super) fn is_baked(overlay: Overlay) -> bool {
    use Overlay::{Basins, Drainage, Lakes, Rain, Rivers, Temperature, Wetness};
    matches!(
        overlay,
        Temperature | Rain | Wetness | Drainage | Rivers | Basins | Lakes
    )
}

/// Where on [`palette::DISCHARGE`] a discharge lies, of 1 m³/s on an Earth-sized planet at its
/// start: logarithmic.
fn discharge_position(earth_like: f64) -> f64 {
    math::ln(earth_like.max(1.0)) / math::ln(DISCHARGE_MAX)
}

/// The colour of a discharge in m³/s, as it would be on an Earth-sized planet.
pub(super) fn discharge_color(earth_like: f64) -> Rgba {
    palette::DISCHARGE.at(discharge_position(earth_like) as f32)
}

/// Powers of ten in m³/s that lie on the ramp on a planet of `radius` km, and their colours. Small
/// planets have small rivers, and a ramp that ends at smaller ones.
pub(super) fn discharge_decades(radius: f64) -> impl Iterator<Item = (i32, Rgba)> {
    let scale = EARTH_RADIUS / radius;
    let earth_like = move |power: i32| math::pow(10.0, f64::from(power)) * scale * scale;
    let on_ramp = move |&power: &i32| (1.0..=DISCHARGE_MAX).contains(&earth_like(power));
    (-8..=8)
        .filter(on_ramp)
        .map(move |power| (power, discharge_color(earth_like(power))))
}

/// Colours of the samples of the crust.
pub(super) fn colors(overlay: Overlay, bake: &Bake, lattice: &SphereMesh) -> Vec<Rgba> {
    let base = bake.mesh();
    parallel::map(lattice.len(), |i| {
        color_at(overlay, bake, &base.locate(lattice.point(i)))
    })
}

/// The map of an overlay.
pub(super) fn draw(overlay: Overlay, bake: &Bake, width: u32, height: u32) -> Raster {
    let base = bake.mesh();
    let mut rgb = vec![0; 3 * width as usize * height as usize];
    rgb.par_chunks_mut(3 * width as usize)
        .enumerate()
        .for_each(|(y, row)| {
            let mut hint = None;
            for (x, out) in row.chunks_exact_mut(3).enumerate() {
                let p = direction(x as f64 + 0.5, y as f64 + 0.5, width, height);
                let nearest =
                    hint.map_or_else(|| base.nearest(p), |hint| base.nearest_from(p, hint));
                hint = Some(nearest);
                out.copy_from_slice(&color_at(overlay, bake, &base.locate_from(p, nearest))[..3]);
            }
        });
    let mut raster = Raster { width, height, rgb };
    rivers::draw(overlay, bake, &mut raster);
    raster
}

fn direction(x: f64, y: f64, width: u32, height: u32) -> DVec3 {
    let (lat, lon) = (
        90.0 - 180.0 * y / f64::from(height),
        360.0 * x / f64::from(width) - 180.0,
    );
    math::direction(lat, lon)
}

/// The colour at a place of the base mesh, rivers apart.
fn color_at(overlay: Overlay, bake: &Bake, at: &Location) -> Rgba {
    let (climate, drainage) = (&bake.climate, &bake.drainage);
    let mean = |column: &[f32]| at.interpolate(|i| f64::from(column[i as usize])) as f32;
    let i = at.nearest as usize;
    let ground = at.interpolate(|k| f64::from(drainage.ground[k as usize]));
    let backdrop = if ground < 0.0 && drainage.shore[i] != ShoreClass::Land {
        SEA
    } else {
        LAND
    };
    match overlay {
        Overlay::Temperature => {
            palette::TEMPERATURE.within(mean(&climate.temperature), TEMPERATURE.0, TEMPERATURE.1)
        }
        Overlay::Rain => palette::RAIN.at(mean(&climate.rain) / RAIN_MAX),
        Overlay::Wetness => palette::RAIN.at(mean(&climate.wetness)),
        Overlay::Drainage if backdrop == LAND => {
            // Discharge spans decades between a river and its banks: the mean of positions on the
            // ramp, not of m³.
            let position =
                at.interpolate(|k| discharge_position(drainage.earth_like_discharge(k as usize)));
            palette::DISCHARGE.at(position as f32)
        }
        Overlay::Basins if backdrop == LAND && drainage.basin[i] != NO_VERTEX => {
            let color = palette::distinct(mix(u64::from(drainage.basin[i])) as u32);
            if drainage.is_endorheic(i) {
                palette::mix(color, CLOSED, 0.6)
            } else {
                color
            }
        }
        Overlay::Rivers | Overlay::Lakes => drainage
            .lake_kind(i)
            .map_or(backdrop, |kind| LAKE[kind as usize]),
        Overlay::Drainage | Overlay::Basins => backdrop,
        _ => field::NO_VALUE_LAND,
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::climate::EquirectMap;
    use crate::control::{BakeFrame, BakeRules, BakeSource};
    use crate::hydrology::TerrainMaps;
    use std::sync::Arc;

    /// A planet whose northern half is a slope down to the equator.
    pub(crate) fn bake() -> Bake {
        let crust = EquirectMap::from_fn(64, |lat, _| (lat / 30.0) as f32).unwrap();
        let maps = TerrainMaps {
            crust,
            age: None,
            plateau: None,
            hills: None,
        };
        let frame = Arc::new(BakeFrame::new(1, 0.04, None).unwrap());
        Bake::new(
            &frame,
            6370.0,
            &BakeSource::Maps(&maps),
            &BakeRules::default(),
        )
        .unwrap()
    }

    #[test]
    fn maps_show_the_sea_the_rivers_and_the_basins() {
        let bake = bake();
        let at = |raster: &Raster, x: u32, y: u32| {
            let k = 3 * (y * raster.width + x) as usize;
            [raster.rgb[k], raster.rgb[k + 1], raster.rgb[k + 2], 255]
        };
        let rivers = draw(Overlay::Rivers, &bake, 128, 64);
        assert_eq!(at(&rivers, 30, 50), SEA);
        let blue = (0..128)
            .flat_map(|x| (0..32).map(move |y| (x, y)))
            .filter(|&(x, y)| {
                let color = at(&rivers, x, y);
                (2..8).any(|order| color == rivers::order_color(order))
            });
        assert!(blue.count() > 100);
        let basins = draw(Overlay::Basins, &bake, 128, 64);
        let land = (0..128).flat_map(|x| (0..32).map(move |y| (x, y)));
        let colors: std::collections::BTreeSet<_> = land.map(|(x, y)| at(&basins, x, y)).collect();
        assert!(colors.len() > 5, "{}", colors.len());
        let warm = draw(Overlay::Temperature, &bake, 128, 64);
        assert!(
            at(&warm, 5, 32)[0] > at(&warm, 5, 1)[0],
            "the equator is redder than the pole"
        );
    }

    #[test]
    fn discharge_darkens_down_the_rivers_and_leaves_the_sea_plain() {
        let bake = bake();
        let colour = |i: u32| {
            color_at(
                Overlay::Drainage,
                &bake,
                &bake.mesh().locate(bake.mesh().point(i)),
            )
        };
        let darkness = |i: u32| -colour(i)[..3].iter().map(|&c| i32::from(c)).sum::<i32>();
        let routes = &bake.drainage.routes;
        let on_land =
            |i: &u32| *i != NO_VERTEX && bake.drainage.shore[*i as usize] == ShoreClass::Land;
        let streams = routes
            .order
            .iter()
            .filter(|&&i| on_land(&i) && on_land(&routes.receiver[i as usize]));
        let wrong = streams
            .clone()
            .filter(|&&i| darkness(i) > darkness(routes.receiver[i as usize]) + 1);
        assert!(
            streams.count() > 1000 && wrong.count() == 0,
            "no water is lost on the way down"
        );
        let sea = draw(Overlay::Drainage, &bake, 128, 64);
        assert!(
            sea.rgb[3 * 128 * 40..]
                .chunks(3)
                .all(|color| color == &SEA[..3])
        );
        let mouths: std::collections::BTreeSet<_> = sea.rgb[..3 * 128 * 32].chunks(3).collect();
        assert!(mouths.len() > 20, "{} colours", mouths.len());
    }

    #[test]
    fn the_ramp_of_discharge_ends_at_smaller_rivers_on_smaller_planets() {
        let powers = |radius| {
            discharge_decades(radius)
                .map(|(power, _)| power)
                .collect::<Vec<_>>()
        };
        assert_eq!(powers(EARTH_RADIUS), [0, 1, 2, 3, 4, 5]);
        assert_eq!(powers(EARTH_RADIUS / 100.0), [-4, -3, -2, -1, 0, 1]);
        assert_eq!(
            discharge_decades(EARTH_RADIUS).next().unwrap().1,
            palette::DISCHARGE.at(0.0)
        );
        let [amazon, beyond] = [200_000.0, 1e9].map(discharge_color);
        assert_eq!((amazon, beyond), (palette::DISCHARGE.at(1.0), amazon));
        assert_eq!(discharge_color(0.0), palette::DISCHARGE.at(0.0));
    }

    #[test]
    fn samples_have_the_colours_of_their_places() {
        let bake = bake();
        let lattice = SphereMesh::fibonacci(500).unwrap();
        for overlay in Overlay::ALL
            .into_iter()
            .filter(|overlay| is_baked(*overlay))
        {
            let colors = colors(overlay, &bake, &lattice);
            assert_eq!(colors.len(), 500);
            assert!(
                colors.iter().any(|color| *color != colors[0]),
                "{overlay:?}"
            );
        }
    }
}
