//! From the map frame to the coordinates in the file.

use geographiclib_rs::{DirectGeodesic, Geodesic};
use planform_sdk::{Bearing, GeoAnchor, PluginError, Point};
use serde_json::{Value, json};

/// A local system in metres, in the older WKT that every GDAL reads.
const MAP_CRS: &str =
    r#"LOCAL_CS["map frame",LOCAL_DATUM["map origin",0],UNIT["metre",1],AXIS["x",EAST],AXIS["y",NORTH]]"#;

/// The frame of the coordinates in the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Frame {
    /// Metres in the map frame.
    Map,
    /// WGS 84 longitude and latitude, degrees.
    Earth(GeoAnchor),
}

impl Frame {
    /// The `crs` member of a file in this frame, if it needs one.
    pub fn crs(&self) -> Option<Value> {
        (*self == Self::Map).then(|| json!({"type": "name", "properties": {"name": MAP_CRS}}))
    }

    /// Where the map frame was laid on the Earth, for the way back.
    pub fn anchor(&self) -> Option<Value> {
        let Self::Earth(a) = self else { return None };
        Some(json!({
            "latitude": a.latitude, "longitude": a.longitude, "bearing": a.bearing, "at": [a.at.x, a.at.y],
        }))
    }

    /// The coordinates of the points of one feature, unrounded: metres, or degrees with no jump between them, the
    /// least longitude within -180..180.
    pub fn project(&self, points: &[Point]) -> Result<Vec<[f64; 2]>, PluginError> {
        let mut positions = points.iter().map(|&p| self.position(p)).collect::<Result<Vec<_>, _>>()?;
        let turn = self.turn(&positions);
        positions.iter_mut().for_each(|p| p[0] += turn);
        Ok(positions)
    }

    /// The same for a feature of one point.
    pub fn project_point(&self, p: Point) -> Result<[f64; 2], PluginError> {
        let position = self.position(p)?;
        Ok([position[0] + self.turn(&[position]), position[1]])
    }

    /// What to add to all longitudes so that the least of them lies within -180..180.
    fn turn(&self, positions: &[[f64; 2]]) -> f64 {
        let west = positions.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
        match self {
            Self::Earth(_) if west.is_finite() => -360.0 * ((west + 180.0) / 360.0).floor(),
            _ => 0.0,
        }
    }

    fn position(&self, p: Point) -> Result<[f64; 2], PluginError> {
        match self {
            Self::Map => p.finite().map(Into::into),
            Self::Earth(anchor) => on_earth(anchor, p),
        }
    }

    /// Rounds to about 0.1 mm on the ground.
    pub fn round(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let unit = match self {
            Self::Map => 1e4,
            Self::Earth(_) => 1e9,
        };
        // Adding zero turns -0 into 0. A number too large for the unit has no digits to lose.
        [x, y].map(|v| if (v * unit).is_finite() { (v * unit).round() / unit + 0.0 } else { v })
    }
}

/// Longitude (not wrapped) and latitude of a point by the azimuthal equidistant projection about the anchor.
fn on_earth(anchor: &GeoAnchor, p: Point) -> Result<[f64; 2], PluginError> {
    let Bearing { azimuth, distance } = anchor.bearing_to(p)?;
    let (latitude, longitude): (f64, f64) =
        Geodesic::wgs84().direct(anchor.latitude, anchor.longitude, azimuth, distance);
    Ok([anchor.longitude + half_turn(longitude - anchor.longitude), latitude])
}

/// The same angle within -180..180 degrees.
fn half_turn(degrees: f64) -> f64 {
    degrees - 360.0 * (degrees / 360.0).round()
}

#[cfg(test)]
mod tests {
    use super::*;
    use geographiclib_rs::InverseGeodesic;
    use planform_sdk::ErrorKind;

    fn earth(latitude: f64, longitude: f64, bearing: f64) -> Frame {
        Frame::Earth(GeoAnchor { latitude, longitude, bearing, at: Point::new(10.0, -5.0) })
    }

    fn one(frame: &Frame, x: f64, y: f64) -> [f64; 2] {
        frame.round(frame.project(&[Point::new(x, y)]).unwrap()[0])
    }

    /// The error of the distance between two points of the map, metres.
    fn distance_error(frame: &Frame, a: Point, b: Point) -> f64 {
        let p: Vec<_> = frame.project(&[a, b]).unwrap().into_iter().map(|p| frame.round(p)).collect();
        let s: f64 = Geodesic::wgs84().inverse(p[0][1], p[0][0], p[1][1], p[1][0]);
        (s - a.distance(b)).abs()
    }

    #[test]
    fn distances_hold_to_a_millimetre() {
        for latitude in [-89.0, -60.0, -0.5, 0.0, 47.0, 70.0, 89.0] {
            for bearing in [0.0, 33.0, 200.0] {
                let frame = earth(latitude, 8.5, bearing);
                for (a, b) in
                    [([0., 0.], [100., 0.]), ([400., 300.], [500., 300.]), ([-700., 0.], [-700., 100.])]
                {
                    let error = distance_error(&frame, Point::from(a), Point::from(b));
                    assert!(error < 1e-3, "{latitude} {bearing}: {error}");
                }
            }
        }
    }

    #[test]
    fn one_degree_of_the_equator() {
        // The arc of one degree of WGS 84's equator is 6378137 m * pi / 180.
        let p = one(&earth(0.0, 0.0, 0.0), 10.0 + 6_378_137.0_f64.to_radians(), -5.0);
        assert!((p[0] - 1.0).abs() < 2e-9 && p[1].abs() < 2e-9, "{p:?}");
    }

    #[test]
    fn bearing_turns_the_y_axis_clockwise_from_north() {
        let [west, south] = one(&earth(47.0, 8.0, 0.0), 10.0, -5.0);
        assert_eq!([west, south], [8.0, 47.0]);
        let east = one(&earth(47.0, 8.0, 90.0), 10.0, 95.0);
        assert!(east[0] > 8.001 && (east[1] - 47.0).abs() < 1e-7, "{east:?}");
        let down = one(&earth(47.0, 8.0, 90.0), 110.0, -5.0);
        assert!(down[1] < 46.9992 && (down[0] - 8.0).abs() < 1e-7, "{down:?}");
    }

    #[test]
    fn antimeridian_does_not_tear_a_feature() {
        let frame = earth(-17.0, 180.0, 0.0);
        let across = frame.project(&[Point::new(-90.0, 0.0), Point::new(110.0, 0.0)]).unwrap();
        assert!(across[0][0] < 180.0 && across[1][0] > 180.0 && across[1][0] < 180.01, "{across:?}");
        let beyond = frame.project(&[Point::new(60.0, 0.0), Point::new(110.0, 0.0)]).unwrap();
        assert!(beyond.iter().all(|p| p[0] > -180.0 && p[0] < -179.9), "{beyond:?}");
        let before = earth(-17.0, -180.0, 0.0).project_point(Point::new(-90.0, 0.0)).unwrap();
        assert!(before[0] > 179.9 && before[0] < 180.0, "{before:?}");
    }

    #[test]
    fn pole_is_refused() {
        let e = earth(89.999, 0.0, 0.0).project(&[Point::new(10.0, 200.0)]).unwrap_err();
        assert_eq!(e.kind, ErrorKind::Unsupported);
    }

    #[test]
    fn not_finite_is_refused() {
        for frame in [Frame::Map, earth(1.0, 2.0, 3.0)] {
            for bad in [Point::new(f64::NAN, 0.0), Point::new(0.0, f64::INFINITY)] {
                assert_eq!(frame.project(&[bad]).unwrap_err().kind, ErrorKind::BadInput);
            }
        }
        assert!(earth(1.0, 2.0, 3.0).project(&[Point::new(1e300, 1e300)]).is_err());
    }

    #[test]
    fn map_coordinates_have_tenths_of_millimetres() {
        assert_eq!(Frame::Map.round([1.234_56, -0.000_01]), [1.2346, 0.0]);
        assert!(Frame::Map.round([0.0, -0.000_01])[1].is_sign_positive());
        assert_eq!(Frame::Map.round([1e306, 0.0])[0], 1e306);
    }
}
