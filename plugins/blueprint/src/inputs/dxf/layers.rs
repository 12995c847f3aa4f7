//! What the names of layers say: in the words of offices in several languages.

/// What is drawn on a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Walls.
    Wall,
    /// Nothing that a wall could be: furniture, words, dimensions, hatching, the sheet.
    Aside,
    /// Anything.
    Unknown,
}

/// Words for walls. Those that mean something else inside of other words are whole parts of a name.
const WALLS: [&str; 13] = [
    "WALL", "WAND", "WAENDE", "WÄNDE", "PARETE", "PARETI", "PARED", "PAREDE", "MURATURA", "MAUER", "CLOISON",
    "TABIQUE", "VÄGG",
];
const WALL_PARTS: [&str; 7] = ["MUR", "MURS", "MURI", "MURO", "MUROS", "MUUR", "STENA"];

/// Words for the rest, anywhere in a name.
const ASIDE: [&str; 40] = [
    "FURN",
    "MOBIL",
    "MÖBEL",
    "MOEBEL",
    "MEUBLE",
    "ARRED",
    "MUEBLE",
    "EQUIP",
    "FIXT",
    "PLUMB",
    "SANIT",
    "TEXT",
    "TXT",
    "DIM",
    "BEMASS",
    "COTE",
    "COTA",
    "QUOT",
    "MASS",
    "ANNO",
    "NOTE",
    "LABEL",
    "GRID",
    "RASTER",
    "AXIS",
    "ACHSE",
    "HATCH",
    "SCHRAFF",
    "PATT",
    "TITLE",
    "FRAME",
    "BORDER",
    "RAHMEN",
    "LEGEND",
    "SYMB",
    "DEFPOINTS",
    "VIEWPORT",
    "ELEC",
    "LIGHT",
    "CEIL",
];
const ASIDE_PARTS: [&str; 12] = [
    "AREA",
    "ROOM",
    "ROOMS",
    "FURNITURE",
    "CNTR",
    "CENTER",
    "CENTRE",
    "IDEN",
    "PATT",
    "TREE",
    "SITE",
    "HVAC",
];

/// What the layer of this name, in upper case, is for.
pub fn role(name: &str) -> Role {
    let parts: Vec<_> = name.split(|c: char| !c.is_alphanumeric()).collect();
    let has = |words: &[&str], whole: &[&str]| {
        words.iter().any(|w| name.contains(w)) || parts.iter().any(|p| whole.contains(p))
    };
    match (has(&ASIDE, &ASIDE_PARTS), has(&WALLS, &WALL_PARTS)) {
        // The dimensions of walls, their hatching, their centre lines.
        (true, _) => Role::Aside,
        (false, true) => Role::Wall,
        (false, false) => Role::Unknown,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walls_are_known_in_several_languages() {
        for name in
            ["A-WALL", "WALLS", "WAND_TRAGEND", "01-MURS", "MURO", "PARETI ESTERNE", "A_PARED", "A-WALL-FULL"]
        {
            assert_eq!(role(name), Role::Wall, "{name}");
        }
    }

    #[test]
    fn what_belongs_to_walls_is_none() {
        for name in [
            "A-WALL-DIMS",
            "A-WALL-PATT",
            "A-WALL-CNTR",
            "WAND-SCHRAFFUR",
            "A-FURN",
            "TEXT",
            "DEFPOINTS",
            "A-AREA",
        ] {
            assert_eq!(role(name), Role::Aside, "{name}");
        }
        for name in ["0", "LAYER1", "A-DOOR", "MURAL", "GEBAEUDE"] {
            assert_eq!(role(name), Role::Unknown, "{name}");
        }
    }
}
