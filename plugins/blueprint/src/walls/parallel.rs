//! Work on all cores. What comes out does not depend on how many there are.

use std::thread;

/// Lets `work` fill every row (its number, its pixels) of a picture of this width.
pub fn rows<T: Send>(pixels: &mut [T], width: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    if width == 0 {
        return;
    }
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let share = (pixels.len() / width).div_ceil(cores).max(1);
    thread::scope(|scope| {
        for (part, chunk) in pixels.chunks_mut(share * width).enumerate() {
            let work = &work;
            scope.spawn(move || {
                for (i, row) in chunk.chunks_mut(width).enumerate() {
                    work(part * share + i, row);
                }
            });
        }
    });
}
