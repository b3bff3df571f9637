//! Whole runs: the ground of a view, without a word read back between the passes.

use pangaea_shaders::amplify::base::Base;
use pangaea_shaders::amplify::fixed::{GRAINS, ONE, Q16};
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::rules::Rules;
use pangaea_shaders::amplify::synthetic::control_mesh;
use pangaea_shaders::gpu::GroundCaps;
use pangaea_tests::gpu::{WholeGround, assert_is_closed};
use pangaea_tests::grown::GrownPlanet;

/// Caps that no view here comes near to.
const ROOMY: GroundCaps = GroundCaps::for_leaves(300_000);

/// A camera over a place that looks all round.
fn camera(base: &Base, direction: [i32; 3], altitude: u32, sharpness: u32) -> View {
    View {
        sharpness: sharpness << 8,
        ..View::camera(&base.scale, direction, altitude, 17)
    }
}

/// Two metres over a river, over the pole in flight, and from orbit.
fn views(base: &Base) -> [View; 3] {
    let river = base.vertices.iter().find(|vertex| vertex.is_wet());
    let river = river.expect("a planet has a river");
    let over_river = (river.water.max(0) / GRAINS) as u32 + 3;
    let ahead = View {
        forward: [Q16, 0, 0],
        ..camera(base, [0, 0, ONE], 3_000, 60)
    };
    [
        camera(base, river.direction, over_river, 9),
        ahead,
        camera(base, [-ONE, 0, 0], base.scale.radius_m / 8, 30),
    ]
}

/// One ground runs for several views and rules: nothing of a run is left in the next.
#[test]
fn a_run_has_the_ground_of_the_cpu() {
    for radius_m in [50_000, 6_371_000, 10_000_000] {
        let base = Base::new(&control_mesh(radius_m, 4, 7)).expect("a sound mesh");
        let Some(ground) = WholeGround::new(&base, &ROOMY) else {
            return;
        };
        let views = views(&base);
        for rules in [Rules::default(), Rules::PAPER, Rules::RELEASE] {
            let triangles = views.map(|view| ground.assert_run(&view, &rules));
            // Mountains of the Earth on a planet of 50 km are steeper than a coarse view allows.
            let is_even = radius_m > 50_000;
            let closed = triangles.iter().skip(usize::from(!is_even));
            closed.for_each(|triangles| assert_is_closed(triangles));
        }
        // Coarse after fine.
        let coarse = ground.assert_run(&View::whole(0), &Rules::default());
        assert_eq!(coarse.len(), 5_120);
    }
}

#[test]
fn a_run_over_a_grown_planet_has_the_ground_of_the_cpu() {
    let planet = GrownPlanet::new(3, 3_000, 40);
    let base = planet.ground.base();
    let Some(ground) = WholeGround::new(base, &ROOMY) else {
        return;
    };
    for view in views(base) {
        assert_is_closed(&ground.assert_run(&view, &Rules::default()));
    }
}

/// A level that the buffers do not hold is not split: the surface stays whole, and what is coarser
/// has the bits that it always has.
#[test]
fn at_a_cap_the_ground_stays_whole() {
    let base = Base::new(&control_mesh(6_371_000, 4, 7)).expect("a sound mesh");
    let [_, view, _] = views(&base);
    let Some(roomy) = WholeGround::new(&base, &ROOMY) else {
        return;
    };
    let rules = Rules::default();
    let all = roomy.run(&view, &rules);
    let tight = |caps| {
        WholeGround::new(&base, &caps)
            .expect("an adapter")
            .run(&view, &rules)
    };
    let made = (all.vertices - base.vertices.len()) as u32;
    let caps = [
        GroundCaps {
            vertices: made / 2,
            ..ROOMY
        },
        GroundCaps {
            faces: 3_000,
            ..ROOMY
        },
        GroundCaps {
            edges: 4_000,
            ..ROOMY
        },
        GroundCaps {
            triangles: all.triangles.len() as u32 / 2 - 5_120,
            ..ROOMY
        },
    ];
    for caps in caps {
        let found = tight(caps);
        assert_is_closed(&found.triangles);
        assert!(found.vertices < all.vertices && found.vertices > base.vertices.len());
        assert!(found.triangles.len() < all.triangles.len());
    }
    // All that there is has room.
    let enough = GroundCaps {
        vertices: made,
        ..ROOMY
    };
    assert_eq!(tight(enough).triangles, all.triangles);
}
