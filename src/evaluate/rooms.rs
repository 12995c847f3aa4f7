//! The rooms of a GeoJSON layout.

use super::MAX_ROOMS;
use super::error::{bad, bad_json, limit};
use geojson::{Feature, FeatureCollection, GeoJson, GeometryValue, JsonObject, Position};
use planform_sdk::{PluginError, Point, Polygon};

/// One room: its name and its parts.
#[derive(Debug, Clone, PartialEq)]
pub struct RoomShape {
    /// What the layout calls it, or its place in the file: "feature 3".
    pub name: String,
    /// Its parts, which count together.
    pub parts: Vec<Polygon>,
}

/// Reads the rooms of a feature collection, in the order of the file and in its coordinates.
///
/// A room is a `Polygon` or `MultiPolygon` with `"kind": "room"`. A feature without a `kind` is a room too if its
/// geometry can be one. Everything else is passed over. A collection with an `anchor` lies on the Earth, in degrees, and
/// is refused.
pub fn read_rooms(bytes: &[u8]) -> Result<Vec<RoomShape>, PluginError> {
    let text = std::str::from_utf8(bytes).map_err(|e| bad(format!("is not UTF-8: {e}")))?;
    let document: GeoJson = text.strip_prefix('\u{feff}').unwrap_or(text).parse().map_err(malformed)?;
    let collection = FeatureCollection::try_from(document)
        .map_err(|e| bad(e.to_string()).advise("give a FeatureCollection with the rooms as features"))?;
    if collection.foreign_members.as_ref().is_some_and(|members| members.contains_key("anchor")) {
        return Err(bad("is in degrees").advise("write it without --anchor"));
    }
    let rooms = collection.features.iter().zip(1..).filter_map(|(f, n)| room(f, n).transpose());
    let rooms: Vec<_> = rooms.collect::<Result<_, _>>()?;
    match rooms.len() {
        n if n > MAX_ROOMS => Err(limit(format!("has {n} rooms, and {MAX_ROOMS} are the most"))),
        _ => Ok(rooms),
    }
}

fn malformed(e: geojson::Error) -> PluginError {
    match e {
        geojson::Error::MalformedGeoJson(e) => bad_json(e),
        e => bad_json(e),
    }
}

fn room(feature: &Feature, number: usize) -> Result<Option<RoomShape>, PluginError> {
    let kind = feature.properties.as_ref().and_then(|p| p.get("kind"));
    if kind.is_some_and(|k| k != "room") {
        return Ok(None);
    }
    let parts = match feature.geometry.as_ref().map(|g| &g.value) {
        Some(GeometryValue::Polygon { coordinates }) => vec![polygon(coordinates, number)?],
        Some(GeometryValue::MultiPolygon { coordinates }) => {
            coordinates.iter().map(|rings| polygon(rings, number)).collect::<Result<_, _>>()?
        }
        _ if kind.is_none() => return Ok(None),
        other => return Err(no_room(number, other)),
    };
    Ok(Some(RoomShape { name: name(feature.properties.as_ref(), number), parts }))
}

fn no_room(number: usize, geometry: Option<&GeometryValue>) -> PluginError {
    let found = geometry.map_or("nothing", GeometryValue::type_name);
    bad(format!("feature {number} is a room, but its geometry is {found}"))
        .advise("give a Polygon or MultiPolygon")
}

fn name(properties: Option<&JsonObject>, number: usize) -> String {
    let given = |key| properties.and_then(|p| p.get(key)?.as_str()).filter(|name| !name.is_empty());
    match given("name").or_else(|| given("label")) {
        Some(name) => format!("{number} {name}"),
        None => format!("feature {number}"),
    }
}

fn polygon(rings: &[Vec<Position>], number: usize) -> Result<Polygon, PluginError> {
    let mut rings = rings.iter().map(|ring| points(ring, number));
    let exterior = rings.next().transpose()?.unwrap_or_default();
    Ok(Polygon::new(exterior, rings.collect::<Result<_, _>>()?))
}

fn points(ring: &[Position], number: usize) -> Result<Vec<Point>, PluginError> {
    if ring.len() < 3 {
        return Err(bad(format!("feature {number} has a ring of {} positions", ring.len()))
            .advise("a ring needs at least 4, the last being the first again"));
    }
    let point = |p: &Position| match p.as_slice() {
        [x, y, ..] => Ok(Point::new(*x, *y)),
        _ => Err(bad(format!("feature {number} has a position of fewer than 2 numbers"))),
    };
    ring.iter().map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn collection(features: &str) -> String {
        format!(r#"{{"type": "FeatureCollection", "features": [{features}]}}"#)
    }

    fn feature(properties: &str, geometry: &str) -> String {
        format!(r#"{{"type": "Feature", "properties": {properties}, "geometry": {geometry}}}"#)
    }

    const TRIANGLE: &str = r#"{"type": "Polygon", "coordinates": [[[0,0],[1,0],[0,1],[0,0]]]}"#;
    const LINE: &str = r#"{"type": "LineString", "coordinates": [[0,0],[1,0]]}"#;

    fn read(features: &[(&str, &str)]) -> Result<Vec<RoomShape>, PluginError> {
        let features: Vec<_> = features.iter().map(|(p, g)| feature(p, g)).collect();
        read_rooms(collection(&features.join(",")).as_bytes())
    }

    #[test]
    fn rooms_and_features_without_a_kind_count() {
        let rooms = read(&[
            (r#"{"kind": "room", "name": "Hall"}"#, TRIANGLE),
            (r#"{"kind": "wall"}"#, TRIANGLE),
            (r#"{"kind": "door"}"#, LINE),
            ("null", TRIANGLE),
            ("{}", LINE),
            ("{}", "null"),
        ]);
        let names: Vec<_> = rooms.unwrap().into_iter().map(|r| r.name).collect();
        assert_eq!(names, ["1 Hall", "feature 4"]);
    }

    #[test]
    fn holes_and_parts_are_kept() {
        let rings = "[[[0,0],[9,0],[9,9],[0,0]],[[5,3],[6,3],[6,4],[5,3]]]";
        let multi = format!(
            r#"{{"type": "MultiPolygon", "coordinates": [{rings}, [[[20,0],[21,0,7],[20,1],[20,0]]]]}}"#
        );
        let rooms = read(&[("{}", &multi)]).unwrap();
        assert_eq!((rooms[0].parts.len(), rooms[0].parts[0].holes.len()), (2, 1));
        assert_eq!(rooms[0].parts[1].exterior[1], Point::new(21.0, 0.0));
    }

    #[test]
    fn faults_are_told_in_words() {
        let message = |text: &str| read_rooms(text.as_bytes()).unwrap_err().to_string();
        assert!(message("{\n\"type\": oops}").contains("line 2 column"), "{}", message("{\n\"type\": oops}"));
        assert!(message(TRIANGLE).contains("FeatureCollection"));
        assert!(message(&collection(&feature(r#"{"kind": "room"}"#, LINE))).contains("feature 1 is a room"));
        assert!(message(&collection(&feature(r#"{"kind": "room"}"#, "null"))).contains("is nothing"));
        let anchored = collection("").replace("\"features\"", "\"anchor\": {}, \"features\"");
        assert_eq!(message(&anchored), "is in degrees; write it without --anchor");
        let short = TRIANGLE.replace("[1,0],[0,1],", "");
        assert!(message(&collection(&feature("{}", &short))).contains("ring of 2 positions"));
        let flat = TRIANGLE.replace("[1,0]", "[1]");
        assert!(message(&collection(&feature("{}", &flat))).contains("fewer than 2 numbers"));
        assert!(!message(&collection(&feature("{}", &TRIANGLE.replace("1,0", "1e999,0")))).is_empty());
        assert!(!message(&collection(&feature("{}", &TRIANGLE.replace("1,0", "NaN,0")))).is_empty());
        assert!(!message(&format!("{}1", "[".repeat(100_000))).is_empty());
    }

    /// An edge half way between two pixels would otherwise hop over their centres.
    #[test]
    fn numbers_keep_every_digit() {
        for i in 0..200 {
            let (x, y) = (0.05 * (f64::from(i) + 0.5), f64::from(i).sqrt());
            let rooms = read(&[("{}", &TRIANGLE.replace("[1,0]", &format!("[{x},{y}]")))]).unwrap();
            assert_eq!(rooms[0].parts[0].exterior[1], Point::new(x, y));
        }
    }

    #[test]
    fn an_empty_polygon_is_a_room_without_area() {
        let rooms = read(&[("{}", r#"{"type": "Polygon", "coordinates": []}"#)]).unwrap();
        assert_eq!(rooms[0].parts[0].exterior, []);
    }
}
