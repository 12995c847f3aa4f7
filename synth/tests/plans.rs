//! Drawn plans and their truth.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

use image::{GrayImage, RgbImage};
use planform_sdk::{Point, Pose};
use planform_synth::{Plan, PlanStyle, PlanSymbol, parallel_map};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use std::sync::LazyLock;

const STYLES: [PlanStyle; 2] = [PlanStyle::Blueprint, PlanStyle::Evacuation];

/// Ten plans of each style, drawn once for all tests.
static PLANS: LazyLock<Vec<Plan>> = LazyLock::new(|| {
    let both: Vec<(u64, PlanStyle)> = (1..11).flat_map(|seed| STYLES.map(|style| (seed, style))).collect();
    parallel_map(&both, |&(seed, style)| Plan::draw(seed, style).unwrap())
});

#[test]
fn the_seed_decides() {
    for style in STYLES {
        assert_eq!(Plan::draw(5, style), Plan::draw(5, style));
        assert_ne!(Plan::draw(5, style).unwrap().picture, Plan::draw(6, style).unwrap().picture);
    }
}

#[test]
fn sheets_are_of_a_usual_size_and_scale() {
    for plan in &*PLANS {
        let pixels = plan.picture.width() * plan.picture.height();
        assert!((1_900_000..6_300_000).contains(&pixels), "{pixels}");
        assert!((0.01..0.035).contains(&plan.truth.metres_per_pixel), "{}", plan.truth.metres_per_pixel);
        assert!(plan.dpi.is_none_or(|dpi| (90.0..260.0).contains(&dpi)));
    }
}

#[test]
fn a_written_scale_agrees_with_the_pixels() {
    let mut written = 0;
    for plan in &*PLANS {
        let texts = plan.truth.texts.iter();
        let scale = texts.filter_map(|t| t.content.split_once("1:")?.1.parse::<f64>().ok()).next();
        if let Some(denominator) = scale {
            let metres = denominator * 0.0254 / plan.dpi.unwrap();
            assert!((metres / plan.truth.metres_per_pixel - 1.0).abs() < 1e-9);
            written += 1;
        }
    }
    assert!(written > 3);
}

#[test]
fn every_kind_of_symbol_is_drawn_and_no_other() {
    let table: BTreeSet<&str> = [
        "door",
        "double-door",
        "sliding-door",
        "window",
        "stairs",
        "lift",
        "toilet",
        "sink",
        "emergency-exit",
        "first-aid",
        "fire-extinguisher",
        "fire-hose-reel",
        "fire-alarm-call-point",
        "assembly-point",
        "you-are-here",
    ]
    .into();
    let drawn: BTreeSet<&str> =
        PLANS.iter().flat_map(|p| &p.truth.symbols).map(|s| s.kind.as_str()).collect();
    assert_eq!(drawn, table);
}

#[test]
fn words_run_in_all_four_directions() {
    let mut counts = [0; 4];
    for plan in &*PLANS {
        for text in &plan.truth.texts {
            let turns = (text.pose.yaw - plan.truth.skew) / FRAC_PI_2;
            assert!((turns - turns.round()).abs() < 1e-9, "{}", text.content);
            counts[turns.round().rem_euclid(4.0) as usize] += 1;
        }
    }
    assert!(counts.iter().all(|&c| c > 10), "{counts:?}");
}

/// Mean brightness where the mask says `wanted`.
fn brightness(picture: &RgbImage, mask: &GrayImage, wanted: bool) -> f64 {
    let pixels = picture.pixels().zip(mask.pixels()).filter(|(_, m)| (m.0[0] > 0) == wanted);
    let (sum, count) = pixels.fold((0u64, 0u64), |(sum, count), (p, _)| (sum + u64::from(p.0[1]), count + 1));
    sum as f64 / count.max(1) as f64
}

#[test]
fn the_masks_lie_on_the_ink() {
    let (mut walls, mut letters) = (0, 0);
    for plan in &*PLANS {
        let contrast =
            |mask| (brightness(&plan.picture, mask, true) - brightness(&plan.picture, mask, false)).abs();
        walls += usize::from(contrast(&plan.truth.walls) > 30.0);
        letters += usize::from(contrast(&plan.truth.letters) > 60.0);
    }
    // White letters of a header, and walls filled with a light grey, differ less.
    assert!(walls * 10 >= PLANS.len() * 8, "{walls}");
    assert!(letters * 10 >= PLANS.len() * 8, "{letters}");
}

#[test]
fn a_skewed_sheet_skews_its_truth() {
    let askew: Vec<&Plan> = PLANS.iter().filter(|p| p.truth.skew.abs() > 0.005).collect();
    assert!(askew.len() > 5);
    for plan in askew {
        let off = |a: f64| (a - plan.truth.skew + FRAC_PI_4).rem_euclid(FRAC_PI_2) - FRAC_PI_4;
        let straight = plan.truth.layout.walls.iter().filter(|w| off(w.line.angle()).abs() < 1e-6).count();
        // The rest belongs to wings and bays.
        assert!(straight * 2 > plan.truth.layout.walls.len());
    }
}

/// Whether a wall's pixel lies this near to the point, in pixels.
fn wall_near(plan: &Plan, p: Point, reach: f64) -> bool {
    let (x, y) = (p.x / plan.truth.metres_per_pixel, p.y / plan.truth.metres_per_pixel);
    let walls = &plan.truth.walls;
    let row = f64::from(walls.height()) - y;
    let inside = |x: f64, y: f64| {
        x >= 0.0 && y >= 0.0 && x < f64::from(walls.width()) && y < f64::from(walls.height())
    };
    (-reach as i32..=reach as i32).any(|dy| {
        (-reach as i32..=reach as i32).any(|dx| {
            let (x, y) = (x + f64::from(dx), row + f64::from(dy));
            inside(x, y) && walls.get_pixel(x as u32, y as u32).0[0] > 0
        })
    })
}

#[test]
fn doors_and_windows_are_gaps_in_walls() {
    for plan in &*PLANS {
        let gap = |s: &&PlanSymbol| s.kind.contains("door") || s.kind == "window";
        for symbol in plan.truth.symbols.iter().filter(gap) {
            let Pose { x, y, yaw } = symbol.pose;
            assert!(!wall_near(plan, Point::new(x, y), 2.0), "{symbol:?}");
            for end in [-1.0, 1.0] {
                let reach = end * (symbol.width / 2.0 + 0.05);
                let jamb = Point::new(x + reach * yaw.cos(), y + reach * yaw.sin());
                let thickness = symbol.height / 2.0 / plan.truth.metres_per_pixel;
                assert!(wall_near(plan, jamb, thickness + 4.0), "{symbol:?}");
            }
        }
    }
}

#[test]
fn leaves_turn_about_a_jamb() {
    for plan in &*PLANS {
        for symbol in plan.truth.symbols.iter().filter(|s| !s.leaves.is_empty()) {
            let wide = symbol.width / symbol.leaves.len() as f64;
            for leaf in &symbol.leaves {
                assert!((leaf.hinge.distance(leaf.closed) - wide).abs() < 1e-9);
                assert!((leaf.hinge.distance(leaf.open) - wide).abs() < 1e-9);
                let middle = Point::new(symbol.pose.x, symbol.pose.y);
                let jamb = (symbol.width / 2.0).hypot(symbol.height / 2.0);
                assert!((leaf.hinge.distance(middle) - jamb).abs() < 1e-6);
            }
        }
    }
}

#[test]
fn names_stand_in_their_rooms() {
    for plan in &*PLANS {
        for text in plan.truth.texts.iter().filter(|t| t.room.is_some()) {
            let room = plan.truth.layout.rooms.iter().find(|r| Some(r.id) == text.room).unwrap();
            assert!(room.inner.contains(Point::new(text.pose.x, text.pose.y)), "{}", text.content);
        }
        let labels = plan.labels();
        let named = plan.truth.layout.rooms.iter().filter(|r| labels.rooms.contains(&r.id)).count();
        assert_eq!(named, plan.truth.layout.rooms.len());
    }
}

#[test]
fn the_jpeg_is_the_picture() {
    let plan = PLANS.iter().find(|p| p.jpeg.is_some()).unwrap();
    let read = image::load_from_memory(plan.jpeg.as_ref().unwrap()).unwrap();
    assert_eq!(read.into_rgb8(), plan.picture);
}
