//! From the map frame to WGS 84.

use geographiclib_rs::{DirectGeodesic, Geodesic};
use planform_sdk::{Bearing, GeoAnchor, PluginError, Point};

/// A place on the Earth, degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// North.
    pub latitude: f64,
    /// East, within -180..180.
    pub longitude: f64,
}

/// The Earth with the map frame laid on it.
pub struct Earth {
    anchor: GeoAnchor,
    geodesic: Geodesic,
}

impl Earth {
    /// The Earth with the map frame laid on it at this anchor.
    pub fn new(anchor: GeoAnchor) -> Self {
        Self { anchor, geodesic: Geodesic::wgs84() }
    }

    /// Where a point of the map lies, to 9 decimals.
    pub fn place(&self, p: Point) -> Result<Place, PluginError> {
        let Bearing { azimuth, distance } = self.anchor.bearing_to(p)?;
        let GeoAnchor { latitude, longitude, .. } = self.anchor;
        let (latitude, longitude) = self.geodesic.direct(latitude, longitude, azimuth, distance);
        Ok(Place { latitude: rounded(latitude), longitude: rounded(longitude) })
    }
}

/// To 9 decimals; adding zero turns -0 into 0.
fn rounded(degrees: f64) -> f64 {
    (degrees * 1e9).round() / 1e9 + 0.0
}
