//! Bits of the passes that mark, count, place and grow a level, each alone, and of the triangles.

use fastrand::Rng;
use pangaea_shaders::amplify::base::Base;
use pangaea_shaders::amplify::fixed::{GRAINS, ONE, Q16};
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::rows::LevelSizes;
use pangaea_shaders::amplify::rules::{EdgeKind, Rules};
use pangaea_shaders::amplify::scale::PlanetScale;
use pangaea_shaders::amplify::sight::Sight;
use pangaea_shaders::amplify::synthetic::control_mesh;
use pangaea_shaders::amplify::topology::{
    Edge, Face, FaceSplit, Items, Level, LevelMesh, NONE, SplitMark,
};
use pangaea_tests::gpu::{
    MarkedLevel, PassCase, assert_chains, assert_pass, assert_run, pass_times,
};
use pangaea_tests::soak;
use std::sync::Arc;

/// Radii of planets, metres: the least, Earth's, the greatest.
const RADII_M: [u32; 3] = [50_000, 6_371_000, 10_000_000];

/// A planet of 1280 faces.
fn planet(radius_m: u32) -> Base {
    Base::new(&control_mesh(radius_m, 3, 7)).expect("a sound mesh")
}

/// Cameras near and far: over a river, over a pole, over the date line, and from orbit.
fn cameras(base: &Base) -> [View; 4] {
    let river = base.vertices.iter().find(|vertex| vertex.is_wet());
    let river = river.expect("a planet has a river");
    // 2 m over its water, in whole metres.
    let over_river = (river.water / GRAINS) as u32 + 3;
    let radius = base.scale.radius_m;
    let camera = |direction, altitude, sharpness: u32| View {
        sharpness: sharpness << 8,
        ..View::camera(&base.scale, direction, altitude, 17)
    };
    let ahead = View {
        forward: [Q16, 0, 0],
        sharpness: 40 << 8,
        level: 12,
        ..camera([0, 0, ONE], 300, 40)
    };
    [
        camera(river.direction, over_river, 8),
        ahead,
        camera([-ONE, 0, 0], radius / 500, 12),
        camera([0, -ONE, 0], radius / 3, 60),
    ]
}

/// Every pass at every level, under all rules.
#[test]
fn passes_have_the_same_words_as_their_twins() {
    let rules = [Rules::default(), Rules::PAPER, Rules::RELEASE];
    let mut finest = 0;
    for (i, radius_m) in RADII_M.into_iter().enumerate() {
        let base = planet(radius_m);
        for (j, view) in cameras(&base).iter().enumerate() {
            let [levels, passes] = assert_run(&base, &rules[(i + j) % 3], view);
            assert!(
                levels > 2 && passes >= 10 * (levels - 1),
                "{levels} {passes}"
            );
            finest = finest.max(levels);
        }
    }
    assert_eq!(finest, 18);
}

/// A disc and a square, which measure along the ground; all faces split, and none.
#[test]
fn passes_have_the_same_words_for_discs_and_whole_levels() {
    let base = planet(6_371_000);
    let at = base.vertices[7].direction;
    let sides = [[Q16, 0, 0], [0, Q16, 0]];
    let views = [
        View::disc(at, 500, 13),
        View::square([0, 0, ONE], sides, 300, 14),
        View::whole(3),
        View::whole(0),
    ];
    let levels = views.map(|view| assert_run(&base, &Rules::default(), &view)[0]);
    assert_eq!(levels, [14, 15, 4, 1]);
}

/// All passes from marks to places in one submission, with groups that the passes count themselves.
#[test]
fn a_level_is_marked_and_placed_as_one() {
    for radius_m in RADII_M {
        let base = planet(radius_m);
        let [near, _, far, _] = cameras(&base);
        for view in [near, far, View::whole(2)] {
            assert_chains(&base, &Rules::default(), &view);
        }
    }
}

/// Edges and faces that hang together anyhow.
fn anyhow(random: &mut Rng, count: u32) -> LevelMesh {
    let edge = |random: &mut Rng| {
        let face = |random: &mut Rng| match random.u32(..8) {
            0 => NONE,
            _ => random.u32(..count),
        };
        Edge::new(EdgeKind::River, [1, 2], [face(random), face(random)])
    };
    let edges: Vec<Edge> = (0..count).map(|_| edge(random)).collect();
    let faces = (0..count).map(|_| Face {
        vertices: [3, 4, 5],
        edges: [0; 3].map(|_: u32| random.u32(..count)),
    });
    let faces = faces.collect();
    LevelMesh { edges, faces }
}

/// Levels that are empty, end just before, at and after a block, and have more blocks than a group
/// has items.
#[test]
fn levels_of_any_size_are_counted_and_placed() {
    let mut random = Rng::with_seed(3);
    let scale = PlanetScale::new(&control_mesh(6_371_000, 2, 1));
    let sight = Sight::new(&scale, &View::whole(17));
    for count in [0, 1, 255, 256, 257, 511, 513, 5_000, 140_000] {
        // None is split, few are, half, all.
        for share in [0, 8, 128, 256] {
            let mesh = Arc::new(anyhow(&mut random, count));
            let items = Items::all(&mesh);
            let mut level = Level::new(mesh, items);
            let split = |face: &mut FaceSplit| {
                if random.u32(..256) < share {
                    face.mark = SplitMark::Split;
                }
            };
            level.faces.iter_mut().for_each(split);
            let sizes = LevelSizes {
                edges: count,
                faces: count,
                first_vertex: 1_000,
                first_triangle: 77,
                ..LevelSizes::default()
            };
            let mut marked = MarkedLevel::new(&sight, Rules::default(), 5, sizes, &mut level);
            let [halved, decided] = marked.place(&mut |case: &PassCase| assert_pass(case));
            let [halved, decided] = [halved, decided].map(|list| list.len() as u32);
            match share {
                0 => assert_eq!([halved, decided], [0, 0]),
                256 => assert_eq!(decided, count),
                _ => assert!(halved <= count && decided <= count),
            }
        }
    }
}

/// Passes of levels as large as a picture needs; tells how long they take.
#[test]
fn passes_of_large_levels_have_the_same_words() {
    if !soak::is_on() {
        return;
    }
    let base = Base::new(&control_mesh(6_371_000, 6, 7)).expect("a sound mesh");
    let [near, ..] = cameras(&base);
    let view = View {
        sharpness: 40 << 8,
        ..near
    };
    let [levels, _] = assert_run(&base, &Rules::default(), &view);
    assert_eq!(levels, 18);
    println!("{}", pass_times());
}
