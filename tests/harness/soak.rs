//! Long runs: `PANGAEA_SOAK=1` makes tests take hours that otherwise take seconds.

use std::fs;

/// Whether this is a long run.
pub fn is_on() -> bool {
    std::env::var_os("PANGAEA_SOAK").is_some_and(|value| value == "1")
}

/// `short` in a usual run, `long` in a long one.
pub fn count(short: u64, long: u64) -> u64 {
    if is_on() { long } else { short }
}

/// Memory of this process in bytes: a line of `/proc/self/status`, as `VmRSS` (what it holds now)
/// or `VmPeak` (the most that it ever asked for). `None` where there is no such file.
pub fn memory(line: &str) -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let value = status
        .lines()
        .find_map(|text| text.strip_prefix(line)?.strip_prefix(':'))?;
    let kilobytes: u64 = value.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kilobytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_told_on_linux() {
        if cfg!(target_os = "linux") {
            let (now, peak) = (memory("VmRSS").unwrap(), memory("VmPeak").unwrap());
            assert!(now > 1 << 20 && peak >= now, "{now} {peak}");
        }
        assert_eq!(memory("VmNothing"), None);
    }
}
