//! Coloured and patterned floors.

use super::drawing::Drawing;
use super::rooms::Purpose;
use super::surface::Colour;

/// Floors by use: one of these for each plan.
const PALETTES: [[Colour; 4]; 4] = [
    [[255, 250, 200], [225, 240, 255], [255, 228, 225], [228, 245, 225]],
    [[238, 228, 212], [226, 226, 226], [238, 228, 212], [214, 226, 232]],
    [[255, 165, 110], [140, 200, 150], [150, 150, 240], [255, 250, 130]],
    [[232, 232, 232], [245, 238, 224], [222, 232, 238], [240, 240, 240]],
];

pub(super) fn draw(drawing: &mut Drawing, purposes: &[Purpose]) {
    if drawing.look.floors == 0.0 {
        return;
    }
    let palette = PALETTES[drawing.rng.index(PALETTES.len())];
    for (room, &purpose) in drawing.site.layout.rooms.iter().zip(purposes) {
        let index = match purpose {
            Purpose::Corridor | Purpose::Stairs | Purpose::Lift => 3,
            Purpose::Wet | Purpose::Kitchen => 1,
            Purpose::Office | Purpose::Bedroom => 0,
            _ => 2,
        };
        if drawing.rng.chance(drawing.look.floors) {
            drawing.picture.fill(room.inner.rings(), palette[index]);
        }
    }
}
