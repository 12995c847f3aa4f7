//! How map servers turn a pixel into a cell: the modes of `nav2_map_server`.

use crate::picture::Tone;
use planform_sdk::Cell;

/// How pixels become cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Free, occupied or unknown.
    Trinary,
    /// Trinary with a scale of occupancies between the thresholds.
    Scale,
    /// The pixel's value is the occupancy.
    Raw,
}

/// The rules of one map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules {
    /// How pixels become cells.
    pub mode: Mode,
    /// Whether white is occupied.
    pub negate: bool,
    /// A pixel that is darker than this, from 0 (white) to 1 (black), is occupied.
    pub occupied_thresh: f64,
    /// A pixel that is lighter than this is free.
    pub free_thresh: f64,
}

impl Mode {
    /// The mode of this name, in capitals or not.
    pub fn named(name: &str) -> Option<Self> {
        match name.to_lowercase().as_str() {
            "trinary" => Some(Self::Trinary),
            "scale" => Some(Self::Scale),
            "raw" => Some(Self::Raw),
            _ => None,
        }
    }
}

impl Rules {
    /// The cell of a pixel. `has_alpha` tells whether the picture has an alpha channel.
    pub fn cell(&self, tone: Tone, has_alpha: bool) -> Cell {
        match self.mode {
            Mode::Trinary => self.trinary(tone, has_alpha),
            Mode::Scale => self.scale(tone),
            Mode::Raw => raw(tone),
        }
    }

    fn trinary(&self, tone: Tone, has_alpha: bool) -> Cell {
        // Map servers count alpha as a fourth colour here, and so do we: the cells are to be the robot's.
        let shade = if has_alpha { (3.0 * tone.shade + tone.alpha) / 4.0 } else { tone.shade };
        let occupancy = self.occupancy(shade);
        self.beyond_thresholds(occupancy).unwrap_or(Cell::UNKNOWN)
    }

    fn scale(&self, tone: Tone) -> Cell {
        if tone.alpha < 1.0 {
            return Cell::UNKNOWN;
        }
        let occupancy = self.occupancy(tone.shade);
        let span = self.occupied_thresh - self.free_thresh;
        let between = (occupancy - self.free_thresh) / span * 100.0;
        self.beyond_thresholds(occupancy).unwrap_or(Cell::percent(between.round_ties_even() as u8))
    }

    fn occupancy(&self, shade: f64) -> f64 {
        if self.negate { shade } else { 1.0 - shade }
    }

    /// Occupied or free; both comparisons are strict.
    fn beyond_thresholds(&self, occupancy: f64) -> Option<Cell> {
        if occupancy > self.occupied_thresh {
            Some(Cell::OCCUPIED)
        } else if occupancy < self.free_thresh {
            Some(Cell::FREE)
        } else {
            None
        }
    }
}

/// The value of 0 to 100 itself; `negate` has no say.
fn raw(tone: Tone) -> Cell {
    match (tone.shade * 255.0).round() as u8 {
        value @ 0..=100 => Cell::percent(value),
        _ => Cell::UNKNOWN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RULES: Rules =
        Rules { mode: Mode::Trinary, negate: false, occupied_thresh: 0.65, free_thresh: 0.196 };

    fn grey(value: u8) -> Tone {
        Tone { shade: f64::from(value) / 255.0, alpha: 1.0 }
    }

    fn cells(rules: Rules, greys: &[u8]) -> Vec<Option<u8>> {
        greys.iter().map(|&g| rules.cell(grey(g), false).occupancy()).collect()
    }

    #[test]
    fn trinary_knows_what_map_saver_writes() {
        assert_eq!(cells(RULES, &[254, 205, 0]), [Some(0), None, Some(100)]);
        // With 0.25 in its YAML file a robot takes 205 for free, and so do we.
        assert_eq!(cells(Rules { free_thresh: 0.25, ..RULES }, &[205]), [Some(0)]);
    }

    #[test]
    fn negate_turns_black_and_white() {
        assert_eq!(cells(Rules { negate: true, ..RULES }, &[254, 100, 0]), [Some(100), None, Some(0)]);
    }

    #[test]
    fn thresholds_are_strict() {
        // 51 / 255 is 0.2 and 204 / 255 is 0.8, exactly as the comparisons see them.
        let rules = Rules { negate: true, free_thresh: 0.2, occupied_thresh: 0.8, ..RULES };
        assert_eq!(cells(rules, &[50, 51, 204, 205]), [Some(0), None, None, Some(100)]);
        assert_eq!(
            cells(Rules { mode: Mode::Scale, ..rules }, &[50, 51, 204, 205]),
            [Some(0), Some(0), Some(100), Some(100)]
        );
    }

    #[test]
    fn scale_is_linear_between_the_thresholds() {
        let rules = Rules { mode: Mode::Scale, free_thresh: 0.0, occupied_thresh: 1.0, ..RULES };
        assert_eq!(cells(rules, &[255, 204, 102, 0]), [Some(0), Some(20), Some(60), Some(100)]);
        let rules = Rules { free_thresh: 0.2, occupied_thresh: 0.6, ..rules };
        assert_eq!(cells(rules, &[153, 255, 0]), [Some(50), Some(0), Some(100)]);
    }

    #[test]
    fn raw_takes_the_value() {
        for negate in [false, true] {
            let rules = Rules { mode: Mode::Raw, negate, ..RULES };
            assert_eq!(cells(rules, &[0, 42, 100, 101, 255]), [Some(0), Some(42), Some(100), None, None]);
        }
    }

    #[test]
    fn alpha_is_a_colour_in_trinary_and_a_veil_in_scale() {
        let cell = |mode, shade, alpha| Rules { mode, ..RULES }.cell(Tone { shade, alpha }, true);
        assert_eq!(cell(Mode::Trinary, 1.0, 0.0), Cell::UNKNOWN);
        assert_eq!(cell(Mode::Trinary, 0.0, 1.0), Cell::OCCUPIED);
        assert_eq!(cell(Mode::Trinary, 205.0 / 255.0, 1.0), Cell::FREE);
        assert_eq!(cell(Mode::Scale, 1.0, 254.0 / 255.0), Cell::UNKNOWN);
        assert_eq!(cell(Mode::Scale, 1.0, 1.0), Cell::FREE);
        assert_eq!(cell(Mode::Raw, 0.0, 0.0), Cell::FREE);
    }

    #[test]
    fn modes_have_names() {
        assert_eq!(Mode::named("Scale"), Some(Mode::Scale));
        assert_eq!(Mode::named("binary"), None);
    }
}
