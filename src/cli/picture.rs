//! Paints what a step of the reconstruction found over a pale picture of the grid; writes the pictures of adapters.

use crate::reconstruct::{Drawing, Shape};
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageBuffer, ImageEncoder, ImageError, Rgb, imageops};
use planform_sdk::{Cell, Grid, Picture, Point, Polygon, Segment};
use std::ops::Range;
use tiny_skia::{FillRule, LineCap, Paint, PathBuilder, Pixmap, PremultipliedColorU8, Stroke, Transform};

/// Small maps are enlarged until their longest side has at least this many pixels.
const WANTED: f64 = 1600.0;
/// No side has more pixels.
const LONGEST: f64 = 2400.0;
/// No side of an adapter's picture has more pixels: it may show a large sheet of paper.
const LONGEST_OF_STAGE: u32 = 4000;
/// Cells around those that are known, as a share of the longest side.
const MARGIN: f64 = 0.02;
/// A cell is never enlarged to more pixels.
const LARGEST_CELL: f64 = 16.0;

const FREE: u8 = 255;
const UNKNOWN: u8 = 228;
const OCCUPIED: u8 = 150;

/// Opacity of an [`Shape::Area`].
const AREA_ALPHA: u8 = 110;

/// An adapter's picture as a PNG file, smaller if it is very large.
pub fn stage_png(picture: Picture<'_>) -> Result<Vec<u8>, ImageError> {
    let (width, height) = (picture.width(), picture.height());
    let shrunk = |side: u32| {
        let longest = u64::from(width.max(height).max(LONGEST_OF_STAGE));
        (u64::from(side) * u64::from(LONGEST_OF_STAGE) / longest).max(1) as u32
    };
    let pixels = ImageBuffer::<Rgb<u8>, _>::from_raw(width, height, picture.rgb());
    match pixels.filter(|_| width.max(height) > LONGEST_OF_STAGE) {
        None => rgb_png(width, height, picture.rgb()),
        Some(pixels) => {
            let small = imageops::thumbnail(&pixels, shrunk(width), shrunk(height));
            rgb_png(small.width(), small.height(), &small)
        }
    }
}

fn rgb_png(width: u32, height: u32, rgb: &[u8]) -> Result<Vec<u8>, ImageError> {
    let mut png = Vec::new();
    PngEncoder::new(&mut png).write_image(rgb, width, height, ExtendedColorType::Rgb8)?;
    Ok(png)
}

/// A picture of a grid, ready to be painted over.
pub struct Painter {
    background: Pixmap,
    view: View,
    /// Pixels per cell.
    scale: f64,
    /// From cells, y up, to pixels, y down.
    transform: Transform,
}

impl Painter {
    /// The picture of this grid as far as it is known; none if there is no memory for it.
    pub fn new(grid: &Grid) -> Option<Self> {
        let view = View::of(grid);
        let scale = scale(view.columns.len().max(view.rows.len()));
        let side = |cells: &Range<u32>| (cells.len() as f64 * scale).round().max(1.0) as u32;
        let background = background(grid, &view, side(&view.columns), side(&view.rows))?;
        let left = -f64::from(view.columns.start) * scale;
        let bottom = f64::from(background.height()) + f64::from(view.rows.start) * scale;
        let transform =
            Transform::from_row(scale as f32, 0.0, 0.0, -scale as f32, left as f32, bottom as f32);
        Some(Self { background, view, scale, transform })
    }

    /// The drawing over the grid, as a PNG file.
    pub fn png(&self, drawing: &Drawing) -> Result<Vec<u8>, ImageError> {
        let mut picture = self.background.clone();
        for shape in &drawing.shapes {
            self.paint(&mut picture, shape);
        }
        let mut png = Vec::new();
        let (width, height) = (picture.width(), picture.height());
        // The background is opaque, so premultiplied colours are the colours themselves.
        PngEncoder::new(&mut png).write_image(picture.data(), width, height, ExtendedColorType::Rgba8)?;
        Ok(png)
    }

    fn paint(&self, picture: &mut Pixmap, shape: &Shape) {
        match shape {
            Shape::Cells { cells, colour } => {
                cells.iter().for_each(|cell| self.paint_cell(picture, *cell, *colour))
            }
            Shape::Line { segment, colour, width } => self.paint_line(picture, segment, *colour, *width),
            Shape::Area { polygon, colour } => self.paint_area(picture, polygon, *colour),
        }
    }

    fn paint_cell(&self, picture: &mut Pixmap, (column, row): (u32, u32), [r, g, b]: [u8; 3]) {
        let Some(colour) = PremultipliedColorU8::from_rgba(r, g, b, 255) else { return };
        let (width, height) = (picture.width() as usize, picture.height() as usize);
        let (first_column, first_row) = (self.view.columns.start, self.view.rows.start);
        let (Some(column), Some(row)) = (column.checked_sub(first_column), row.checked_sub(first_row)) else {
            return;
        };
        for y in self.pixels_of(row, height) {
            let line = (height - 1 - y) * width;
            for x in self.pixels_of(column, width) {
                picture.pixels_mut()[line + x] = colour;
            }
        }
    }

    /// The pixels that a column or a row of the view covers, at least one unless it lies outside.
    fn pixels_of(&self, cell: u32, side: usize) -> Range<usize> {
        let start = (f64::from(cell) * self.scale) as usize;
        let end = ((f64::from(cell) + 1.0) * self.scale) as usize;
        start.min(side)..end.max(start + 1).min(side)
    }

    fn paint_line(&self, picture: &mut Pixmap, segment: &Segment, colour: [u8; 3], width: f64) {
        let mut path = PathBuilder::new();
        add_points(&mut path, &[segment.a, segment.b]);
        let stroke = Stroke { width: width as f32, line_cap: LineCap::Round, ..Stroke::default() };
        // The width is in pixels, so the path is transformed first and stroked then.
        if let Some(path) = path.finish().and_then(|p| p.transform(self.transform)) {
            picture.stroke_path(&path, &paint(colour, 255), &stroke, Transform::identity(), None);
        }
    }

    fn paint_area(&self, picture: &mut Pixmap, polygon: &Polygon, colour: [u8; 3]) {
        let mut path = PathBuilder::new();
        for ring in polygon.rings() {
            add_points(&mut path, ring);
            path.close();
        }
        if let Some(path) = path.finish() {
            picture.fill_path(&path, &paint(colour, AREA_ALPHA), FillRule::EvenOdd, self.transform, None);
        }
    }
}

/// The part of a grid that a picture shows.
struct View {
    columns: Range<u32>,
    rows: Range<u32>,
}

impl View {
    /// The known cells with a margin; all cells where none is known.
    fn of(grid: &Grid) -> Self {
        let (width, height) = (grid.width(), grid.height());
        let (mut columns, mut rows) = (width..0, height..0);
        for (row, cells) in (0..height).zip(grid.cells().chunks(width.max(1) as usize)) {
            let known = |cell: &Cell| cell.occupancy().is_some();
            let (Some(first), Some(last)) = (cells.iter().position(known), cells.iter().rposition(known))
            else {
                continue;
            };
            columns = columns.start.min(first as u32)..columns.end.max(last as u32 + 1);
            rows = rows.start.min(row)..row + 1;
        }
        if rows.is_empty() {
            return Self { columns: 0..width, rows: 0..height };
        }
        let margin = (columns.len().max(rows.len()) as f64 * MARGIN).ceil() as u32 + 1;
        let widened =
            |r: Range<u32>, side: u32| r.start.saturating_sub(margin)..r.end.saturating_add(margin).min(side);
        Self { columns: widened(columns, width), rows: widened(rows, height) }
    }
}

fn add_points(path: &mut PathBuilder, points: &[Point]) {
    let Some((first, rest)) = points.split_first() else { return };
    path.move_to(first.x as f32, first.y as f32);
    for p in rest {
        path.line_to(p.x as f32, p.y as f32);
    }
}

fn paint([r, g, b]: [u8; 3], alpha: u8) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, alpha);
    paint
}

/// Pixels per cell.
fn scale(longest: usize) -> f64 {
    let longest = longest as f64;
    let enlarged = (WANTED / longest).ceil().clamp(1.0, LARGEST_CELL);
    enlarged.min(LONGEST / longest)
}

/// The view of the grid in pale grey. Where several cells share a pixel the darkest shows, so that thin walls do not vanish.
fn background(grid: &Grid, view: &View, width: u32, height: u32) -> Option<Pixmap> {
    let mut picture = Pixmap::new(width, height)?;
    let columns = spans(&view.columns, width);
    let rows = spans(&view.rows, height);
    let places = rows.iter().rev().flat_map(|row| columns.iter().map(move |column| (column, row)));
    for (pixel, (column, row)) in picture.pixels_mut().iter_mut().zip(places) {
        let grey = darkest(grid, column, row);
        *pixel = PremultipliedColorU8::from_rgba(grey, grey, grey, 255)?;
    }
    Some(picture)
}

/// The cells that each pixel of a side shows.
fn spans(shown: &Range<u32>, pixels: u32) -> Vec<Range<i64>> {
    let (first, cells, pixels) = (i64::from(shown.start), shown.len() as i64, i64::from(pixels));
    let span = |p: i64| {
        let start = p * cells / pixels;
        first + start..first + ((p + 1) * cells / pixels).max(start + 1)
    };
    (0..pixels).map(span).collect()
}

fn darkest(grid: &Grid, columns: &Range<i64>, rows: &Range<i64>) -> u8 {
    let cells = rows.clone().flat_map(|row| columns.clone().map(move |column| grid.cell(column, row)));
    cells.map(grey).min().unwrap_or(UNKNOWN)
}

fn grey(cell: Cell) -> u8 {
    let Some(percent) = cell.occupancy() else { return UNKNOWN };
    FREE - (u16::from(percent) * u16::from(FREE - OCCUPIED) / 100) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{Rgba, RgbaImage};
    use planform_sdk::Pose;

    fn picture(width: u32, height: u32, cells: Vec<Cell>, shapes: Vec<Shape>) -> RgbaImage {
        let grid = Grid::new(width, height, 0.05, Pose::default(), cells).unwrap();
        let png = Painter::new(&grid).unwrap().png(&Drawing { shapes }).unwrap();
        image::load_from_memory(&png).unwrap().to_rgba8()
    }

    #[test]
    fn small_grids_are_enlarged_and_stand_upright() {
        let cells = vec![Cell::OCCUPIED, Cell::FREE, Cell::UNKNOWN, Cell::FREE];
        let red = Shape::Cells { cells: vec![(1, 1), (7, 7)], colour: [255, 0, 0] };
        let p = picture(2, 2, cells, vec![red]);
        assert_eq!(p.dimensions(), (32, 32));
        let grey = |v| Rgba([v, v, v, 255]);
        assert_eq!(*p.get_pixel(0, 31), grey(OCCUPIED), "the lower left cell is the first");
        assert_eq!((*p.get_pixel(31, 31), *p.get_pixel(0, 0)), (grey(FREE), grey(UNKNOWN)));
        assert_eq!(*p.get_pixel(31, 0), Rgba([255, 0, 0, 255]));
    }

    #[test]
    fn large_grids_are_bounded_and_keep_thin_walls() {
        let (width, height) = (9000, 10);
        let mut cells = vec![Cell::FREE; width * height];
        (0..height).for_each(|row| cells[row * width + 4501] = Cell::OCCUPIED);
        let p = picture(width as u32, height as u32, cells, vec![]);
        assert_eq!(p.width(), 2400);
        assert_eq!(p.pixels().filter(|p| p.0[0] == OCCUPIED).count() as u32, p.height());
    }

    #[test]
    fn a_small_building_in_a_large_grid_fills_the_picture() {
        let mut cells = vec![Cell::UNKNOWN; 1000 * 800];
        (0..100).for_each(|i| cells[(300 + i) * 1000 + 500 + i] = Cell::OCCUPIED);
        let red = Shape::Cells { cells: vec![(500, 300), (0, 0), (999, 799)], colour: [255, 0, 0] };
        let square =
            [[510.0, 300.0], [520.0, 300.0], [520.0, 305.0], [510.0, 305.0]].map(Point::from).to_vec();
        let area = Shape::Area { polygon: Polygon::new(square, vec![]), colour: [0, 0, 255] };
        let p = picture(1000, 800, cells, vec![red, area]);
        // 100 cells and 3 on each side, 16 pixels each.
        assert_eq!(p.dimensions(), (1696, 1696));
        let red: Vec<_> = p.enumerate_pixels().filter(|(.., p)| p.0 == [255, 0, 0, 255]).collect();
        assert_eq!((red.len(), red[0].0, red[0].1), (256, 48, 1696 - 64));
        let [r, _, b, _] = p.get_pixel(48 + 15 * 16, 1696 - 48 - 2 * 16).0;
        assert!(b > r, "the area moves with the cells");
        assert_eq!(p.get_pixel(48 + 15 * 16, 1696 - 48 - 6 * 16).0[0], UNKNOWN);
    }

    #[test]
    fn large_pictures_of_stages_are_made_smaller() {
        let size = |width: u32, height: u32| {
            let rgb = vec![7; (width * height * 3) as usize];
            let png = stage_png(Picture::new(width, height, &rgb).unwrap()).unwrap();
            let shown = image::load_from_memory(&png).unwrap().to_rgb8();
            assert!(shown.pixels().all(|p| p.0 == [7; 3]));
            shown.dimensions()
        };
        assert_eq!(size(3, 2), (3, 2));
        assert_eq!(size(8000, 100), (4000, 50));
        assert_eq!(size(1, 5000), (1, 4000));
    }

    #[test]
    fn areas_have_their_holes() {
        let square = |a: f64, b: f64| [[a, a], [b, a], [b, b], [a, b]].map(Point::from).to_vec();
        let polygon = Polygon::new(square(0.0, 6.0), vec![square(2.0, 4.0)]);
        let area = Shape::Area { polygon, colour: [0, 0, 255] };
        let p = picture(6, 6, vec![Cell::FREE; 36], vec![area]);
        assert!(p.get_pixel(8, 8).0[0] < 200 && p.get_pixel(48, 48).0[0] == FREE);
    }

    #[test]
    fn shapes_that_are_nowhere_are_left_out() {
        let segment = Segment::new(Point::new(f64::NAN, 0.0), Point::new(1e300, 1e300));
        let line = Shape::Line { segment, colour: [255, 0, 0], width: 1.0 };
        let area = Shape::Area { polygon: Polygon::default(), colour: [255, 0, 0] };
        let p = picture(1, 1, vec![Cell::FREE], vec![line, area]);
        assert!(p.pixels().all(|p| p.0[0] == p.0[1]));
    }
}
