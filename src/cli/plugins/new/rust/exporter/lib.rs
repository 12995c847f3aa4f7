//! Writes a table of the rooms in CSV (RFC 4180): number, name, area, centre, and how many doors lead out.

use planform_sdk::{
    Document, Exporter, Layout, OpeningKind, OptionSpec, Options, PluginError, PluginInfo, Point,
    Room,
};
use std::io::Write;

// What planform calls when it loads the library. A library may hold several adapters and exporters.
planform_sdk::export_plugin!(adapters: [], exporters: [exporter()]);

/// The plugin's name, and the extension of its files.
const NAME: &str = "{{name}}";

fn exporter() -> Box<dyn Exporter> {
    planform_sdk::exporter(info(), write)
}

fn info() -> PluginInfo {
    let separator = OptionSpec::choice(
        "separator",
        "what stands between two columns; some spreadsheets want a semicolon",
        &["comma", "semicolon", "tab"],
        "comma",
    );
    PluginInfo {
        name: NAME.into(),
        description: "A table of the rooms".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: "MIT".into(),
        extensions: vec![NAME.into()],
        media_types: vec!["text/csv".into()],
        options: vec![separator],
    }
}

/// Writes the whole file. What `?` returns here stops it: planform then keeps nothing of the file.
fn write(
    document: &Document<'_>,
    options: &Options,
    out: &mut dyn Write,
) -> Result<(), PluginError> {
    let separator = match options.text("separator") {
        Some("semicolon") => ";",
        Some("tab") => "\t",
        _ => ",",
    };
    let header = ["id", "name", "area_m2", "centre_x_m", "centre_y_m", "doors"];
    writeln!(out, "{}", header.join(separator))?;
    for room in &document.layout.rooms {
        let fields = row(room, document.layout).map(|field| quoted(field, separator));
        writeln!(out, "{}", fields.join(separator))?;
    }
    Ok(())
}

fn row(room: &Room, layout: &Layout) -> [String; 6] {
    let (area, centre) = area_and_centre(room);
    let name = room.name.clone().unwrap_or_default();
    let doors = doors(room, layout).to_string();
    [
        room.id.to_string(),
        name,
        number(area),
        number(centre.x),
        number(centre.y),
        doors,
    ]
}

/// To a hundredth, without "-0.00".
fn number(value: f64) -> String {
    format!("{:.2}", (value * 100.0).round() / 100.0 + 0.0)
}

/// Quotes a field if it has to be, its own quotes doubled.
fn quoted(field: String, separator: &str) -> String {
    if !field.contains(['"', '\n', '\r']) && !field.contains(separator) {
        return field;
    }
    format!("\"{}\"", field.replace('"', "\"\""))
}

fn doors(room: &Room, layout: &Layout) -> usize {
    let doors = layout
        .openings
        .iter()
        .filter(|o| o.kind == OpeningKind::Door);
    doors.filter(|door| door.rooms.contains(&room.id)).count()
}

/// The area of a room's floor in square metres, and its centroid: the shoelace formula over all rings. Holes run
/// against the exterior, so they count as less than nothing.
fn area_and_centre(room: &Room) -> (f64, Point) {
    // Relative to a point of the room: far from the origin the products would lose digits.
    let Some(o) = room.inner.exterior.first().copied() else {
        return (0.0, Point::default());
    };
    let (mut area, mut x, mut y) = (0.0, 0.0, 0.0);
    for ring in room.inner.rings() {
        for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            let (ax, ay, bx, by) = (a.x - o.x, a.y - o.y, b.x - o.x, b.y - o.y);
            let cross = ax * by - bx * ay;
            area += cross / 2.0;
            x += (ax + bx) * cross / 6.0;
            y += (ay + by) * cross / 6.0;
        }
    }
    if area == 0.0 {
        (0.0, o)
    } else {
        (area, Point::new(o.x + x / area, o.y + y / area))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Opening, Polygon, RoomState, Segment};

    fn ring(x: f64, y: f64, side: f64) -> Vec<Point> {
        [[x, y], [x + side, y], [x + side, y + side], [x, y + side]]
            .map(Point::from)
            .to_vec()
    }

    fn layout(name: &str) -> Layout {
        let floor = Polygon::new(ring(10.0, 0.0, 4.0), vec![ring(11.0, 1.0, 1.0)]);
        let room = |id, name: Option<&str>| Room {
            id,
            name: name.map(Into::into),
            stated_area: None,
            state: RoomState::Complete,
            inner: floor.clone(),
            centre: floor.clone(),
        };
        let opening = |kind| Opening {
            kind,
            segment: Segment::default(),
            rooms: [1, 2],
        };
        Layout {
            rooms: vec![room(1, Some(name)), room(2, None)],
            openings: vec![opening(OpeningKind::Door), opening(OpeningKind::Passage)],
            ..Layout::default()
        }
    }

    fn written(name: &str, separator: &str) -> String {
        let options = Options::parse(&info().options, [("separator", separator)]).unwrap();
        let mut out = vec![];
        exporter()
            .write(
                &Document {
                    layout: &layout(name),
                    scene: None,
                },
                &options,
                &mut out,
            )
            .unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn holes_count_neither_for_the_area_nor_for_the_centre() {
        let table = "id,name,area_m2,centre_x_m,centre_y_m,doors\n1,Bath,15.00,12.03,2.03,1\n2,,15.00,12.03,2.03,1\n";
        assert_eq!(written("Bath", "comma"), table);
    }

    #[test]
    fn names_are_quoted_where_they_must_be() {
        let table = written("\"Bad\"; Küche, Flur", "comma");
        assert_eq!(
            table.lines().nth(1),
            Some("1,\"\"\"Bad\"\"; Küche, Flur\",15.00,12.03,2.03,1")
        );
        let table = written("Küche, Flur", "semicolon");
        assert_eq!(
            table.lines().nth(1),
            Some("1;Küche, Flur;15.00;12.03;2.03;1")
        );
    }
}
