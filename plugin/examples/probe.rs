//! dev probe
use bevy::prelude::*;
use bevy_pangaea::crust::{Surface, Ledger, Cause};
use bevy_pangaea::prelude::*;
use bevy_pangaea::schedule::{StageTimings, run_steps, Stage};
use bevy_pangaea::spawn::PlanetState;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let seed: u64 = a[1].parse().unwrap();
    let samples: u32 = a[2].parse().unwrap();
    let until: u64 = a[3].parse().unwrap();
    let every: u64 = a[4].parse().unwrap();
    let mut recipe = PlanetRecipe { seed, samples, ..default() };
    for kv in std::env::var("PARAMS").unwrap_or_default().split(',').filter(|s| !s.is_empty()) { let (k, v) = kv.split_once('=').unwrap(); recipe.params.set(k, v.parse().unwrap()).unwrap(); }
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    app.add_observer(|e: On<TerraneCollided>| println!("  collision {:?}->{:?} {:.0} km2 v {:.0}", e.from, e.to, e.area, e.speed));
    app.add_observer(|e: On<PlateRifted>| println!("  rift {:?} -> {:?}", e.parent, e.fragments));
    app.add_observer(|e: On<PlateConsumed>| println!("  consumed {:?}", e.plate));
    app.add_observer(|e: On<CrustResampled>| println!("  resampled, new ocean {:.2e}", e.new_ocean));
    let world = app.world_mut();
    let t = std::time::Instant::now();
    let planet = PlanetState::new(&recipe).unwrap().spawn(world);
    println!("made in {:?}", t.elapsed());
    let mut done = 0;
    loop {
        bevy_pangaea::resample::project_now(world, planet);
        { let c = world.get::<bevy_pangaea::plate::contact::Contacts>(planet).unwrap(); let mut h = [0usize; 5]; for c in &c.0 { h[c.role as usize] += 1; } println!("  roles {h:?} since {}", world.get::<GeologicClock>(planet).unwrap().since_resample); }
        let s = world.get::<Surface>(planet).unwrap();
        let mesh = world.get::<Lattice>(planet).unwrap();
        let n = s.len();
        let land = (0..n).filter(|&i| s.elevation(i) > 0.0).count() as f64 / n as f64;
        let cont = (0..n).filter(|&i| s.crust.is_continental(i)).count() as f64 / n as f64;
        let max = (0..n).map(|i| s.elevation(i)).fold(f32::MIN, f32::max);
        let min = (0..n).map(|i| s.elevation(i)).fold(f32::MAX, f32::min);
        let age = (0..n).filter(|&i| !s.crust.is_continental(i)).map(|i| s.crust.ocean_age[i] as f64).sum::<f64>() / ((1.0-cont)*n as f64);
        let np = world.get::<Plates>(planet).unwrap().iter().count();
        let hyp: Vec<usize> = { let mut h = vec![0usize; 22]; for i in 0..n { h[((s.elevation(i) + 11.0).clamp(0.0, 21.9)) as usize] += 1; } h }; println!("  hyp {:?}", hyp.iter().map(|c| c * 1000 / n).collect::<Vec<_>>()); println!("{:5.0} My plates {np} land {:.3} cont {:.3} z {:.2}..{:.2} oage {:.0}", s.time, land, cont, min, max, age);
        // map
        let (w, h) = (1024usize, 512usize);
        let mut img = vec![0u8; w*h*3];
        let light = |p: bevy::math::DVec3| s.at(mesh, p).elevation as f64;
        for y in 0..h { for x in 0..w {
            let lat = 90.0 - (y as f64 + 0.5) / h as f64 * 180.0;
            let lon = (x as f64 + 0.5) / w as f64 * 360.0 - 180.0;
            let p = bevy_pangaea::math::direction(lat, lon);
            let z = light(p);
            let zx = light(bevy_pangaea::math::direction(lat, lon - 0.35));
            let shade = (1.0 + (z - zx) * 0.25).clamp(0.5, 1.5);
            let c = if z < 0.0 { let t = (1.0 + z / 8.0).clamp(0.0, 1.0); [20.0 + 60.0 * t * t, 40.0 + 120.0 * t, 90.0 + 130.0 * t] }
              else if z < 1.0 { [90.0 + 90.0 * z, 150.0 + 20.0 * z, 80.0 + 20.0 * z] }
              else if z < 4.0 { let t = (z - 1.0) / 3.0; [180.0 - 40.0 * t, 170.0 - 70.0 * t, 100.0 - 40.0 * t] }
              else { let t = ((z - 4.0) / 5.0).min(1.0); [140.0 + 110.0 * t, 100.0 + 150.0 * t, 60.0 + 190.0 * t] };
            for k in 0..3 { img[(y*w+x)*3+k] = (c[k] * shade).clamp(0.0, 255.0) as u8; }
            let i = mesh.nearest(p);
            if mesh.ring(i).iter().any(|&j| s.plate[j as usize] != s.plate[i as usize]) && a.len() > 5 { img[(y*w+x)*3] = 220; img[(y*w+x)*3+1] /= 2; }
        }}
        let f = std::fs::File::create(format!("/tmp/dev/m{seed}_{:04}.png", s.time as u32)).unwrap();
        let mut e = png::Encoder::new(std::io::BufWriter::new(f), w as u32, h as u32);
        e.set_color(png::ColorType::Rgb); e.set_depth(png::BitDepth::Eight);
        e.write_header().unwrap().write_image_data(&img).unwrap();
        if done >= until { break; }
        run_steps(world, planet, every);
        done += every;
    }
    let t = world.get::<StageTimings>(planet).unwrap();
    println!("step mean {:.2} ms max {:.2}; resample {:?}; rift {:?}", t.step_mean_ms(), t.step_max_ms, (t.resample.0, t.resample.1 / t.resample.0.max(1) as f64), (t.rift.0, t.rift.1 / t.rift.0.max(1) as f64));
    for s in Stage::ALL { println!("  {:10} {:.3}", s.name(), t.total_ms[s as usize] / t.steps as f64); }
    let l = world.get::<Ledger>(planet).unwrap();
    for c in Cause::ALL { let a = l.of(c); println!("  {:18} area {:+.3e} ({:+.4}) volume {:+.3e} ({:+.4})", c.name(), a.area, a.area / l.initial.area, a.volume, a.volume / l.initial.volume); }
    println!("unexplained {:e} {:e}", l.unexplained_max, l.unexplained_volume_max);
}
