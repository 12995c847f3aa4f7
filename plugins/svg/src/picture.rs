//! The occupancy grid as a picture under the drawing.

use crate::element::{layer, number};
use crate::sheet::Sheet;
use base64::{Engine, engine::general_purpose::STANDARD};
use planform_sdk::{ErrorKind, Grid, PluginError, Point};
use svg::node::element::{Group, Image};

/// Most pixels on one side: what browsers and Inkscape still show.
const MAX_SIDE: u32 = 8192;

/// Palette index of what is unknown, after 0 to 100 percent occupied.
const UNKNOWN: u8 = 101;

/// The part of a grid that holds all its known cells: columns and rows, the last ones excluded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    left: u32,
    bottom: u32,
    right: u32,
    top: u32,
}

impl Part {
    /// The smallest part with all known cells, or `None` when there are none.
    pub fn known(grid: &Grid) -> Option<Self> {
        let mut part = Self { left: u32::MAX, bottom: u32::MAX, right: 0, top: 0 };
        for (y, row) in (0..).zip(grid.cells().chunks_exact(grid.width() as usize)) {
            for (x, _) in (0..).zip(row).filter(|(_, cell)| !cell.is_unknown()) {
                part = Self {
                    left: part.left.min(x),
                    bottom: part.bottom.min(y),
                    right: part.right.max(x + 1),
                    top: part.top.max(y + 1),
                };
            }
        }
        (part.right > 0).then_some(part)
    }

    /// Its corners in cell coordinates.
    pub fn corners(&self) -> [Point; 4] {
        let [l, b, r, t] = [self.left, self.bottom, self.right, self.top].map(f64::from);
        [Point::new(l, b), Point::new(r, b), Point::new(r, t), Point::new(l, t)]
    }

    fn size(&self) -> (u32, u32) {
        (self.right - self.left, self.top - self.bottom)
    }
}

/// The layer `grid`: the part as an embedded PNG, black where occupied, clear where unknown.
pub fn draw(grid: &Grid, part: &Part, sheet: &Sheet) -> Result<Group, PluginError> {
    let (width, height) = part.size();
    // Several cells share a pixel when the picture would be too large.
    let step = width.max(height).div_ceil(MAX_SIDE);
    let (columns, rows) = (width.div_ceil(step), height.div_ceil(step));
    let png = encode(&pixels(grid, part, step), columns, rows)
        .map_err(|e| PluginError::new(ErrorKind::Io, format!("the grid's picture cannot be made: {e}")))?;
    let image = Image::new()
        .set("class", "grid")
        .set("width", columns)
        .set("height", rows)
        .set("preserveAspectRatio", "none")
        .set("image-rendering", "optimizeSpeed")
        .set("transform", transform(grid, part, step, rows, sheet))
        .set("xlink:href", format!("data:image/png;base64,{}", STANDARD.encode(png)));
    Ok(layer("grid").add(image))
}

/// From pixels (right, down) to the sheet: the grid's pose, with the picture's lower left corner at the part's.
fn transform(grid: &Grid, part: &Part, step: u32, rows: u32, sheet: &Sheet) -> String {
    let step = f64::from(step);
    let (left, bottom) = (f64::from(part.left), f64::from(part.bottom));
    let corner = sheet.place(grid.to_map(Point::new(left, bottom + step * f64::from(rows))));
    let (sin, cos) = grid.origin().yaw.sin_cos();
    let pixel = grid.resolution() * step;
    // More digits than lengths have: they are multiplied by thousands of pixels.
    let turn = [pixel * cos, -pixel * sin, pixel * sin, pixel * cos].map(|v| format!("{v:.9}")).join(" ");
    format!("matrix({turn} {} {})", number(corner.x), number(corner.y))
}

/// Palette indices row by row from the top.
fn pixels(grid: &Grid, part: &Part, step: u32) -> Vec<u8> {
    let (width, height) = part.size();
    let (columns, rows) = (width.div_ceil(step), height.div_ceil(step));
    let mut pixels = Vec::with_capacity(columns as usize * rows as usize);
    for row in (0..rows).rev() {
        let y = part.bottom + row * step;
        pixels.extend((0..columns).map(|c| pixel(grid, part.left + c * step, y, step)));
    }
    pixels
}

/// The most occupied of the known cells of a pixel, so that thin walls stay.
fn pixel(grid: &Grid, x: u32, y: u32, step: u32) -> u8 {
    let cells = (y..y + step).flat_map(|y| (x..x + step).map(move |x| (x, y)));
    cells.filter_map(|(x, y)| grid.cell(x.into(), y.into()).occupancy()).max().unwrap_or(UNKNOWN)
}

fn encode(pixels: &[u8], width: u32, height: u32) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    // The only one whose bytes do not hang on which deflate library the rest of a program brings along.
    encoder.set_compression(png::Compression::Fast);
    let grey = (0..=100_u32).map(|percent| (255 - percent * 255 / 100) as u8);
    encoder.set_palette(grey.chain([205]).flat_map(|g| [g, g, g]).collect::<Vec<_>>());
    encoder.set_trns([vec![255; UNKNOWN.into()], vec![0]].concat());
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Cell, Pose};

    /// 4 x 3 cells, of which the upper right 2 x 2 are known.
    fn grid(yaw: f64) -> Grid {
        let mut cells = vec![Cell::UNKNOWN; 12];
        (cells[6], cells[7], cells[10], cells[11]) =
            (Cell::FREE, Cell::OCCUPIED, Cell::percent(50), Cell::FREE);
        Grid::new(4, 3, 0.5, Pose { x: 10.0, y: 20.0, yaw }, cells).unwrap()
    }

    #[test]
    fn unknown_margins_are_cut() {
        assert_eq!(Part::known(&grid(0.0)), Some(Part { left: 2, bottom: 1, right: 4, top: 3 }));
        let unknown = Grid::new(1, 1, 1.0, Pose::default(), vec![Cell::UNKNOWN]).unwrap();
        assert_eq!(Part::known(&unknown), None);
    }

    #[test]
    fn first_pixels_are_the_top_row() {
        let g = grid(0.0);
        assert_eq!(pixels(&g, &Part::known(&g).unwrap(), 1), [50, 0, 0, 100]);
        assert_eq!(pixels(&g, &Part::known(&g).unwrap(), 2), [100]);
        assert_eq!(pixels(&g, &Part { left: 0, bottom: 0, right: 2, top: 1 }, 1), [UNKNOWN, UNKNOWN]);
    }

    #[test]
    fn picture_lies_where_the_grid_lies() {
        let g = grid(std::f64::consts::FRAC_PI_2);
        let part = Part::known(&g).unwrap();
        let sheet = Sheet { origin: Point::new(0.0, 30.0), width: 30.0, height: 30.0 };
        let text = transform(&g, &part, 1, 2, &sheet);
        let numbers: Vec<f64> =
            text["matrix(".len()..text.len() - 1].split(' ').map(|n| n.parse().unwrap()).collect();
        let &[a, b, c, d, e, f] = numbers.as_slice() else { panic!("six numbers") };
        // The picture's lower right corner is the cell corner (4, 1).
        let p = Point::new(a * 2.0 + c * 2.0 + e, b * 2.0 + d * 2.0 + f);
        assert!(p.distance(sheet.place(g.to_map(Point::new(4.0, 1.0)))) < 1e-6, "{p:?}");
    }
}
