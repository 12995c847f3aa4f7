//! Work on the rows of a picture by all cores.

use std::num::NonZero;
use std::thread;

/// Below this many bytes a thread costs more than it brings.
const WORTH_A_THREAD: usize = 1 << 18;

/// Calls `work` once for every row of `data` with the row's number, in no fixed order. Rows are `length`
/// items long.
pub fn for_each<T: Send>(data: &mut [T], length: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    for_each_band(data, length, |first, band| {
        band.chunks_exact_mut(length).enumerate().for_each(|(i, row)| work(first + i, row));
    });
}

/// Calls `work` once for every band of rows, with the number of the band's first row. How the rows fall into
/// bands depends on the machine, so what is done to a row must not depend on its band.
pub fn for_each_band<T: Send>(data: &mut [T], length: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    if length == 0 || data.is_empty() {
        return;
    }
    let rows = (data.len() / length).div_ceil(threads(data.len()));
    thread::scope(|scope| {
        for (i, band) in data.chunks_mut(rows * length).enumerate() {
            let work = &work;
            scope.spawn(move || work(i * rows, band));
        }
    });
}

/// `work` done for every number below `count`, results in that order.
pub fn map<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let mut results: Vec<Option<T>> = (0..count).map(|_| None).collect();
    let each = count.div_ceil(cores()).max(1);
    thread::scope(|scope| {
        for (i, part) in results.chunks_mut(each).enumerate() {
            let work = &work;
            scope.spawn(move || {
                part.iter_mut().enumerate().for_each(|(k, slot)| *slot = Some(work(i * each + k)))
            });
        }
    });
    results.into_iter().flatten().collect()
}

/// Of every item of a row the least within `reach` to both sides.
pub fn least_within(row: &[u8], reach: usize) -> Vec<u8> {
    let mut out = row.to_vec();
    for shift in 1..=reach.min(row.len()) {
        lower(&mut out[shift..], row);
        lower(&mut out, &row[shift..]);
    }
    out
}

/// Takes from each pair of items the lesser one.
pub fn lower(row: &mut [u8], by: &[u8]) {
    row.iter_mut().zip(by).for_each(|(r, &b)| *r = b.min(*r));
}

fn threads(items: usize) -> usize {
    cores().min(items / WORTH_A_THREAD).max(1)
}

fn cores() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_is_visited_once_under_its_own_number() {
        let mut data = vec![0u32; 1000 * 997];
        for_each(&mut data, 1000, |y, row| row.iter_mut().for_each(|v| *v += y as u32 + 1));
        assert!(data.iter().enumerate().all(|(i, &v)| v as usize == i / 1000 + 1));
    }

    #[test]
    fn results_keep_their_order() {
        assert_eq!(map(7, |i| i * i), [0, 1, 4, 9, 16, 25, 36]);
        assert!(map(0, |i| i).is_empty());
    }

    #[test]
    fn nothing_is_no_work() {
        for_each(&mut Vec::<u8>::new(), 0, |_, _| panic!("there is no row"));
    }
}
