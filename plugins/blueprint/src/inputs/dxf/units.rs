//! How long a drawing's unit is.

/// Sizes that a building has, metres along its longer side.
const BUILDING: std::ops::RangeInclusive<f64> = 5.0..=500.0;
/// The width of a door, metres.
const DOOR: std::ops::RangeInclusive<f64> = 0.55..=1.4;
/// Units to try where nothing is said, the likeliest first: millimetres, metres, centimetres, inches, feet.
const LIKELY: [(f64, &str); 5] =
    [(0.001, "millimetres"), (1.0, "metres"), (0.01, "centimetres"), (0.0254, "inches"), (0.3048, "feet")];

/// Metres of a unit, by the number that `$INSUNITS` has for it.
pub fn metres(units: i32) -> Option<f64> {
    let metres = match units {
        1 | 22 => 0.0254,
        2 | 21 => 0.3048,
        3 | 24 => 1609.344,
        4 => 0.001,
        5 => 0.01,
        6 => 1.0,
        7 => 1000.0,
        8 => 0.0254e-6,
        9 => 0.0254e-3,
        10 | 23 => 0.9144,
        13 => 1e-6,
        14 => 0.1,
        15 => 10.0,
        16 => 100.0,
        _ => return None,
    };
    Some(metres)
}

/// Metres of a unit by the length of the drawing's longer side and the widths of its doors, and
/// in words what was guessed.
pub fn guess(length: f64, doors: &[f64]) -> (f64, String) {
    let by_doors =
        median(doors).and_then(|door| LIKELY.into_iter().find(|(m, _)| DOOR.contains(&(m * door))));
    let by_length = || LIKELY.into_iter().find(|(m, _)| BUILDING.contains(&(m * length)));
    let (metres, name) = by_doors.or_else(by_length).unwrap_or(LIKELY[1]);
    let why = if by_doors.is_some() { "by the widths of its doors" } else { "by its size" };
    (metres, format!("{why} it is taken to be in {name}"))
}

/// Whether a building can be as long as this, metres.
pub fn is_building(length: f64) -> bool {
    BUILDING.contains(&length)
}

fn median(values: &[f64]) -> Option<f64> {
    let mut values = values.to_vec();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_guessed_by_doors_then_by_size() {
        assert_eq!(guess(30_000.0, &[]).0, 0.001);
        assert_eq!(guess(30.0, &[]).0, 1.0);
        assert_eq!(guess(3_000.0, &[]).0, 0.01);
        assert_eq!(guess(30_000.0, &[90.0, 80.0, 110.0]).0, 0.01);
        assert_eq!(guess(1200.0, &[36.0]).0, 0.0254);
        assert_eq!(guess(30.0, &[]).1, "by its size it is taken to be in metres");
    }
}
