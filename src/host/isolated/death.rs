//! Why a plugin's process ended, in words.

use super::Limits;
use crate::host::conformance;
use std::process::ExitStatus;

/// How much is quoted of what a process said last, characters.
const LONGEST_LINE: usize = 200;

/// What is known of a process that ended, or was ended, before it answered.
pub struct Death {
    /// How it ended, if it did by itself.
    pub status: Option<ExitStatus>,
    /// Whether it was ended because it took too long.
    pub late: bool,
    /// The end of what it printed on standard error.
    pub last_words: String,
    /// The most address space that the plugin was seen with, bytes.
    pub peak: u64,
}

impl Death {
    /// What happened, and what the user can do about it if that is not to tell the plugin's maker.
    pub fn told(&self, limits: &Limits) -> (String, Option<String>) {
        if self.last_words.contains("has overflowed its stack") {
            return ("it ran out of stack, perhaps by calling itself without end".into(), None);
        }
        if self.was_out_of_memory(limits) {
            let advice = "`--plugin-memory MIB` allows more".into();
            return (
                format!("it took more than the {} MiB of memory that it may", limits.memory),
                Some(advice),
            );
        }
        if self.late {
            let seconds = limits.time.as_secs_f64();
            let advice = "`--plugin-timeout SECONDS` allows more".into();
            return (format!("it took longer than the {seconds} s that it may"), Some(advice));
        }
        let end = self.status.map_or_else(|| "it broke off its talk with planform".into(), ended);
        (self.last_line().map_or_else(|| end.clone(), |line| format!("{end}, after saying `{line}`")), None)
    }

    /// The last that it said on its own.
    fn last_line(&self) -> Option<String> {
        let own = |line: &&str| !line.trim().is_empty() && !line.starts_with(conformance::AT);
        let line = self.last_words.lines().rfind(own)?;
        Some(line.trim().chars().take(LONGEST_LINE).collect())
    }

    fn was_out_of_memory(&self, limits: &Limits) -> bool {
        says_out_of_memory(&self.last_words) || self.peak >= limits.bytes() / 10 * 9
    }
}

/// Whether a process's last words are those of one to which the system gave no more memory.
pub fn says_out_of_memory(last_words: &str) -> bool {
    let said = ["memory allocation of", "bad_alloc", "Cannot allocate memory"];
    said.iter().any(|words| last_words.contains(words))
}

/// How a process ended, in words.
#[cfg(unix)]
pub fn ended(status: ExitStatus) -> String {
    use std::os::unix::process::ExitStatusExt;
    match status.signal() {
        None => format!("it ended its process with the status {}", status.code().unwrap_or(0)),
        Some(4) => "it crashed (illegal instruction)".into(),
        Some(6) => "it crashed (abort)".into(),
        Some(7 | 10) => "it crashed (bus error)".into(),
        Some(8) => "it crashed (arithmetic error)".into(),
        Some(9) => "the system ended it, perhaps for lack of memory".into(),
        Some(11) => "it crashed (segmentation fault)".into(),
        Some(signal) => format!("it was ended by signal {signal}"),
    }
}

/// How a process ended, in words.
#[cfg(not(unix))]
pub fn ended(status: ExitStatus) -> String {
    format!("it ended its process with the {status}")
}

/// How much address space a process takes, bytes, where the system tells.
pub fn address_space(pid: u32) -> Option<u64> {
    let pages = std::fs::read_to_string(format!("/proc/{pid}/statm")).ok()?;
    Some(pages.split_whitespace().next()?.parse::<u64>().ok()? * page_size())
}

/// The bytes of a page of memory.
#[cfg(unix)]
pub fn page_size() -> u64 {
    rustix::param::page_size() as u64
}

/// The bytes of a page of memory.
#[cfg(not(unix))]
pub fn page_size() -> u64 {
    4096
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::process::ExitStatusExt;
    use std::time::Duration;

    fn told(signal: i32, last_words: &str, peak: u64, late: bool) -> String {
        let limits = Limits { program: None, time: Duration::from_secs(2), memory: 100, echo: false };
        let status = Some(ExitStatus::from_raw(signal));
        Death { status, late, last_words: last_words.into(), peak }.told(&limits).0
    }

    #[test]
    fn every_end_has_its_words() {
        assert_eq!(told(11, "", 0, false), "it crashed (segmentation fault)");
        assert_eq!(told(11, "", 95 << 20, false), "it took more than the 100 MiB of memory that it may");
        assert_eq!(told(6, "memory allocation of 5 bytes failed", 0, false), told(11, "", 95 << 20, false));
        assert_eq!(told(6, "a.c:3: no!\n\n", 0, false), "it crashed (abort), after saying `a.c:3: no!`");
        assert_eq!(told(6, "trying: an empty document\n", 0, false), "it crashed (abort)");
        assert_eq!(told(9, "", 0, true), "it took longer than the 2 s that it may");
        assert_eq!(told(3 << 8, "", 0, false), "it ended its process with the status 3");
        assert!(told(6, "\nthread 'main' has overflowed its stack\n", 0, false).contains("ran out of stack"));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn the_address_space_is_known() {
        assert!(address_space(std::process::id()).unwrap() > 1 << 20);
        assert_eq!(address_space(u32::MAX), None);
    }
}
