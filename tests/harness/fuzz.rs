//! Fuzzing with a stable compiler: good inputs are damaged, and a reader must accept or refuse each.
//!
//! An input depends on the format and on its number alone, so every run tries the same ones. One
//! that makes the reader panic, or read for longer than `PATIENCE`, is kept in a file of the
//! system's temporary folder and named.

use crate::soak;
use fastrand::Rng;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Damaged inputs that a usual run tries, and a long one.
const INPUTS: [u64; 2] = [10_000, 1_000_000];
/// A reader that takes longer than this for one small input hangs.
const PATIENCE: Duration = Duration::from_secs(60);
/// Address space in bytes that all readers together may ask for beyond what the process had.
const MEMORY: u64 = 4 << 30;
/// Broken inputs after which a reader is given up.
const ENOUGH: usize = 10;
/// Most places at which an input is damaged.
const WOUNDS: usize = 4;

/// A format of inputs.
pub struct Format<'a> {
    /// Its name.
    pub name: &'a str,
    /// Inputs that the reader accepts.
    pub good: Vec<Vec<u8>>,
    /// Words that mean something in it.
    pub words: &'a [&'a str],
}

/// Gives damaged inputs to `read`, which panics if the reader breaks a promise.
///
/// # Panics
/// If `read` panicked; the message names the files that hold the inputs.
pub fn fuzz(format: &Format, mut read: impl FnMut(&[u8])) {
    let name = format.name;
    format.good.iter().for_each(|good| read(good));
    let peak = soak::memory("VmPeak");
    let failed = broken(format, &mut read);
    assert!(failed.is_empty(), "{name} broke on {failed:?}");
    if let (Some(before), Some(after)) = (peak, soak::memory("VmPeak")) {
        let grown = after - before;
        assert!(grown < MEMORY, "reading {name} took {} MiB", grown >> 20);
    }
}

/// Files with the inputs on which `read` panicked.
fn broken(format: &Format, read: &mut impl FnMut(&[u8])) -> Vec<PathBuf> {
    let watch = Watch::start(format.name);
    let mut failed = Vec::new();
    for number in 0..soak::count(INPUTS[0], INPUTS[1]) {
        let input = format.damaged(number);
        watch.begin(number, &input);
        let result = catch_unwind(AssertUnwindSafe(|| read(&input)));
        watch.end();
        if result.is_err() {
            failed.push(keep(format.name, number, &input));
        }
        if failed.len() == ENOUGH {
            break;
        }
    }
    failed
}

/// Writes an input to a file of the temporary folder.
fn keep(name: &str, number: u64, input: &[u8]) -> PathBuf {
    let name = name.replace(' ', "-");
    let path = std::env::temp_dir().join(format!("pangaea-fuzz-{name}-{number}"));
    fs::write(&path, input).expect("the temporary folder can be written");
    path
}

impl Format<'_> {
    /// The damaged input of a number.
    pub fn damaged(&self, number: u64) -> Vec<u8> {
        let seed = self
            .name
            .bytes()
            .fold(number, |seed, byte| seed.rotate_left(8) ^ u64::from(byte));
        let mut rng = Rng::with_seed(bevy_pangaea::random::mix(seed));
        let mut input = rng.choice(&self.good).cloned().unwrap_or_default();
        for _ in 0..rng.usize(1..=WOUNDS) {
            self.wound(&mut input, &mut rng);
        }
        input
    }

    fn wound(&self, input: &mut Vec<u8>, rng: &mut Rng) {
        let at = rng.usize(0..=input.len());
        match rng.u8(0..9) {
            0 => flip(input, at, 1 << rng.u8(0..8)),
            1 => flip(input, at, rng.u8(..)),
            2 => overwrite(input, at, &extreme(rng)),
            3 => input.truncate(at),
            4 => drop(input.drain(range(input, at, rng))),
            5 => repeat(input, at, rng),
            6 => self.splice(input, at, rng),
            7 => insert(input, at, self.word(rng)),
            _ => overwrite(input, at, self.word(rng)),
        }
    }

    /// Puts a part of another good input at `at`.
    fn splice(&self, input: &mut Vec<u8>, at: usize, rng: &mut Rng) {
        if let Some(other) = rng.choice(&self.good) {
            let from = rng.usize(0..=other.len());
            insert(input, at, &other[range(other, from, rng)]);
        }
    }

    fn word(&self, rng: &mut Rng) -> &[u8] {
        rng.choice(self.words).map_or(&[], |word| word.as_bytes())
    }
}

/// A short range of `input` from `at` on.
fn range(input: &[u8], at: usize, rng: &mut Rng) -> core::ops::Range<usize> {
    at..(at + rng.usize(0..=64)).min(input.len())
}

fn flip(input: &mut [u8], at: usize, bits: u8) {
    if let Some(byte) = input.get_mut(at) {
        *byte ^= bits;
    }
}

fn overwrite(input: &mut [u8], at: usize, bytes: &[u8]) {
    for (place, &byte) in input[at..].iter_mut().zip(bytes) {
        *place = byte;
    }
}

fn insert(input: &mut Vec<u8>, at: usize, bytes: &[u8]) {
    input.splice(at..at, bytes.iter().copied());
}

/// Repeats a short part of the input a few times.
fn repeat(input: &mut Vec<u8>, at: usize, rng: &mut Rng) {
    let part = input[range(input, at, rng)].repeat(rng.usize(1..=8));
    insert(input, at, &part);
}

/// A number at the edge of its type, in either byte order.
fn extreme(rng: &mut Rng) -> Vec<u8> {
    const WHOLE: [u64; 9] = [
        0,
        1,
        2,
        0x7f,
        0x80,
        0x7fff,
        0x8000,
        0x7fff_ffff,
        0x8000_0000,
    ];
    const REAL: [f64; 8] = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        -0.0,
        1e300,
        -1e300,
        1e38,
        5e-324,
    ];
    let real = REAL[rng.usize(0..REAL.len())];
    let whole = WHOLE[rng.usize(0..WHOLE.len())];
    let whole = if rng.bool() { whole } else { !whole };
    let mut bytes = match rng.u8(0..5) {
        0 => (whole as u16).to_le_bytes().to_vec(),
        1 => (whole as u32).to_le_bytes().to_vec(),
        2 => whole.to_le_bytes().to_vec(),
        3 => (real as f32).to_le_bytes().to_vec(),
        _ => real.to_le_bytes().to_vec(),
    };
    if rng.bool() {
        bytes.reverse();
    }
    bytes
}

/// Ends the process if an input is read for too long, which no test could notice by itself.
struct Watch(Arc<Mutex<Option<Reading>>>);

struct Reading {
    since: Instant,
    number: u64,
    input: Vec<u8>,
}

impl Watch {
    fn start(name: &str) -> Self {
        let reading: Arc<Mutex<Option<Reading>>> = Arc::default();
        let (seen, name) = (Arc::downgrade(&reading), name.to_string());
        std::thread::spawn(move || {
            while let Some(reading) = seen.upgrade() {
                let reading = reading.lock().expect("nobody panics with it");
                if let Some(late) = reading
                    .as_ref()
                    .filter(|now| now.since.elapsed() > PATIENCE)
                {
                    let path = keep(&name, late.number, &late.input);
                    eprintln!("reading {} hangs", path.display());
                    std::process::abort();
                }
                drop(reading);
                std::thread::sleep(Duration::from_millis(500));
            }
        });
        Self(reading)
    }

    fn begin(&self, number: u64, input: &[u8]) {
        let reading = Reading {
            since: Instant::now(),
            number,
            input: input.to_vec(),
        };
        *self.0.lock().expect("nobody panics with it") = Some(reading);
    }

    fn end(&self) {
        *self.0.lock().expect("nobody panics with it") = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn format() -> Format<'static> {
        Format {
            name: "greeting",
            good: vec![b"good morning, good evening".to_vec(), vec![7; 100]],
            words: &["night"],
        }
    }

    #[test]
    fn damage_is_different_each_time_and_the_same_again() {
        let format = format();
        let all: BTreeSet<Vec<u8>> = (0..1000).map(|number| format.damaged(number)).collect();
        assert!(all.len() > 900, "{}", all.len());
        assert_eq!(format.damaged(17), format.damaged(17));
        assert!(
            all.iter()
                .any(|input| input.windows(5).any(|part| part == b"night"))
        );
        assert!(all.iter().all(|input| input.len() < 10_000));
    }

    #[test]
    fn a_reader_that_panics_is_told_with_its_input() {
        let read = |input: &[u8]| assert!(!input.windows(5).any(|part| part == b"night"));
        let panic = catch_unwind(|| fuzz(&format(), read)).unwrap_err();
        let text = panic.downcast_ref::<String>().unwrap();
        let paths: Vec<&str> = text.split('"').skip(1).step_by(2).collect();
        assert_eq!(paths.len(), ENOUGH, "{text}");
        for path in paths {
            let kept = fs::read(path).unwrap();
            assert!(kept.windows(5).any(|part| part == b"night"), "{path}");
            fs::remove_file(path).unwrap();
        }
    }
}
