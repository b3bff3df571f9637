//! Times the ground on the CPU: `cargo run -p pangaea_shaders --example ground [DEPTH]`.

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

/// Radius of the planet, metres.
const RADIUS_M: f64 = 6_371_000.0;

/// Finest level.
const FINEST: u32 = 17;

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

    fn millis(&self) -> f64 {
        self.seconds() * 1e3
    }
}

fn unit(p: [f64; 3]) -> [i32; 3] {
    let n = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    p.map(|x| (x / n * f64::from(ONE)).round() as i32)
}

/// A random direction.
fn direction(k: u32) -> [i32; 3] {
    unit([0, 1, 2].map(|i| f64::from(share(pcg(k), i)) - 32_768.0))
}

/// A random step of a share of the radius.
fn step(from: [i32; 3], k: u32, share: f64) -> [i32; 3] {
    let by = direction(k);
    unit([0, 1, 2].map(|i| f64::from(from[i]) + f64::from(by[i]) * share))
}

/// A planet, the directions of its vertices on land, and the default rules.
struct TimedPlanet {
    base: Base,
    land: Vec<[i32; 3]>,
    rules: Rules,
}

impl TimedPlanet {
    fn new(base: Base) -> Self {
        let land = base.vertices.iter().filter(|v| v.height > 0);
        Self {
            land: land.map(|v| v.direction).collect(),
            base,
            rules: Rules::default(),
        }
    }

    fn on_land(&self, k: u32) -> [i32; 3] {
        self.land[pcg(k) as usize % self.land.len()]
    }
}

fn main() {
    let depth = std::env::args().nth(1).and_then(|a| a.parse().ok());
    let watch = Watch::start();
    let mesh = control_mesh(RADIUS_M as u32, depth.unwrap_or(7), 1);
    let vertices = mesh.vertices.len();
    println!(
        "control mesh: {vertices} vertices, {:.0} ms",
        watch.millis()
    );
    let watch = Watch::start();
    let base = match Base::new(&mesh) {
        Ok(base) => base,
        Err(error) => return println!("{error}"),
    };
    let bytes = size_of_val(&base.vertices[0]);
    println!("made ready: {:.0} ms, vertex {bytes} B", watch.millis());
    time_queries(&TimedPlanet::new(base));
}

fn time_queries(planet: &TimedPlanet) {
    let mut local = LocalGround::new(&planet.base, &planet.rules);
    random_points(&mut local, "anywhere", direction);
    random_points(&mut local, "on land", |k| step(planet.on_land(k), k, 0.003));
    fresh_points(planet);
    near_points(planet, &mut local);
    random_walks(planet, &mut local);
    patches(planet);
    for (altitude_m, sharpness) in [(2, 18), (1000, 24), (100_000, 32), (1_000_000, 48)] {
        view(planet, &mut local, altitude_m, sharpness);
    }
}

fn random_points(local: &mut LocalGround<&Base>, name: &str, place: impl Fn(u32) -> [i32; 3]) {
    const COUNT: u32 = 2000;
    let watch = Watch::start();
    let heights = (0..COUNT).map(|k| {
        let at = place(k);
        local.leaf(at, FINEST, None).height_m(at)
    });
    let mean = heights.sum::<f64>() / f64::from(COUNT);
    let micros = watch.millis() * 1e3 / f64::from(COUNT);
    println!("random point {name}: {micros:.1} us ({mean:.0} m)");
}

/// Vertices that a point needs if nothing near it is known.
fn fresh_points(planet: &TimedPlanet) {
    let mut sums = [0; 3];
    for k in 0..100 {
        let mut fresh = LocalGround::new(&planet.base, &planet.rules);
        fresh.leaf(direction(k), FINEST, None);
        let counts = fresh.lazy().counts();
        sums = [0, 1, 2].map(|i| sums[i] + counts[i]);
    }
    let means = sums.map(|s| s as f64 / 100.0);
    println!("vertices a fresh point needs: {means:?} pending, split, settled");
}

/// Points within 100 m of a centre, and the first of them.
fn near_points(planet: &TimedPlanet, local: &mut LocalGround<&Base>) {
    let [mut first, mut near] = [0.0, 0.0];
    for k in 0..200 {
        let aside = (pcg(k) >> 12) as i32 - (1 << 19);
        let centre = planet.on_land(k).map(|x| x.wrapping_add(aside));
        let watch = Watch::start();
        local.leaf(centre, FINEST, None);
        first += watch.millis();
        let watch = Watch::start();
        for j in 0..500 {
            let at = step(centre, 1000 + 500 * k + j, 100.0 / RADIUS_M);
            local.leaf(at, FINEST, None);
        }
        near += watch.millis();
    }
    let [first, near] = [first * 5.0, near / 100.0];
    println!("first at a centre: {first:.0} us; then within 100 m of it: {near:.2} us");
}

fn random_walks(planet: &TimedPlanet, local: &mut LocalGround<&Base>) {
    let mut walked = 0.0;
    for k in 0..20 {
        let mut at = planet.on_land(k + 70);
        local.leaf(at, FINEST, None);
        let watch = Watch::start();
        for j in 0..500 {
            at = step(at, 1000 + 500 * k + j, 100.0 / RADIUS_M);
            local.leaf(at, FINEST, None);
        }
        walked += watch.millis();
    }
    println!("random walk of 100 m steps: {:.1} us", walked / 10.0);
}

/// Discs that hold a square of 64 m.
fn patches(planet: &TimedPlanet) {
    for k in 0..4 {
        let view = View::disc(planet.on_land(k + 7), 46, FINEST);
        let watch = Watch::start();
        let ground = refine(&planet.base, &planet.rules, &view, &Caps::default());
        let vertices = carve_all(&ground.scale, &planet.rules, ground.vertices.grown()).len();
        let millis = watch.millis();
        let faces = ground.levels.last().map_or(0, |l| l.faces.len());
        println!("patch: {faces} finest faces, {vertices} vertices, {millis:.1} ms");
    }
}

/// A camera over the land.
fn view(planet: &TimedPlanet, local: &mut LocalGround<&Base>, altitude_m: i32, sharpness: u32) {
    let centre = planet.on_land(9);
    let height = local.leaf(centre, FINEST, None).carved[0].ground;
    let above_sea = (height / GRAINS + altitude_m).max(0) as u32;
    let view = View {
        sharpness: sharpness << 8,
        ..View::camera(&planet.base.scale, centre, above_sea, FINEST)
    };
    let watch = Watch::start();
    let ground = refine(&planet.base, &planet.rules, &view, &Caps::default());
    let refined = watch.millis();
    let vertices = carve_all(&ground.scale, &planet.rules, ground.vertices.grown()).len();
    let triangles = ground.triangles().len();
    let all = watch.millis();
    let rate = triangles as f64 / all / 1e3;
    let levels = ground.levels.len() - 1;
    println!(
        "view from {altitude_m} m: {triangles} triangles, {vertices} vertices, {levels} levels, \
         refine {refined:.1} ms, all {all:.1} ms, {rate:.2} M leaves/s"
    );
}
