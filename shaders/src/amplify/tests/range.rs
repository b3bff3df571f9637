//! 32 bits are never left, whatever a sound control mesh holds. Run with overflow checks and debug
//! assertions, every wrapped sum and product fails here.

use crate::amplify::base::Base;
use crate::amplify::carve::{Carved, NO_WATER, carve_all};
use crate::amplify::control::{ControlMesh, ControlVertex, VertexKind};
use crate::amplify::emit;
use crate::amplify::fixed::metres;
use crate::amplify::ground::{Caps, refine};
use crate::amplify::local::LocalGround;
use crate::amplify::mark::View;
use crate::amplify::rules::Rules;
use crate::amplify::seed::{draw, pcg};
use crate::amplify::synthetic::control_mesh;
use crate::amplify::vertex::Vertex;

/// Most height and depth of a control mesh, grains.
const MOST: u32 = metres(100_000) as u32;

fn extreme_height(seed: u32, k: u32) -> i32 {
    match draw(seed, k) % 4 {
        0 => MOST as i32,
        1 => -(MOST as i32),
        _ => (draw(seed, k + 50) % (2 * MOST)) as i32 - MOST as i32,
    }
}

fn extreme_share(seed: u32, k: u32) -> u16 {
    match draw(seed, k) % 4 {
        0 => 0,
        1 => u16::MAX,
        _ => draw(seed, k + 50) as u16,
    }
}

/// A vertex of any kind with any maps that a mesh may have; extremes are frequent.
fn extreme(vertex: ControlVertex, seed: u32) -> ControlVertex {
    let signed = |k| extreme_height(seed, k);
    let unsigned = |k| extreme_share(seed, k);
    let kind = VertexKind::from_number((draw(seed, 0) % 6) as u8);
    let height = match kind {
        VertexKind::Sea => -signed(1).abs(),
        VertexKind::Coast => 0,
        _ => signed(1),
    };
    let tangent = |k: u32| [0, 1, 2].map(|i| draw(seed, k + i) as i16);
    ControlVertex {
        direction: vertex.direction,
        seed,
        height,
        bed: signed(2),
        water: signed(3),
        flow: u32::from(unsigned(4)),
        crust: signed(5),
        kind: kind as u8,
        valley: draw(seed, 6) as u8,
        worn: unsigned(7),
        collision: unsigned(8),
        wetness: unsigned(9),
        plateau: unsigned(10),
        hills: unsigned(11),
        oceanic: unsigned(12),
        ocean_age: unsigned(13),
        fold: tangent(20),
        ridge: tangent(30),
    }
}

/// The rivers of a made-up planet under extreme maps.
fn mesh(radius_m: u32, depth: u32, seed: u32) -> ControlMesh {
    let mut mesh = control_mesh(radius_m, depth, seed);
    for (i, vertex) in (0..).zip(&mut mesh.vertices) {
        *vertex = extreme(*vertex, pcg(pcg(i) ^ seed));
    }
    mesh
}

#[test]
fn extreme_control_meshes_stay_within_32_bits() {
    for (radius_m, depth) in [
        (50_000, 3),
        (50_000, 5),
        (6_371_000, 5),
        (10_000_000, 3),
        (10_000_000, 5),
    ] {
        for seed in 0..3 {
            let base = Base::new(&mesh(radius_m, depth, seed)).unwrap();
            for rules in [Rules::default(), Rules::PAPER, Rules::RELEASE] {
                check(&base, &rules, seed);
            }
        }
    }
}

fn check(base: &Base, rules: &Rules, seed: u32) {
    let mut local = LocalGround::new(base, rules);
    for k in 0..60 {
        let [v, w] = [k, k + 99].map(|k| {
            let v = pcg(pcg(k) ^ seed) as usize % base.vertices.len();
            base.vertices[v].direction
        });
        let leaf = local.leaf([0, 1, 2].map(|i| v[i] + w[i] / 64), 17, None);
        assert!(leaf.carved.iter().all(|c| c.water >= NO_WATER));
        assert!(leaf.carved.iter().zip(&leaf.vertices).all(holds_water));
    }
    let at = base.vertices[seed as usize].direction;
    let view = View::disc(at, base.scale.radius_m / 500, 8);
    let ground = refine(base, rules, &view, &Caps::default());
    let carved = carve_all(&base.scale, rules, &ground.vertices);
    let water = emit::water(&ground, rules, &ground.triangles(), &carved);
    assert!(water.iter().flat_map(|t| t.water).all(|w| w > NO_WATER));
    assert!(carved.iter().zip(&ground.vertices).all(holds_water));
}

/// Whether wet ground lies under water.
fn holds_water((carved, vertex): (&Carved, &Vertex)) -> bool {
    !vertex.is_wet() || carved.water >= carved.ground
}
