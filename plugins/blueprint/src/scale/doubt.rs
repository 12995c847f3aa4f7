//! A scale that is written is wrong where the picture was scaled since, and nothing looks as it should: hardly a door
//! is as wide as doors are. Then the doors are asked.

use super::{Estimate, GOOD, SURE};
use crate::doorways::{USUAL_WIDTH, Widths};
use crate::found::SheetSymbol;

/// With so many single doors a scale is as good as confirmed.
const CONFIRMED: usize = 3;

/// At least so many single doors refute a scale, and so many times as many as are found by it,
const REFUTED: usize = 5;
const TIMES: usize = 3;

/// if they are too wide or too narrow by this factor.
const FACTOR: f64 = 1.5;

/// How sure a refuted scale is; less than doors are.
const LEFT: f64 = 0.3;

/// Whether a scale is worth a second look, as these symbols were found by it. What a person says is as well: the
/// paper's scale is easily given with the wrong resolution.
pub fn is_doubtful(scale: &Estimate, symbols: &[SheetSymbol]) -> bool {
    scale.confidence >= GOOD && count(symbols) < CONFIRMED
}

/// What speaks against a scale, if symbols `without` it are found that do; `with` are those found by it. The scale is
/// then unsure, unless a person said it.
pub fn refute(scale: &mut Estimate, with: &[SheetSymbol], without: &[SheetSymbol]) -> Option<String> {
    let doors = Widths::of_single(without)?;
    let width = doors.median * scale.metres_per_pixel;
    let is_many = doors.count >= REFUTED && doors.count >= TIMES * count(with);
    let is_door = (USUAL_WIDTH / FACTOR..=USUAL_WIDTH * FACTOR).contains(&width);
    (is_many && !is_door).then(|| {
        let doors = format!("{} doors would be {width:.2} m wide by the scale {}", doors.count, scale.source);
        if scale.confidence >= SURE {
            return format!("{doors}; if that is wrong, give the right one with `--set metres-per-pixel`");
        }
        scale.confidence = LEFT;
        format!("{doors}, which is left aside: the picture was scaled since, or its resolution is not what it says")
    })
}

fn count(symbols: &[SheetSymbol]) -> usize {
    Widths::of_single(symbols).map_or(0, |w| w.count)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn doors(count: usize) -> Vec<SheetSymbol> {
        let (kind, centre) = ("door".to_owned(), [0.0; 2]);
        let door =
            SheetSymbol { kind, centre, angle: 0.0, width: 30.0, height: 5.0, score: 1.0, leaves: vec![] };
        vec![door; count]
    }

    fn written(metres_per_pixel: f64) -> Estimate {
        Estimate { metres_per_pixel, source: "written 1:100".into(), confidence: 0.6 }
    }

    #[test]
    fn doors_refute_a_scale_by_which_there_are_none() {
        let mut wrong = written(0.01);
        assert!(is_doubtful(&wrong, &doors(1)));
        let sentence = refute(&mut wrong, &doors(1), &doors(9)).unwrap();
        assert!(
            sentence.starts_with("9 doors would be 0.30 m wide by the scale written 1:100, which"),
            "{sentence}"
        );
        assert!(wrong.confidence < 0.45);
    }

    #[test]
    fn what_a_person_says_stands_with_a_warning() {
        let mut given = Estimate { metres_per_pixel: 0.01, source: "given".into(), confidence: 1.0 };
        assert!(refute(&mut given, &doors(0), &doors(9)).unwrap().contains("if that is wrong"));
        assert_eq!(given.confidence, 1.0);
    }

    #[test]
    fn a_scale_stands_with_its_doors_or_without_any() {
        let mut right = written(0.03);
        assert!(!is_doubtful(&right, &doors(3)));
        assert_eq!(refute(&mut right, &doors(1), &doors(9)), None);
        assert_eq!(refute(&mut written(0.01), &doors(1), &doors(4)), None);
        assert_eq!(refute(&mut written(0.01), &doors(0), &[]), None);
    }
}
