//! Times the ground on the CPU: `cargo run --release -p pangaea_shaders --example ground [DEPTH]`.

use pangaea_shaders::amplify::base::Base;
use pangaea_shaders::amplify::carve::carve_all;
use pangaea_shaders::amplify::fixed::{GRAINS, ONE};
use pangaea_shaders::amplify::ground::{Caps, refine};
use pangaea_shaders::amplify::local::LocalGround;
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::rules::Rules;
use pangaea_shaders::amplify::seed::{pcg, share};
use pangaea_shaders::amplify::synthetic::control_mesh;
use std::time::Instant;

/// Seconds of processor time on Linux, of the clock elsewhere; other programs do not count.
struct Watch(Instant, Option<u64>);

impl Watch {
    fn start() -> Self {
        Self(Instant::now(), Self::processor())
    }

    fn processor() -> Option<u64> {
        let text = std::fs::read_to_string("/proc/self/schedstat").ok()?;
        text.split_whitespace().next()?.parse().ok()
    }

    fn seconds(&self) -> f64 {
        match (self.1, Self::processor()) {
            (Some(start), Some(end)) => (end - start) as f64 * 1e-9,
            _ => self.0.elapsed().as_secs_f64(),
        }
    }
}

fn unit(p: [f64; 3]) -> [i32; 3] {
    let n = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    p.map(|x| (x / n * f64::from(ONE)).round() as i32)
}

fn direction(k: u32) -> [i32; 3] {
    unit([0, 1, 2].map(|i| f64::from(share(pcg(k), i)) - 32_768.0))
}

fn main() {
    let depth = std::env::args()
        .nth(1)
        .and_then(|a| a.parse().ok())
        .unwrap_or(7);
    let start = Watch::start();
    let mesh = control_mesh(6_371_000, depth, 1);
    println!(
        "control mesh: {} vertices, {:.0} ms",
        mesh.vertices.len(),
        start.seconds() * 1e3
    );
    let start = Watch::start();
    let base = match Base::new(&mesh) {
        Ok(base) => base,
        Err(error) => return println!("{error}"),
    };
    println!(
        "made ready: {:.0} ms, vertex {} B",
        start.seconds() * 1e3,
        size_of_val(&base.vertices[0])
    );
    let rules = Rules::default();
    let land: Vec<_> = base
        .vertices
        .iter()
        .filter(|v| v.height > 0)
        .map(|v| v.direction)
        .collect();
    let mut local = LocalGround::new(&base, &rules);
    for (name, all_land) in [("anywhere", false), ("on land", true)] {
        let n = 2000;
        let start = Watch::start();
        let mut sum = 0.0;
        for k in 0..n {
            let at = direction(k);
            let at = if all_land {
                let v = land[pcg(k) as usize % land.len()];
                unit([0, 1, 2].map(|i| f64::from(v[i]) + f64::from(direction(k)[i]) * 0.003))
            } else {
                at
            };
            sum += local.leaf(at, 17, None).height_m(at);
        }
        println!(
            "random point {name}: {:.1} us ({:.0} m)",
            start.seconds() * 1e6 / f64::from(n),
            sum / f64::from(n)
        );
    }
    let mut sums = [0; 3];
    for k in 0..100 {
        let mut fresh = LocalGround::new(&base, &rules);
        fresh.leaf(direction(k), 17, None);
        let counts = fresh.lazy().counts();
        sums = [0, 1, 2].map(|i| sums[i] + counts[i]);
    }
    println!(
        "vertices a fresh point needs: {:?} pending, split, settled",
        sums.map(|s| s as f64 / 100.0)
    );
    let (mut cold, mut near) = (0.0, 0.0);
    for k in 0..200 {
        let centre = land[pcg(k) as usize % land.len()]
            .map(|x| x.wrapping_add((pcg(k) >> 12) as i32 - (1 << 19)));
        let watch = Watch::start();
        local.leaf(centre, 17, None);
        cold += watch.seconds();
        let watch = Watch::start();
        for j in 0..500 {
            let step = direction(1000 + 500 * k + j).map(|x| f64::from(x) * 100.0 / 6_371_000.0);
            let at = unit([0, 1, 2].map(|i| f64::from(centre[i]) + step[i]));
            local.leaf(at, 17, None);
        }
        near += watch.seconds();
    }
    println!(
        "first at a centre: {:.0} us; then within 100 m of it: {:.2} us",
        cold * 5e3,
        near * 10.0
    );
    let mut walked = 0.0;
    for k in 0..20 {
        let mut at = land[pcg(k + 70) as usize % land.len()];
        local.leaf(at, 17, None);
        let watch = Watch::start();
        for j in 0..500 {
            let step = direction(1000 + 500 * k + j).map(|x| f64::from(x) * 100.0 / 6_371_000.0);
            at = unit([0, 1, 2].map(|i| f64::from(at[i]) + step[i]));
            local.leaf(at, 17, None);
        }
        walked += watch.seconds();
    }
    println!("random walk of 100 m steps: {:.1} us", walked * 100.0);
    for k in 0..4 {
        let centre = land[pcg(k + 7) as usize % land.len()];
        let start = Watch::start();
        // A square of 64 m lies in a disc of 46 m.
        let ground = refine(&base, &rules, &View::disc(centre, 46, 17), &Caps::default());
        let carved = carve_all(&ground.scale, &ground.vertices);
        let time = start.seconds() * 1e3;
        let finest = ground.levels.last().map_or(0, |l| l.faces.len());
        println!(
            "patch: {} finest faces, {} vertices, {time:.1} ms",
            finest,
            carved.len()
        );
    }
    for (altitude, sharpness) in [(2, 18), (1000, 24), (100_000, 32), (1_000_000, 48)] {
        let centre = land[pcg(9) as usize % land.len()];
        let height = local.leaf(centre, 17, None).carved[0].ground;
        let horizon =
            ((2.0 * 6_371_000.0 * (f64::from(altitude) + 9000.0)).sqrt() * 16.0).min(2e9) as i32;
        let view = View {
            direction: centre,
            altitude: Some(height + altitude * GRAINS),
            radius: 0,
            sides: [[0; 3]; 2],
            sharpness: sharpness << 8,
            level: 17,
            horizon,
        };
        let start = Watch::start();
        let ground = refine(&base, &rules, &view, &Caps::default());
        let refined = start.seconds() * 1e3;
        let carved = carve_all(&ground.scale, &ground.vertices);
        let triangles = ground.triangles();
        let time = start.seconds() * 1e3;
        println!(
            "view from {altitude} m: {} triangles, {} vertices, {} levels, refine {refined:.1} ms, all {time:.1} ms, {:.2} M leaves/s",
            triangles.len(),
            carved.len(),
            ground.levels.len() - 1,
            triangles.len() as f64 / time / 1e3
        );
    }
}
