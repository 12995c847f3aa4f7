//! What is known of doors and windows: a door leaves its opening free, a window leaves the wall whole.

use super::drawing::Drawing;
use crate::found::SheetSymbol;
use planform_sdk::DOOR_KINDS;

/// Of a door's opening so much is cleared, so that the jambs stay.
const CLEARED: f64 = 0.9;

/// The pixels of the openings of all doors.
pub fn doors(drawing: &Drawing, symbols: &[SheetSymbol]) -> Vec<bool> {
    let mut out = vec![false; drawing.ink.len()];
    for door in symbols.iter().filter(|s| is_door(s)) {
        rectangle(drawing, door, door.width * CLEARED, &mut out);
    }
    out
}

/// The pixels of the walls that all windows stand in.
pub fn windows(drawing: &Drawing, symbols: &[SheetSymbol]) -> Vec<bool> {
    let mut out = vec![false; drawing.ink.len()];
    for window in symbols.iter().filter(|s| s.kind == "window") {
        rectangle(drawing, window, window.width, &mut out);
    }
    out
}

/// The pixels of all doors and windows, from jamb to jamb.
pub fn all(drawing: &Drawing, symbols: &[SheetSymbol]) -> Vec<bool> {
    let mut out = windows(drawing, symbols);
    for door in symbols.iter().filter(|s| is_door(s)) {
        rectangle(drawing, door, door.width, &mut out);
    }
    out
}

/// Whether a symbol is a door or a window.
pub fn is_opening(symbol: &SheetSymbol) -> bool {
    is_door(symbol) || symbol.kind == "window"
}

/// Whether a symbol is a door.
pub fn is_door(symbol: &SheetSymbol) -> bool {
    DOOR_KINDS.contains(&symbol.kind.as_str())
}

/// Sets the pixels of a symbol's rectangle of this width, at least two pixels thick so that it has no leak.
fn rectangle(drawing: &Drawing, symbol: &SheetSymbol, width: f64, out: &mut [bool]) {
    let scale = 1.0 / drawing.factor as f64;
    let half = [width / 2.0 * scale, (symbol.height / 2.0 * scale).max(1.0)];
    let [x, y] = symbol.centre.map(|c| c * scale);
    let reach = half[0].hypot(half[1]);
    let (sin, cos) = symbol.angle.sin_cos();
    let range = |middle: f64, end: usize| {
        let low = (middle - reach).floor().clamp(0.0, end as f64) as usize;
        low..((middle + reach).ceil().clamp(0.0, end as f64) as usize)
    };
    for row in range(y, drawing.height) {
        for column in range(x, drawing.width) {
            let (dx, dy) = (column as f64 + 0.5 - x, row as f64 + 0.5 - y);
            if (dx * cos + dy * sin).abs() <= half[0] && (dy * cos - dx * sin).abs() <= half[1] {
                out[row * drawing.width + column] = true;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    fn symbol(kind: &str) -> SheetSymbol {
        let (kind, leaves) = (kind.to_owned(), Vec::new());
        SheetSymbol { kind, centre: [20.0, 10.0], angle: 0.0, width: 10.0, height: 4.0, score: 1.0, leaves }
    }

    #[test]
    fn doors_and_windows_cover_their_place_in_the_wall() {
        let drawing = Drawing::of_sheet(&Mask::empty(40, 20), 0.1);
        let symbols = [symbol("window"), symbol("lift")];
        let found = windows(&drawing, &symbols);
        assert_eq!(found.iter().filter(|&&f| f).count(), 40);
        assert!(found[9 * 40 + 16] && !found[9 * 40 + 13]);
        assert!(!doors(&drawing, &symbols).contains(&true));
        assert!(doors(&drawing, &[symbol("sliding-door")])[10 * 40 + 20]);
    }

    #[test]
    fn what_lies_beyond_the_sheet_is_left_out() {
        let drawing = Drawing::of_sheet(&Mask::empty(4, 4), 0.1);
        let far = SheetSymbol { centre: [-1e12, f64::NAN], ..symbol("window") };
        assert!(!windows(&drawing, &[far]).contains(&true));
    }
}
