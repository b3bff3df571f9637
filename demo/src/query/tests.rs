//! Answers come as their questions do, and end with them.

use super::*;
use bevy::math::DVec3;
use bevy_pangaea::query::GroundError;
use std::io::{BufRead, BufReader, Read};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

/// Height = 100 m per degree of latitude; it counts how often it is asked.
#[derive(Default)]
struct SlopingGround(AtomicUsize);

impl Ground for SlopingGround {
    fn radius_m(&self) -> f64 {
        1e6
    }

    fn height(&self, direction: DVec3, _: u8) -> Result<f32, GroundError> {
        self.0.fetch_add(1, Ordering::Relaxed);
        Ok((100.0 * bevy_pangaea::math::lat_lon(direction).0) as f32)
    }
}

/// The text that is printed for an input, and how it ends.
fn answers(input: impl BufRead + Send + 'static) -> (String, Result<(), CliError>) {
    let mut out = Vec::new();
    let places = PlaceQueue::read(|| input);
    let result = answer(places, &SlopingGround::default(), 17, &mut out, || true);
    (String::from_utf8(out).unwrap(), result)
}

#[test]
fn lines_come_in_the_order_of_the_input() {
    let (text, result) = answers("\u{feff}10,20\n\n -33 , -70.5\r\n0,360".as_bytes());
    result.unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!((lines[0], lines.len()), (HEADER, 4));
    assert!(lines[1].starts_with("10,20,1000.000,1000.000,"), "{text}");
    assert!(
        lines[2].starts_with("-33,-70.5,-3300.000,0.000,") && lines[2].ends_with(",sea_floor"),
        "{text}"
    );
    assert!(lines[3].starts_with("0,360,"), "{text}");
    let columns = HEADER.split(',').count();
    assert!(lines.iter().all(|line| line.split(',').count() == columns));
    assert_eq!(answers(&b""[..]).0, format!("{HEADER}\n"));
}

#[test]
fn many_lines_are_all_answered_in_their_order() {
    let point = |i: usize| format!("{},{}", i % 90, i % 360);
    let input: Vec<String> = (0..10_000).map(point).collect();
    let (text, result) = answers(io::Cursor::new(input.join("\n")));
    result.unwrap();
    let lines: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(lines.len(), input.len());
    for (line, point) in lines.iter().zip(&input) {
        assert!(line.starts_with(&format!("{point},")), "{line}");
    }
}

#[test]
fn lines_before_a_bad_one_are_answered_and_it_is_named() {
    let titles = ["line 1 of the input: `lat,lon`", "latitude"];
    for (bad, words, answered) in [
        ("1,2\n3\n4,5", ["line 2", "LAT,LON"], 1),
        ("91,2\n1,2\n", ["line 1", "latitude"], 0),
        ("1,2\n1,2\n\n5,NaN\n", ["line 4", "longitude"], 2),
        ("lat,lon\n1,2\n", titles, 0),
        ("1,2,3\n", ["line 1", "LAT,LON"], 0),
    ] {
        let (text, result) = answers(bad.as_bytes());
        let problem = result.unwrap_err().to_string();
        assert!(words.iter().all(|word| problem.contains(word)), "{problem}");
        // The header comes first, also before a wrong line.
        assert_eq!(text.lines().next(), Some(HEADER));
        assert_eq!(text.lines().skip(1).count(), answered, "{bad}");
    }
    assert!(answers([0xff, 0xfe, b'\n'].as_slice()).1.is_err());
    let problem = answers([b'1'; 5000].as_slice()).1.unwrap_err();
    assert!(problem.to_string().contains("too long"), "{problem}");
}

/// An input that is typed piece by piece.
struct TypedInput(Receiver<&'static str>);

impl Read for TypedInput {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        // The end of the pieces is the end of the input.
        let piece = self.0.recv().unwrap_or_default().as_bytes();
        bytes[..piece.len()].copy_from_slice(piece);
        Ok(piece.len())
    }
}

/// An output whose pieces are received as they are printed.
struct HeardOutput(Sender<String>);

impl Write for HeardOutput {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let text = String::from_utf8(bytes.to_vec()).unwrap();
        self.0.send(text).map_err(|_| io::ErrorKind::BrokenPipe)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn each_line_is_answered_before_the_next_one_is_typed() {
    let ((keys, typed), (heard, answers)) = (channel(), channel());
    let command = thread::spawn(move || {
        let places = PlaceQueue::read(|| BufReader::new(TypedInput(typed)));
        let ground = SlopingGround::default();
        answer(places, &ground, 17, HeardOutput(heard), || true)
    });
    let hear = || answers.recv_timeout(Duration::from_secs(20)).unwrap();
    assert_eq!(hear(), format!("{HEADER}\n"));
    for (line, start) in [
        ("1,2\n", "1,2,100."),
        ("-3,4\n", "-3,4,-300."),
        ("5,6\n", "5,6,500."),
    ] {
        keys.send(line).unwrap();
        let answer = hear();
        assert!(answer.starts_with(start) && answer.lines().count() == 1);
    }
    // A line may come in pieces.
    keys.send("7,").unwrap();
    keys.send("8\n").unwrap();
    assert!(hear().starts_with("7,8,700."));
    drop(keys);
    command.join().unwrap().unwrap();
}

#[test]
fn it_ends_when_nobody_reads_though_the_input_goes_on() {
    let (_keys, typed) = channel();
    let places = PlaceQueue::read(|| BufReader::new(TypedInput(typed)));
    let asked = AtomicUsize::new(0);
    let is_read = || asked.fetch_add(1, Ordering::Relaxed) < 2;
    let mut out = Vec::new();
    answer(places, &SlopingGround::default(), 17, &mut out, is_read).unwrap();
    assert_eq!(out, format!("{HEADER}\n").as_bytes());
}

/// An output that is closed after so many bytes.
struct ClosedOutput(usize);

impl Write for ClosedOutput {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0 = self
            .0
            .checked_sub(bytes.len())
            .ok_or(io::ErrorKind::BrokenPipe)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_closed_output_ends_it_after_the_first_points() {
    let input = "12,34\n".repeat(60_000);
    let places = PlaceQueue::read(|| io::Cursor::new(input));
    let ground = SlopingGround::default();
    answer(places, &ground, 17, ClosedOutput(200), || true).unwrap();
    // A sample asks for a few heights.
    let asked = ground.0.load(Ordering::Relaxed);
    assert!(asked < 60_000 / 4, "{asked}");
}
