//! Pictures of the globe, without a window and of one. They need a Vulkan adapter, lavapipe
//! included: without one the tests say SKIPPED, or fail where `PANGAEA_GPU=require`. The window
//! needs the X server Xvfb besides.

use std::fs::{self, File};
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

fn pangaea(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_pangaea"));
    command.current_dir(folder).args(args);
    command
}

/// Whether the program could draw. Fails unless the reason why not is a missing adapter.
fn drew(output: &Output) -> bool {
    let text = String::from_utf8_lossy(&output.stderr);
    if output.status.success() {
        return true;
    }
    assert!(text.contains("no GPU adapter"), "{text}");
    assert!(
        std::env::var("PANGAEA_GPU").as_deref() != Ok("require"),
        "{text}"
    );
    eprintln!("SKIPPED: {text}");
    false
}

/// A picture as it was read from a file.
struct DecodedPicture {
    width: usize,
    height: usize,
    rgb: Vec<u8>,
}

impl DecodedPicture {
    fn read(path: &Path) -> Self {
        let file = BufReader::new(File::open(path).unwrap());
        let mut reader = png::Decoder::new(file).read_info().unwrap();
        let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut rgb).unwrap();
        assert_eq!(info.color_type, png::ColorType::Rgb);
        assert_eq!(info.bit_depth, png::BitDepth::Eight);
        Self {
            width: info.width as usize,
            height: info.height as usize,
            rgb,
        }
    }

    fn brightness(&self, x: usize, y: usize) -> u32 {
        let at = 3 * (y * self.width + x);
        let pixel = &self.rgb[at..at + 3];
        pixel.iter().map(|&channel| u32::from(channel)).sum()
    }

    /// Share of pixels that are not space.
    fn lit(&self) -> f64 {
        let all = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        let lit = all.filter(|&(x, y)| self.brightness(x, y) > 60).count();
        lit as f64 / (self.width * self.height) as f64
    }
}

/// A folder with g/planet.pangaea in it.
fn grown() -> TempDir {
    let folder = TempDir::new().unwrap();
    let size = ["generate", "--samples", "3000", "--plates", "12"];
    let args = [&size[..], &["--until", "20", "--out", "g"]].concat();
    assert!(pangaea(folder.path(), &args).status().unwrap().success());
    folder
}

/// A picture of the planet of [`grown`], `None` where there is no adapter.
fn draw(folder: &TempDir, name: &str, more: &[&str]) -> Option<DecodedPicture> {
    let size = ["render", "g/planet.pangaea", "--size", "320x180"];
    let args = [&size[..], &["--out", name], more].concat();
    let output = pangaea(folder.path(), &args).output().unwrap();
    drew(&output).then(|| DecodedPicture::read(&folder.path().join(name)))
}

#[test]
fn a_globe_floats_in_the_middle_of_space() {
    let folder = grown();
    let Some(globe) = draw(&folder, "a.png", &[]) else {
        return;
    };
    assert_eq!((globe.width, globe.height), (320, 180));
    for (x, y) in [(0, 0), (319, 0), (0, 179), (319, 179)] {
        assert!(globe.brightness(x, y) < 45, "space is bright at {x},{y}");
    }
    assert!(globe.brightness(160, 90) > 90, "the middle is dark");
    assert!((0.04..0.6).contains(&globe.lit()), "{}", globe.lit());
}

#[test]
fn a_picture_is_the_same_twice_and_another_with_other_options() {
    let folder = grown();
    let Some(globe) = draw(&folder, "a.png", &[]) else {
        return;
    };
    let again = draw(&folder, "b.png", &[]).unwrap();
    assert!(again.rgb == globe.rgb);
    let plates = draw(&folder, "c.png", &["--overlay", "plates"]).unwrap();
    assert!(plates.rgb != globe.rgb);
    assert!((plates.lit() - globe.lit()).abs() < 0.1);
    // From low above the ground the planet fills the picture.
    let near = draw(&folder, "d.png", &["--camera", "10,20,900000"]).unwrap();
    assert!(near.lit() > 0.95, "{}", near.lit());
}

/// Asserts that a command names the missing adapter and its cure, and writes nothing.
#[cfg(target_os = "linux")]
fn assert_needs_adapter(command: &str, out: &str) {
    let folder = TempDir::new().unwrap();
    let size = [command, "--samples", "500", "--plates", "8"];
    let args = [&size[..], &["--until", "4", "--out", out]].concat();
    const NO_DRIVERS: [(&str, &str); 3] = [
        ("VK_ICD_FILENAMES", "/nowhere.json"),
        ("VK_DRIVER_FILES", "/nowhere.json"),
        ("VK_LOADER_DRIVERS_DISABLE", "*"),
    ];
    let mut program = pangaea(folder.path(), &args);
    let output = program.envs(NO_DRIVERS).output().unwrap();
    let text = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("no GPU adapter"), "{text}");
    assert!(text.contains("mesa-vulkan-drivers"), "{text}");
    let left = fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(left, 0, "{command} left files behind");
}

#[cfg(target_os = "linux")]
#[test]
fn without_an_adapter_the_reason_and_the_cure_are_printed_and_nothing_is_written() {
    assert_needs_adapter("render", "a.png");
    assert_needs_adapter("views", "folder/for/views");
}

/// An X server without a screen, which ends with the test.
struct Display {
    server: Child,
    name: String,
}

impl Display {
    /// `None` where there is no Xvfb.
    fn open() -> Option<Self> {
        let mut server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "1280x720x24"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .ok()?;
        let mut number = String::new();
        BufReader::new(server.stdout.take()?)
            .read_line(&mut number)
            .ok()?;
        Some(Self {
            server,
            name: format!(":{}", number.trim()),
        })
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// Lets a program run for some minutes at most.
fn within_minutes(mut program: Child, minutes: u64) -> Output {
    let deadline = Instant::now() + Duration::from_secs(60 * minutes);
    while program.try_wait().unwrap().is_none() {
        if Instant::now() > deadline {
            program.kill().unwrap();
        }
        std::thread::sleep(Duration::from_millis(100));
    }
    program.wait_with_output().unwrap()
}

/// Runs the explorer for some frames on a display, and returns a picture of its window; `None`
/// where there is no adapter.
fn window(display: &Display) -> Option<DecodedPicture> {
    let folder = TempDir::new().unwrap();
    let size = ["--samples", "2000", "--plates", "12"];
    let args = [&size[..], &["--frames", "30", "--capture", "window.png"]].concat();
    let explorer = pangaea(folder.path(), &args)
        .env("DISPLAY", &display.name)
        .env_remove("WAYLAND_DISPLAY")
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drew(&within_minutes(explorer, 5))
        .then(|| DecodedPicture::read(&folder.path().join("window.png")))
}

#[test]
fn the_explorer_opens_a_window_with_panels_around_a_globe() {
    let Some(display) = Display::open() else {
        eprintln!("SKIPPED: there is no Xvfb");
        return;
    };
    let Some(window) = window(&display) else {
        return;
    };
    let (width, height) = (window.width, window.height);
    assert!(width >= 640 && height >= 360, "{width} x {height}");
    // The globe is brighter than the panels, and the panels are written on.
    assert!((0.05..0.9).contains(&window.lit()), "{}", window.lit());
    let edge = (0..height).flat_map(|y| (0..width / 8).map(move |x| (x, y)));
    let written = edge.filter(|&(x, y)| window.brightness(x, y) > 300).count();
    assert!(written > 200, "{written}");
}
