//! Bits of how far ground counts as lying from a view, and the layout of its uniform.

use naga::TypeInner;
use pangaea_shaders::amplify::fixed::{ONE, Q16};
use pangaea_shaders::amplify::scale::PlanetScale;
use pangaea_shaders::amplify::sight::Sight;
use pangaea_shaders::amplify::twins::MODULES;
use pangaea_shaders::amplify::vertex::Vertex;
use pangaea_shaders::amplify::view::View;
use pangaea_shaders::wgsl::compose;
use pangaea_tests::gpu::{Words, assert_twin, parsed};

const SIGHT: &str = "amplify/sight";

type Vector = [i32; 3];

/// A view of a planet of 50 to 10,000 km: a disc, a square, or a camera that looks somewhere.
#[derive(Clone, Debug)]
struct AnySight {
    scale: PlanetScale,
    view: View,
}

impl AnySight {
    fn sight(&self) -> Sight {
        Sight::new(&self.scale, &self.view)
    }
}

impl Words for AnySight {
    const COUNT: usize = 28;

    fn write(&self, words: &mut Vec<u32>) {
        words.extend(self.sight().words());
    }

    fn read(words: &mut impl Iterator<Item = u32>) -> Self {
        let scale = planet(50_000 + u32::read(words) % 9_950_000);
        let kind = u32::read(words) % 4;
        let radius = i32::read(words) & 0xfff_ffff;
        let [first, second, forward] = <[Vector; 3]>::read(words).map(unit_q16);
        let whole = View::whole(u32::read(words) % 18);
        let direction = <Vector>::read(words).map(|x| x.clamp(-ONE, ONE));
        let altitude = i32::read(words) >> 1;
        let horizon = i32::read(words) & i32::MAX;
        let view = View {
            direction,
            altitude: (kind >= 2).then_some(altitude),
            radius: if kind < 2 { radius } else { 0 },
            sides: if kind == 1 {
                [first, second]
            } else {
                [[0; 3]; 2]
            },
            forward: if kind == 3 { forward } else { [0; 3] },
            field: i32::read(words) % Q16,
            outside: u32::read(words) % (16 << 8),
            sharpness: u32::read(words) % (300 << 8),
            horizon,
            ..whole
        };
        Self { scale, view }
    }
}

/// The scale of a planet whose control mesh has edges of 0.8 % of the radius.
fn planet(radius_m: u32) -> PlanetScale {
    let unit = f64::from(radius_m) / f64::from(ONE) * f64::from(1_u32 << 20);
    PlanetScale {
        radius_m,
        grains_per_unit: (unit * 1024.0) as u32,
        sixteenths_per_four: (unit * 64.0) as u32,
        edge: radius_m / 1000 * 128,
    }
}

/// The direction of a vector, Q16.
fn unit_q16(v: Vector) -> Vector {
    let real = v.map(f64::from);
    let size = real.iter().map(|x| x * x).sum::<f64>().sqrt().max(1.0);
    real.map(|x| (x / size * 65_536.0) as i32)
}

/// Places and heights of a face's corners, up to 4 km beside one another on Earth.
type Corners = [(Vector, i32); 3];

fn face(corners: Corners) -> Corners {
    let first = corners[0].0.map(|x| x.clamp(-ONE, ONE) >> 1 << 1);
    corners.map(|(offset, height)| {
        let place = [0, 1, 2].map(|i| first[i].saturating_add(offset[i] >> 11));
        (place, height)
    })
}

fn vertices(corners: Corners) -> [Vertex; 3] {
    corners.map(|(direction, height)| Vertex {
        direction,
        height,
        ..Vertex::default()
    })
}

type Seen = (AnySight, Corners);

fn seen((sight, corners): Seen) -> Option<Seen> {
    Some((sight, face(corners)))
}

#[test]
fn distances_of_faces_have_the_same_bits() {
    assert_twin(SIGHT, "sight_distance", seen, |(any, corners)| {
        any.sight().distance(vertices(corners).each_ref())
    });
    assert_twin(SIGHT, "sight_weighted", seen, |(any, corners)| {
        any.sight().weighted(vertices(corners).each_ref())
    });
}

#[test]
fn splits_of_faces_are_the_same() {
    type Input = (AnySight, u32, Corners);
    let input = |(sight, level, corners): Input| Some((sight, level % 17, face(corners)));
    assert_twin(SIGHT, "sight_splits", input, |(any, level, corners)| {
        any.sight().splits(level, vertices(corners).each_ref())
    });
}

#[test]
fn the_uniform_of_a_view_has_the_layout_of_its_words() {
    let module = parsed(SIGHT, &compose(&MODULES, &[SIGHT]));
    for (name, words) in [("PlanetScale", 4), ("View", 20), ("Sight", 28)] {
        let mut types = module.types.iter().map(|(_, ty)| ty);
        let ty = types
            .find(|ty| ty.name.as_deref() == Some(name))
            .expect(name);
        let TypeInner::Struct { members, span } = &ty.inner else {
            panic!("{name} is no struct");
        };
        assert_eq!(*span, 4 * words, "{name}");
        let mut end = 0;
        for member in members {
            assert_eq!(
                member.offset, end,
                "{name} has a hole before {:?}",
                member.name
            );
            end += module.types[member.ty].inner.size(module.to_ctx());
        }
        assert_eq!(end, *span, "{name} has a hole at its end");
    }
}
