//! Buildings as people draw them: blueprints and evacuation plans, with their truth.

mod damage;
mod dimensions;
mod doors;
mod drawing;
mod evacuation;
mod fixtures;
mod floors;
mod furnish;
mod gaps;
mod labels;
mod letters;
mod look;
mod margin;
mod paper;
mod places;
mod rooms;
mod signs;
mod site;
mod surface;
mod truth;
mod view;
mod walls;

pub use truth::{PlanLeaf, PlanName, PlanSymbol, PlanText, PlanTextRole, PlanTruth};

use crate::raster::{Frame, Labels};
use crate::rng::Rng;
use damage::Damage;
use drawing::Drawing;
use image::RgbImage;
use look::Look;
use paper::Paper;
use planform_sdk::Point;
use site::{Site, move_layout};

/// Buildings that are drawn before giving up: not every one fits one of the usual sheets.
const ATTEMPTS: u64 = 40;

/// What a plan is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlanStyle {
    /// An architect's: dimensions, furniture, a title block.
    Blueprint,
    /// What hangs in corridors: escape routes and safety signs.
    Evacuation,
}

/// A plan: a picture of a sheet of paper with a building on it, as a scanner, a camera or a program made it.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The picture.
    pub picture: RgbImage,
    /// The bytes of the file, if that is a JPEG: [`picture`](Self::picture) is what they decode to.
    pub jpeg: Option<Vec<u8>>,
    /// Pixels per inch of paper, if the file says so.
    pub dpi: Option<f64>,
    /// What is true of it.
    pub truth: PlanTruth,
}

impl Plan {
    /// The plan of this seed; the same seed and style give the same plan. `None` if none of forty buildings fits a
    /// sheet.
    ///
    /// ```
    /// # use planform_synth::{Plan, PlanStyle};
    /// let plan = Plan::draw(3, PlanStyle::Evacuation).unwrap();
    /// assert!(plan.truth.symbols.iter().any(|s| s.kind == "fire-extinguisher"));
    /// ```
    pub fn draw(seed: u64, style: PlanStyle) -> Option<Self> {
        (0..ATTEMPTS).find_map(|attempt| Self::attempt(seed + (attempt << 32), style))
    }

    fn attempt(seed: u64, style: PlanStyle) -> Option<Self> {
        let mut rng = Rng::new(seed, if style == PlanStyle::Blueprint { 300 } else { 301 });
        let mut look = Look::draw(style, &mut rng);
        let damage = Damage::draw(style, &mut rng);
        let site = Site::new(&site::building(seed, look.tells_scale(), &mut rng));
        let (low, high) = site.bounds();
        let paper = Paper::draw((high.x - low.x, high.y - low.y), &mut look, damage.skew, &mut rng)?;
        let (dx, dy) = (paper.place.x - low.x, paper.place.y - low.y);
        let site = site.moved(|p| Point::new(p.x + dx, p.y + dy));
        let dpi = look.says_dpi.then_some(paper.view.dpi);
        let mut drawing = Drawing::new(site, look, paper, rng)?;
        draw(&mut drawing);
        Self::finished(drawing, &damage, dpi, seed)
    }

    fn finished(mut drawing: Drawing, damage: &Damage, dpi: Option<f64>, seed: u64) -> Option<Self> {
        drawing.picture.put(&drawing.letters);
        let (width, height) = (drawing.view.width, drawing.view.height);
        let picture = RgbImage::from_raw(width, height, drawing.picture.colours())?;
        let (picture, jpeg) = damage.apply(picture, dpi, seed);
        Some(Self { picture, jpeg, dpi, truth: truth(drawing) })
    }

    /// The room of every pixel up to the middle of the walls, row by row from the bottom, 0 where there is none.
    pub fn labels(&self) -> Labels {
        let frame = Frame {
            origin: Point::new(0.0, 0.0),
            resolution: self.truth.metres_per_pixel,
            width: self.picture.width(),
            height: self.picture.height(),
        };
        let mut rooms = vec![0; frame.len()];
        for room in &self.truth.layout.rooms {
            frame.fill(room.centre.rings(), |i| rooms[i] = room.id);
        }
        Labels { width: frame.width, height: frame.height, rooms }
    }
}

/// Draws layer by layer. What comes earlier takes its place first.
fn draw(drawing: &mut Drawing) {
    drawing.picture.flood([255; 3]);
    let purposes = rooms::plan(drawing);
    let gaps = gaps::plan(drawing, &purposes);
    floors::draw(drawing, &purposes);
    let evacuation = drawing.look.style == PlanStyle::Evacuation;
    if evacuation {
        evacuation::routes(drawing, &purposes);
    }
    walls::draw(drawing, &gaps);
    walls::windows(drawing, &gaps);
    doors::draw(drawing, &gaps);
    fixtures::draw(drawing, &purposes);
    labels::draw(drawing, &purposes);
    if evacuation {
        evacuation::draw(drawing, &purposes, &gaps);
    }
    furnish::draw(drawing, &purposes);
    dimensions::draw(drawing);
    margin::draw(drawing);
}

fn truth(drawing: Drawing) -> PlanTruth {
    let view = drawing.view;
    let mut layout = drawing.site.layout;
    move_layout(&mut layout, &|p| view.point(p));
    for room in &mut layout.rooms {
        let name = drawing.names.iter().find(|n| n.room == room.id);
        let words = name.map(|n| [&n.name, &n.number].into_iter().flatten().cloned().collect::<Vec<_>>());
        room.name = words.filter(|w| !w.is_empty()).map(|w| w.join(" "));
    }
    PlanTruth {
        metres_per_pixel: view.metres_per_pixel(),
        skew: view.skew,
        tells_scale: drawing.look.tells_scale(),
        layout,
        names: drawing.names,
        texts: drawing.texts,
        symbols: drawing.symbols,
        walls: drawing.walls.covered(),
        letters: drawing.letters.covered(),
    }
}
