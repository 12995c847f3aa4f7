//! Whole sheets, drawn here.

use super::*;
use crate::stages::Unwatched;
use image::{GrayImage, Rgb, RgbImage};

const METRES: f64 = 0.02;

struct Paper(RgbImage);

impl Paper {
    fn new(width: u32, height: u32) -> Self {
        Self(RgbImage::from_pixel(width, height, Rgb([255; 3])))
    }

    fn fill(&mut self, x: std::ops::Range<u32>, y: std::ops::Range<u32>, colour: [u8; 3]) {
        y.for_each(|y| x.clone().for_each(|x| self.0.put_pixel(x, y, Rgb(colour))));
    }

    fn line(&mut self, from: [f64; 2], to: [f64; 2]) {
        let (along, length) = plane::direction(from, to);
        for k in 0..=(2.0 * length) as u32 {
            let [x, y] = plane::moved(from, along, f64::from(k) / 2.0).map(|v| v as u32);
            self.fill(x..x + 2, y..y + 2, [0; 3]);
        }
    }

    fn quarter(&mut self, hinge: [f64; 2], radius: f64, from: f64) {
        let at = |k: u32| {
            plane::moved(hinge, plane::unit(from + f64::from(k) / 40.0 * std::f64::consts::FRAC_PI_2), radius)
        };
        (0..40).for_each(|k| self.line(at(k), at(k + 1)));
    }

    /// A horizontal wall of 0.2 m with a gap of 0.9 m, and the leaf that swings there.
    fn with_door() -> Self {
        let mut paper = Self::new(400, 300);
        paper.fill(20..180, 150..160, [0; 3]);
        paper.fill(225..380, 150..160, [0; 3]);
        paper.line([181.0, 149.0], [181.0, 105.0]);
        paper.quarter([180.0, 149.0], 44.0, -std::f64::consts::FRAC_PI_2);
        paper
    }

    fn read(self, metres_per_pixel: Option<f64>) -> Symbols {
        let aside = Mask::empty(self.0.width(), self.0.height());
        self.read_beside(aside, metres_per_pixel)
    }

    fn read_beside(self, aside: Mask, metres_per_pixel: Option<f64>) -> Symbols {
        self.read_by(&Library::builtin().expect("it is sound"), aside, metres_per_pixel)
    }

    fn read_by(self, library: &Library, aside: Mask, metres_per_pixel: Option<f64>) -> Symbols {
        let Self(colour) = self;
        let ink = Mask {
            width: colour.width(),
            height: colour.height(),
            set: colour.pixels().map(|p| p.0[0] < 128 && p.0[1] < 128).collect(),
        };
        let page_size = [colour.width(), colour.height()];
        let grey = GrayImage::from_pixel(colour.width(), colour.height(), image::Luma([255]));
        let sheet = Sheet { colour, grey, ink: ink.clone(), aside, turned: 0.0, page_size };
        find(&sheet, &ink, library, metres_per_pixel, &mut Unwatched)
    }
}

#[test]
fn a_door_is_found_measured_and_erased_and_its_wall_stays() {
    let found = Paper::with_door().read(Some(METRES));
    assert_eq!(found.symbols.len(), 1, "{:?}", found.symbols);
    let door = &found.symbols[0];
    assert_eq!(door.kind, "door");
    assert!(plane::distance(door.centre, [202.5, 155.0]) < 4.0, "{door:?}");
    assert!((door.width - 45.0).abs() < 4.0 && (door.height - 10.0).abs() < 3.0, "{door:?}");
    assert!(plane::distance(door.leaves[0].open, [181.0, 105.0]) < 5.0, "{door:?}");
    assert!(found.erase.get(182, 120) && found.erase.get(212, 118));
    let wall = (20..178).chain(228..380).all(|x| (150..160).all(|y| !found.erase.get(x, y)));
    assert!(wall, "the wall loses nothing");
}

#[test]
fn a_round_table_is_no_door() {
    let mut paper = Paper::new(400, 300);
    paper.fill(20..380, 150..160, [0; 3]);
    (0..4).for_each(|k| paper.quarter([200.0, 100.0], 44.0, f64::from(k) * std::f64::consts::FRAC_PI_2));
    assert!(paper.read(Some(METRES)).symbols.is_empty());
}

#[test]
fn a_lift_and_stairs_are_found_by_their_lines() {
    let mut paper = Paper::new(500, 300);
    let box_at = [[50.0, 50.0], [140.0, 50.0], [140.0, 130.0], [50.0, 130.0]];
    (0..4).for_each(|i| paper.line(box_at[i], box_at[(i + 1) % 4]));
    paper.line(box_at[0], box_at[2]);
    paper.line(box_at[1], box_at[3]);
    (0..9)
        .for_each(|k| paper.line([250.0 + 14.0 * f64::from(k), 100.0], [250.0 + 14.0 * f64::from(k), 160.0]));
    // Stairs and lifts are measured by the scale alone.
    let found = paper.read(Some(METRES));
    let mut kinds: Vec<_> = found.symbols.iter().map(|s| s.kind.as_str()).collect();
    kinds.sort_unstable();
    assert_eq!(kinds, ["lift", "stairs"]);
    assert!(found.erase.get(95, 90) && !found.erase.get(50, 90), "the diagonals go, the box stays");
    assert!(found.erase.get(306, 130));
}

fn three_signs() -> Paper {
    let files = ["first-aid.svg", "fire-extinguisher.svg", "emergency-exit-left.svg"];
    signs(&files.map(|file| planform_templates::drawing(file).expect("built in")))
}

/// Signs in a row, 40 pixels large.
fn signs(drawings: &[&str]) -> Paper {
    let mut paper = Paper::new(400, 200);
    for (i, svg) in drawings.iter().enumerate() {
        let tree = resvg::usvg::Tree::from_str(svg, &resvg::usvg::Options::default()).expect("sound");
        let mut sign = resvg::tiny_skia::Pixmap::new(40, 40).expect("small");
        resvg::render(&tree, resvg::tiny_skia::Transform::from_scale(0.4, 0.4), &mut sign.as_mut());
        for (k, p) in sign.pixels().iter().enumerate() {
            let (x, y) = (50 + 100 * i as u32 + k as u32 % 40, 60 + k as u32 / 40);
            paper.0.put_pixel(x, y, Rgb([p.red(), p.green(), p.blue()]));
        }
    }
    paper
}

#[test]
fn signs_of_a_legend_are_left_out() {
    let mut aside = Mask::empty(400, 200);
    aside.set.iter_mut().enumerate().for_each(|(i, s)| *s = i % 400 > 130 && i % 400 < 210);
    let found = three_signs().read_beside(aside, None).symbols;
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found.iter().all(|s| s.kind != "fire-extinguisher"));
}

#[test]
fn signs_are_told_apart() {
    let mut found = three_signs().read(None).symbols;
    found.sort_by(|a, b| a.centre[0].total_cmp(&b.centre[0]));
    let kinds: Vec<_> = found.iter().map(|s| s.kind.as_str()).collect();
    assert_eq!(kinds, ["first-aid", "fire-extinguisher", "emergency-exit"]);
    assert!(plane::distance(found[0].centre, [70.0, 80.0]) < 3.0);
}

/// A template of one's own, of this size on paper and of no colour.
fn own_library(svg: &str) -> Library {
    let folder = tempfile::tempdir().expect("a folder");
    let table = "[[symbol]]\nkind='camera'\nfiles=['camera.svg']\naction='erase'\npaper_mm=[2.0,20.0]\n\
                 turned='upright'\n";
    std::fs::write(folder.path().join("symbols.toml"), table).expect("written");
    std::fs::write(folder.path().join("camera.svg"), svg).expect("written");
    Library::with_folder(folder.path()).expect("it is sound")
}

#[test]
fn signs_of_ones_own_need_no_colour() {
    let camera = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><rect width='100' height='100'/>\
                  <circle cx='35' cy='55' r='25' fill='#fff'/><path d='M60 20H90V50Z' fill='#fff'/></svg>";
    let library = own_library(camera);
    let found = signs(&[camera]).read_by(&library, Mask::empty(400, 200), None).symbols;
    let [sign] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!(sign.kind, "camera");
    assert!(plane::distance(sign.centre, [70.0, 80.0]) < 3.0, "{sign:?}");
    let mut square = Paper::new(400, 200);
    square.fill(50..90, 60..100, [0; 3]);
    assert!(square.read_by(&library, Mask::empty(400, 200), None).symbols.is_empty());
}

#[test]
fn an_empty_sheet_shows_nothing() {
    assert!(Paper::new(1, 1).read(None).symbols.is_empty());
    assert!(Paper::new(300, 200).read(Some(f64::NAN)).symbols.is_empty());
}

/// A wall of 0.2 m with a gap of 1.6 m between x = 150 and 230, filled by these two lines between.
fn gap(lines: [[[f64; 2]; 2]; 2]) -> Symbols {
    let mut paper = Paper::new(400, 300);
    paper.fill(20..150, 150..160, [0; 3]);
    paper.fill(230..380, 150..160, [0; 3]);
    lines.iter().for_each(|[a, b]| paper.line(*a, *b));
    paper.read(Some(METRES))
}

#[test]
fn two_leaves_behind_each_other_slide_and_two_panes_do_not() {
    let sliding = gap([[[150.0, 152.0], [194.0, 152.0]], [[186.0, 157.0], [229.0, 157.0]]]);
    let kinds: Vec<&str> = sliding.symbols.iter().map(|s| s.kind.as_str()).collect();
    assert_eq!(kinds, ["sliding-door"]);
    let door = &sliding.symbols[0];
    assert!((door.centre[0] - 190.0).abs() < 3.0 && (door.width - 80.0).abs() < 8.0, "{door:?}");
    let window = gap([[[150.0, 150.0], [229.0, 150.0]], [[150.0, 158.0], [229.0, 158.0]]]);
    let kinds: Vec<&str> = window.symbols.iter().map(|s| s.kind.as_str()).collect();
    assert_eq!(kinds, ["window"]);
}

#[test]
fn a_window_with_a_desk_before_it_is_one() {
    let mut paper = Paper::new(400, 300);
    paper.fill(20..150, 150..160, [0; 3]);
    paper.fill(230..380, 150..160, [0; 3]);
    for y in [150.0, 154.0, 158.0, 162.0] {
        paper.line([150.0, y], [229.0, y]);
    }
    let found = paper.read(Some(METRES));
    assert!(found.symbols.iter().any(|s| s.kind == "window"), "{:?}", found.symbols);
}
