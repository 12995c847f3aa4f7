//! The files that the program writes.

use image::{GrayImage, ImageFormat, Luma, Rgb, RgbImage};
use planform_sdk::{Cell, Grid, Layout};
use planform_synth::{Labels, Plan};
use std::error::Error;
use std::fs;
use std::path::Path;

/// Writes `map.pgm`, `map.yaml`, `truth.json` and `labels.png` into the folder, which is made if need be.
pub fn write(folder: &Path, grid: &Grid, truth: &Layout, labels: &Labels) -> Result<(), Box<dyn Error>> {
    let path = |name: &str| folder.join(name);
    fs::create_dir_all(folder).map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    fs::write(path("map.pgm"), pgm(grid))?;
    fs::write(path("map.yaml"), yaml(grid))?;
    fs::write(path("truth.json"), serde_json::to_string_pretty(truth)? + "\n")?;
    label_image(labels).save_with_format(path("labels.png"), ImageFormat::Png)?;
    Ok(())
}

/// Writes `plan.jpg` or `plan.png`, `truth.json`, `labels.png` (the rooms), `walls.png` and `letters.png` (their ink)
/// into the folder, which is made if need be.
pub fn write_plan(folder: &Path, plan: &Plan) -> Result<(), Box<dyn Error>> {
    let path = |name: &str| folder.join(name);
    fs::create_dir_all(folder).map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    match &plan.jpeg {
        Some(bytes) => fs::write(path("plan.jpg"), bytes)?,
        None => plan.picture.save_with_format(path("plan.png"), ImageFormat::Png)?,
    }
    fs::write(path("truth.json"), serde_json::to_string_pretty(&plan.truth)? + "\n")?;
    label_image(&plan.labels()).save_with_format(path("labels.png"), ImageFormat::Png)?;
    plan.truth.walls.save_with_format(path("walls.png"), ImageFormat::Png)?;
    plan.truth.letters.save_with_format(path("letters.png"), ImageFormat::Png)?;
    Ok(())
}

/// The binary PGM that ROS's map_saver writes.
fn pgm(grid: &Grid) -> Vec<u8> {
    let picture = GrayImage::from_fn(grid.width(), grid.height(), |x, y| {
        Luma([grey(grid.cell(i64::from(x), i64::from(grid.height() - 1 - y)))])
    });
    let mut bytes = format!("P5\n{} {}\n255\n", grid.width(), grid.height()).into_bytes();
    bytes.extend(picture.into_raw());
    bytes
}

/// 0 occupied, 205 unknown, 254 free.
fn grey(cell: Cell) -> u8 {
    match cell.occupancy() {
        None => 205,
        Some(percent) if percent >= 65 => 0,
        Some(_) => 254,
    }
}

fn yaml(grid: &Grid) -> String {
    let origin = grid.origin();
    format!(
        "image: map.pgm\nresolution: {:.6}\norigin: [{:.6}, {:.6}, {:.6}]\nnegate: 0\noccupied_thresh: 0.65\n\
         free_thresh: 0.196\n",
        grid.resolution(),
        origin.x,
        origin.y,
        origin.yaw
    )
}

fn label_image(labels: &Labels) -> RgbImage {
    let mut picture = RgbImage::new(labels.width, labels.height);
    for (pixel, index) in picture.pixels_mut().zip(0..labels.rooms.len()) {
        let (column, row) = (index % labels.width as usize, index / labels.width as usize);
        let from_top = labels.height as usize - 1 - row;
        *pixel = Rgb(colour(labels.rooms[from_top * labels.width as usize + column]));
    }
    picture
}

/// A colour of its own for each of the first 65,535 rooms: the low bytes are a bijection of the number.
fn colour(room: u32) -> [u8; 3] {
    if room == 0 {
        return [0; 3];
    }
    let mixed = (room.wrapping_mul(40_503) & 0xFFFF) as u16;
    let [a, b] = mixed.to_be_bytes();
    [a, b, 64 + (room.wrapping_mul(97) & 0x7F) as u8]
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_synth::{Outline, two_rooms};
    use std::collections::BTreeSet;

    #[test]
    fn colours_are_distinct_and_never_black() {
        let colours: BTreeSet<[u8; 3]> = (0..=5000).map(colour).collect();
        assert_eq!(colours.len(), 5001);
        assert!((1..=5000).all(|r| colour(r)[2] >= 64));
    }

    #[test]
    fn map_and_labels_share_their_frame_with_y_down() {
        let building = two_rooms();
        let grid = building.clean_grid(0.1).unwrap();
        let labels = building.labels(0.1, Outline::Inner).unwrap();
        let (map, picture) = (pgm(&grid), label_image(&labels));
        let header = map.len() - grid.cells().len();
        for (i, pixel) in picture.pixels().enumerate() {
            assert!(pixel.0 == [0; 3] || map[header + i] == 254, "pixel {i}");
        }
        let bottom = grid.cells().len() - grid.width() as usize * 21;
        assert_eq!(map[header + bottom + 25], 0, "the lower wall is near the end of the file");
    }

    #[test]
    fn writes_all_files() {
        let folder = tempfile::tempdir().unwrap();
        let building = two_rooms();
        let labels = building.labels(0.1, Outline::Centre).unwrap();
        let out = folder.path().join("new");
        write(&out, &building.clean_grid(0.1).unwrap(), building.layout(), &labels).unwrap();
        let text = fs::read_to_string(out.join("truth.json")).unwrap();
        assert_eq!(&serde_json::from_str::<Layout>(&text).unwrap(), building.layout());
        assert!(fs::read_to_string(out.join("map.yaml")).unwrap().contains("origin: [-2.000000, -2.000000,"));
        assert!(out.join("map.pgm").exists() && out.join("labels.png").exists());
    }
}
