//! Drawings of the symbols of plans, and the table of what they mean, as text. README.md describes both.

/// The table, TOML.
pub const TABLE: &str = include_str!("symbols.toml");

/// The drawings: the name of the file, and the SVG.
pub const DRAWINGS: &[(&str, &str)] = &[
    ("assembly-point.svg", include_str!("assembly-point.svg")),
    ("door-panel.svg", include_str!("door-panel.svg")),
    ("door.svg", include_str!("door.svg")),
    ("double-door-panel.svg", include_str!("double-door-panel.svg")),
    ("double-door.svg", include_str!("double-door.svg")),
    ("emergency-exit-arrow-left.svg", include_str!("emergency-exit-arrow-left.svg")),
    ("emergency-exit-arrow-right.svg", include_str!("emergency-exit-arrow-right.svg")),
    ("emergency-exit-left.svg", include_str!("emergency-exit-left.svg")),
    ("emergency-exit-right.svg", include_str!("emergency-exit-right.svg")),
    ("exit-arrow.svg", include_str!("exit-arrow.svg")),
    ("fire-alarm-call-point.svg", include_str!("fire-alarm-call-point.svg")),
    ("fire-extinguisher.svg", include_str!("fire-extinguisher.svg")),
    ("fire-hose-reel-spiral.svg", include_str!("fire-hose-reel-spiral.svg")),
    ("fire-hose-reel.svg", include_str!("fire-hose-reel.svg")),
    ("first-aid.svg", include_str!("first-aid.svg")),
    ("lift-diagonal.svg", include_str!("lift-diagonal.svg")),
    ("lift.svg", include_str!("lift.svg")),
    ("sink-round.svg", include_str!("sink-round.svg")),
    ("sink.svg", include_str!("sink.svg")),
    ("sliding-door.svg", include_str!("sliding-door.svg")),
    ("stairs-arrow.svg", include_str!("stairs-arrow.svg")),
    ("stairs.svg", include_str!("stairs.svg")),
    ("toilet-oval.svg", include_str!("toilet-oval.svg")),
    ("toilet.svg", include_str!("toilet.svg")),
    ("window.svg", include_str!("window.svg")),
    ("you-are-here-dot.svg", include_str!("you-are-here-dot.svg")),
    ("you-are-here-pin.svg", include_str!("you-are-here-pin.svg")),
    ("you-are-here-ring.svg", include_str!("you-are-here-ring.svg")),
];

/// The drawing in the file of this name.
pub fn drawing(file: &str) -> Option<&'static str> {
    DRAWINGS.iter().find(|(name, _)| *name == file).map(|(_, svg)| *svg)
}

/// The drawing to show where a symbol of this kind is meant, whichever of its drawings it was found by.
pub fn of_kind(kind: &str) -> Option<&'static str> {
    match kind {
        "emergency-exit" => drawing("emergency-exit-right.svg"),
        "you-are-here" => drawing("you-are-here-ring.svg"),
        _ => drawing(&format!("{kind}.svg")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_the_table_has_a_drawing() {
        let kinds = TABLE.lines().filter_map(|l| l.strip_prefix("kind = \"")?.strip_suffix('"'));
        assert_eq!(kinds.clone().find(|kind| of_kind(kind).is_none()), None);
        assert!(kinds.count() > 10);
    }
}
