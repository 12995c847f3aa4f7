//! Small pictures of documents and of their layouts, for the report.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, GrayImage, ImageBuffer, ImageEncoder, Rgb, imageops};
use planform_sdk::{Grid, Layout, Picture, Point, Polygon, bounds};
use tiny_skia::{Color, FillRule, LineCap, Paint, PathBuilder, Pixmap, Stroke, Transform};

/// The longest side, pixels. A report may hold tens of thousands of pictures.
const SIDE: u32 = 128;
/// Around a layout, pixels.
const MARGIN: f64 = 4.0;
/// Greys of what is not known of a grid.
const UNKNOWN: u8 = 205;

/// A picture as an adapter shows it.
pub fn of_picture(picture: Picture<'_>) -> Option<String> {
    let pixels = ImageBuffer::<Rgb<u8>, _>::from_raw(picture.width(), picture.height(), picture.rgb())?;
    let (width, height) = sides(picture.width(), picture.height());
    let small = imageops::thumbnail(&pixels, width, height);
    png(width, height, &small, ExtendedColorType::Rgb8)
}

/// A grid, the darker the more is in the way.
pub fn of_grid(grid: &Grid) -> Option<String> {
    let grey = |cell: &planform_sdk::Cell| {
        cell.occupancy().map_or(UNKNOWN, |percent| 255 - (u32::from(percent.min(100)) * 255 / 100) as u8)
    };
    let rows = grid.cells().chunks_exact(grid.width() as usize).rev();
    let pixels = rows.flatten().map(grey).collect();
    let pixels = GrayImage::from_raw(grid.width(), grid.height(), pixels)?;
    let (width, height) = sides(grid.width(), grid.height());
    png(width, height, &imageops::thumbnail(&pixels, width, height), ExtendedColorType::L8)
}

/// The sides of a picture made so small that it fits.
fn sides(width: u32, height: u32) -> (u32, u32) {
    let longest = u64::from(width.max(height).max(SIDE));
    let small = |side: u32| (u64::from(side) * u64::from(SIDE) / longest).max(1) as u32;
    (small(width), small(height))
}

/// The rooms, walls and doors of a layout.
pub fn of_layout(layout: &Layout) -> Option<String> {
    let corners = layout.rooms.iter().flat_map(|r| r.inner.rings().flatten().copied());
    let ends = layout.walls.iter().flat_map(|w| [w.line.a, w.line.b]);
    let (least, most) = bounds(corners.chain(ends))?;
    let (width, height) = (most.x - least.x, most.y - least.y);
    let scale = (f64::from(SIDE) - 2.0 * MARGIN) / width.max(height).max(1e-6);
    let pixels = |metres: f64| (metres * scale + 2.0 * MARGIN).ceil().clamp(1.0, f64::from(SIDE)) as u32;
    let mut picture = Pixmap::new(pixels(width), pixels(height))?;
    picture.fill(Color::WHITE);
    let place = |p: Point| ((p.x - least.x) * scale + MARGIN, (most.y - p.y) * scale + MARGIN);
    for room in &layout.rooms {
        fill(&mut picture, &room.inner, &place);
    }
    for wall in &layout.walls {
        let width = (wall.thickness * scale).clamp(0.8, 6.0);
        draw(&mut picture, [place(wall.line.a), place(wall.line.b)], [60, 60, 60], width);
    }
    for opening in &layout.openings {
        draw(&mut picture, [place(opening.segment.a), place(opening.segment.b)], [230, 140, 20], 2.0);
    }
    // It is opaque throughout.
    let rgb: Vec<u8> = picture.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
    png(picture.width(), picture.height(), &rgb, ExtendedColorType::Rgb8)
}

fn fill(picture: &mut Pixmap, polygon: &Polygon, place: &dyn Fn(Point) -> (f64, f64)) {
    let mut path = PathBuilder::new();
    for ring in polygon.rings() {
        for (i, point) in ring.iter().enumerate() {
            let (x, y) = place(*point);
            if i == 0 { path.move_to(x as f32, y as f32) } else { path.line_to(x as f32, y as f32) }
        }
        path.close();
    }
    if let Some(path) = path.finish() {
        let paint = paint([205, 222, 240]);
        picture.fill_path(&path, &paint, FillRule::EvenOdd, Transform::identity(), None);
    }
}

fn draw(picture: &mut Pixmap, [a, b]: [(f64, f64); 2], colour: [u8; 3], width: f64) {
    let mut path = PathBuilder::new();
    path.move_to(a.0 as f32, a.1 as f32);
    path.line_to(b.0 as f32, b.1 as f32);
    let stroke = Stroke { width: width as f32, line_cap: LineCap::Square, ..Stroke::default() };
    if let Some(path) = path.finish() {
        picture.stroke_path(&path, &paint(colour), &stroke, Transform::identity(), None);
    }
}

fn paint([r, g, b]: [u8; 3]) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, 255);
    paint
}

fn png(width: u32, height: u32, pixels: &[u8], colours: ExtendedColorType) -> Option<String> {
    let mut bytes = vec![];
    let encoder = PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive);
    encoder.write_image(pixels, width, height, colours).ok()?;
    Some(BASE64_STANDARD.encode(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Cell, Pose};

    fn picture(thumbnail: Option<String>) -> image::RgbaImage {
        let bytes = BASE64_STANDARD.decode(thumbnail.unwrap()).unwrap();
        image::load_from_memory(&bytes).unwrap().to_rgba8()
    }

    #[test]
    fn grids_are_shown_the_right_way_up() {
        let mut cells = vec![Cell::FREE; 400 * 100];
        cells[..400 * 50].fill(Cell::OCCUPIED);
        let grid = Grid::new(400, 100, 0.05, Pose::default(), cells).unwrap();
        let small = picture(of_grid(&grid));
        assert_eq!(small.dimensions(), (128, 32));
        assert_eq!((small.get_pixel(64, 4).0[0], small.get_pixel(64, 28).0[0]), (255, 0));
    }

    #[test]
    fn layouts_show_their_rooms() {
        let corners = [(0.0, 0.0), (8.0, 0.0), (8.0, 4.0), (0.0, 4.0)].map(|(x, y)| Point::new(x, y));
        let inner = Polygon { exterior: corners.to_vec(), ..Polygon::default() };
        let room = planform_sdk::Room {
            id: 1,
            name: None,
            stated_area: None,
            state: planform_sdk::RoomState::Complete,
            centre: inner.clone(),
            inner,
        };
        let small = picture(of_layout(&Layout { rooms: vec![room], ..Layout::default() }));
        assert_eq!(small.dimensions(), (128, 68));
        assert_eq!(small.get_pixel(64, 34).0, [205, 222, 240, 255]);
        assert_eq!(small.get_pixel(1, 1).0, [255; 4]);
        assert_eq!(of_layout(&Layout::default()), None);
    }
}
