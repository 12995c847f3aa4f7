//! Work shared among threads, with results that do not depend on how many there are.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Below this many bytes of rows a thread costs more than it brings.
// Under Miri, which is thousands of times slower, tests shall share out little work all the same.
const WORTH_A_THREAD: usize = if cfg!(miri) { 1 << 10 } else { 1 << 18 };

/// The environment variable that says how many threads there are, unless the program does.
pub const VARIABLE: &str = "PLANFORM_THREADS";

/// How many threads there are; 0 is not known yet.
static THREADS: AtomicUsize = AtomicUsize::new(0);

/// On how many threads work is shared: as the program or [`VARIABLE`] says, else one for each core that it may use.
pub fn threads() -> usize {
    match THREADS.load(Ordering::Relaxed) {
        0 => {
            let said = std::env::var(VARIABLE).ok().and_then(|n| n.parse::<NonZero<usize>>().ok());
            let count = said.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZero::get);
            THREADS.store(count, Ordering::Relaxed);
            count
        }
        known => known,
    }
}

/// Says on how many threads work is shared from now on.
pub fn set_threads(count: NonZero<usize>) {
    THREADS.store(count.get(), Ordering::Relaxed);
}

/// Calls `work` once for every row of `data` with the row's number, in no fixed order. Rows are `length` items long.
pub fn for_each<T: Send>(data: &mut [T], length: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    for_each_band(data, length, |first, band| {
        band.chunks_exact_mut(length).enumerate().for_each(|(i, row)| work(first + i, row));
    });
}

/// Calls `work` once for every band of rows, with the number of the band's first row. How the rows fall into bands
/// depends on the number of threads, so what is done to a row must not depend on its band.
pub fn for_each_band<T: Send>(data: &mut [T], length: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    let count = data.len();
    for_each_band_of_two(data, &mut vec![(); count], length, |first, band, _| work(first, band));
}

/// Like [`for_each_band`], for two pictures of the same size.
pub fn for_each_band_of_two<A: Send, B: Send>(
    a: &mut [A],
    b: &mut [B],
    length: usize,
    work: impl Fn(usize, &mut [A], &mut [B]) + Sync,
) {
    if length == 0 || a.is_empty() {
        return;
    }
    let bands = threads().min(size_of_val(a) / WORTH_A_THREAD).max(1);
    if bands == 1 {
        return work(0, a, b);
    }
    let rows = (a.len() / length).div_ceil(bands);
    thread::scope(|scope| {
        for (i, (a, b)) in a.chunks_mut(rows * length).zip(b.chunks_mut(rows * length)).enumerate() {
            let work = &work;
            scope.spawn(move || work(i * rows, a, b));
        }
    });
}

/// `work` done for every number below `count`, results in that order.
///
/// # Panics
/// As `work` does.
pub fn map<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let threads = threads().min(count);
    if threads < 2 {
        return (0..count).map(work).collect();
    }
    let next = AtomicUsize::new(0);
    let turn = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|&i| i < count);
    let worker = || std::iter::from_fn(turn).map(|i| (i, work(i))).collect::<Vec<_>>();
    let mut done: Vec<(usize, T)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(worker)).collect();
        workers.into_iter().flat_map(|w| w.join().unwrap_or_else(|e| resume_unwind(e))).collect()
    });
    done.sort_unstable_by_key(|d| d.0);
    done.into_iter().map(|d| d.1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Threads are those of the whole program: one test for all that depends on them.
    #[test]
    fn all_is_done_once_whatever_the_threads() {
        for count in [1, 2, 3, 8].map(NonZero::new).into_iter().flatten() {
            set_threads(count);
            assert_eq!(threads(), count.get());
            for (rows, length) in [(1, 1), (7, 3), (3 * WORTH_A_THREAD / 256, 256)] {
                let mut data = vec![0u64; rows * length];
                for_each(&mut data, length, |row, cells| cells.iter_mut().for_each(|c| *c += row as u64 + 1));
                let expected = |i: usize| (i / length) as u64 + 1;
                assert!(data.iter().enumerate().all(|(i, &v)| v == expected(i)));
            }
            for items in [0, 1, 5, 100] {
                assert_eq!(map(items, |i| i * i), (0..items).map(|i| i * i).collect::<Vec<_>>());
            }
        }
        for_each(&mut [0u8; 0], 5, |_, _| panic!("there is no row"));
        for_each(&mut [0u8; 4], 0, |_, _| panic!("there is no row"));
    }
}
