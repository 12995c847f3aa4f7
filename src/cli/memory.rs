//! How much memory there is, and how much a process takes.

use crate::host::isolated::page_size;
use std::fs;
use std::path::Path;

/// A MiB.
pub const MIB: u64 = 1 << 20;

/// What is taken for granted where the system does not say, bytes.
const UNKNOWN: u64 = 4096 * MIB;

/// How much memory a batch takes unless it is told: three quarters of what is there for it, bytes.
pub fn usual_budget() -> u64 {
    let free = free_of_machine().into_iter().chain(free_of_group()).min();
    free.unwrap_or(UNKNOWN) / 4 * 3
}

/// What the machine could give without swapping.
fn free_of_machine() -> Option<u64> {
    let text = fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|l| l.strip_prefix("MemAvailable:"))?;
    Some(line.split_whitespace().next()?.parse::<u64>().ok()? * 1024)
}

/// What is left of the control group's limit, such as that of a container or of a job of Slurm.
fn free_of_group() -> Option<u64> {
    let own = fs::read_to_string("/proc/self/cgroup").ok()?;
    let path = own.lines().find_map(|l| l.strip_prefix("0::/"))?;
    let root = Path::new("/sys/fs/cgroup");
    let number = |file: &Path| fs::read_to_string(file).ok()?.trim().parse::<u64>().ok();
    let left = |folder: &Path| {
        let most = number(&folder.join("memory.max"))?;
        Some(most.saturating_sub(number(&folder.join("memory.current")).unwrap_or(0)))
    };
    root.join(path).ancestors().take_while(|folder| folder.starts_with(root)).filter_map(left).min()
}

/// The memory that a process and those that it started hold at the moment, bytes; 0 where the system does not tell.
pub fn held_by(process: u32) -> u64 {
    let own = held_alone(process).unwrap_or(0);
    children(process).into_iter().map(|child| held_alone(child).unwrap_or(0)).sum::<u64>() + own
}

/// The most memory that this process held so far, bytes; 0 where the system does not tell.
pub fn most_held() -> u64 {
    let text = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let most = text.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    most.and_then(|m| m.split_whitespace().next()?.parse::<u64>().ok()).unwrap_or(0) * 1024
}

fn held_alone(process: u32) -> Option<u64> {
    let pages = fs::read_to_string(format!("/proc/{process}/statm")).ok()?;
    Some(pages.split_whitespace().nth(1)?.parse::<u64>().ok()? * page_size())
}

/// The processes that this one started itself.
fn children(process: u32) -> Vec<u32> {
    let threads = fs::read_dir(format!("/proc/{process}/task")).into_iter().flatten().flatten();
    let of_thread = |thread: fs::DirEntry| fs::read_to_string(thread.path().join("children")).ok();
    let lists: Vec<_> = threads.filter_map(of_thread).collect();
    lists.iter().flat_map(|list| list.split_whitespace()).filter_map(|id| id.parse().ok()).collect()
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[test]
    fn memory_is_known() {
        assert!(usual_budget() > 64 * MIB);
        let block = vec![1_u8; 64 << 20];
        assert!(held_by(std::process::id()) > block.len() as u64);
        assert_eq!(held_by(u32::MAX), 0);
    }
}
