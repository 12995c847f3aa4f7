//! The option that every exporter to the Earth takes: where the map frame lies there.

use crate::{ErrorKind, GeoAnchor, OptionKind, OptionSpec, Options, PluginError, Point};

/// Fewest metres in a degree of latitude anywhere on WGS 84, rounded down.
const METRES_PER_DEGREE: f64 = 110_500.0;

/// A way over the Earth that begins at an anchor: what the direct problem of geodesy starts from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing {
    /// Degrees clockwise from true north.
    pub azimuth: f64,
    /// Metres.
    pub distance: f64,
}

impl GeoAnchor {
    /// The option `anchor`: `LAT,LON,BEARING`. `otherwise` says, in the option's help, what is done where neither the
    /// option nor the document has an anchor.
    pub fn option(otherwise: &str) -> OptionSpec {
        let help = format!(
            "LAT,LON,BEARING: where the map's origin lies (WGS 84, degrees) and where its y axis points (degrees \
             clockwise from north); else the document's own anchor, else {otherwise}"
        );
        OptionSpec::new("anchor", &help, OptionKind::Text, None)
    }

    /// The anchor of the option, else that of the document, checked.
    ///
    /// ```
    /// # use planform_sdk::{GeoAnchor, Options};
    /// let options = Options::parse(&[GeoAnchor::option("metres")], [("anchor", "47.3769,8.5417,12.5")])?;
    /// assert_eq!(GeoAnchor::chosen(&options, None)?.map(|a| a.bearing), Some(12.5));
    /// # Ok::<(), planform_sdk::PluginError>(())
    /// ```
    pub fn chosen(options: &Options, document: Option<Self>) -> Result<Option<Self>, PluginError> {
        match (options.text("anchor"), document) {
            (Some(text), _) => parse(text).map(Some),
            (None, Some(anchor)) => match fault(&anchor) {
                Some(fault) => Err(refuse_document(&fault)),
                None => Ok(Some(anchor)),
            },
            (None, None) => Ok(None),
        }
    }

    /// The way from the anchor to a point of the map, the map plane being laid on the Earth by the azimuthal
    /// equidistant projection about the anchor.
    ///
    /// Fails for a point that lies as far away as a pole, for nothing can be turned towards north there.
    pub fn bearing_to(&self, p: Point) -> Result<Bearing, PluginError> {
        let p = p.finite()?;
        let (dx, dy) = (p.x - self.at.x, p.y - self.at.y);
        let distance = dx.hypot(dy);
        if distance >= (90.0 - self.latitude.abs()) * METRES_PER_DEGREE {
            return Err(beyond_pole(p, distance));
        }
        Ok(Bearing { azimuth: self.bearing + dx.atan2(dy).to_degrees(), distance })
    }
}

/// Reads `LAT,LON,BEARING`: degrees, the map's origin lying at that latitude and longitude.
fn parse(text: &str) -> Result<GeoAnchor, PluginError> {
    let numbers: Vec<f64> = text
        .split(',')
        .map(|part| {
            part.trim().parse().map_err(|_| refuse(text, &format!("`{}` is not a number", part.trim())))
        })
        .collect::<Result<_, _>>()?;
    let &[latitude, longitude, bearing] = numbers.as_slice() else {
        return Err(refuse(text, &format!("it has {} numbers", numbers.len())));
    };
    let anchor = GeoAnchor { latitude, longitude, bearing, at: Point::default() };
    fault(&anchor).map_or(Ok(anchor), |fault| Err(refuse(text, &fault)))
}

fn refuse(text: &str, why: &str) -> PluginError {
    PluginError::new(ErrorKind::BadOption, format!("option `anchor` cannot be `{text}`: {why}")).advise(
        "give LAT,LON,BEARING in degrees, such as 47.3769,8.5417,12.5: the latitude and longitude of the map's \
         origin, and where its y axis points, clockwise from north",
    )
}

fn refuse_document(fault: &str) -> PluginError {
    PluginError::new(ErrorKind::BadInput, format!("the document's place on the Earth is unusable: {fault}"))
        .advise("give the right one as the option anchor=LAT,LON,BEARING")
}

impl GeoAnchor {
    /// What makes the anchor unusable, if anything does. The poles have no north, so nothing can be turned towards it
    /// there.
    pub fn fault(&self) -> Option<String> {
        fault(self)
    }
}

fn fault(anchor: &GeoAnchor) -> Option<String> {
    let GeoAnchor { latitude, longitude, bearing, at } = *anchor;
    if !(latitude > -90.0 && latitude < 90.0) {
        return Some(format!("the latitude {latitude} is not between -90 and 90"));
    }
    if !(-180.0..=180.0).contains(&longitude) {
        return Some(format!("the longitude {longitude} is not within -180 to 180"));
    }
    if !(-360.0..=360.0).contains(&bearing) {
        return Some(format!("the bearing {bearing} is not within -360 to 360"));
    }
    let finite = at.x.is_finite() && at.y.is_finite();
    (!finite).then(|| "its point in the map is not finite".into())
}

fn beyond_pole(p: Point, distance: f64) -> PluginError {
    let message = format!(
        "the point ({}, {}) lies {distance:.0} m from the anchor, as far as a pole of the Earth or farther",
        p.x, p.y
    );
    PluginError::new(ErrorKind::Unsupported, message).advise("check the anchor and the map's scale")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_three_numbers() {
        let anchor = parse(" 47.5, -8.25 ,350").unwrap();
        assert_eq!((anchor.latitude, anchor.longitude, anchor.bearing), (47.5, -8.25, 350.0));
        assert_eq!(anchor.at, Point::new(0.0, 0.0));
    }

    #[test]
    fn refuses_all_else_and_says_why() {
        for (text, why) in [
            ("", "`` is not a number"),
            ("47.5,8", "it has 2 numbers"),
            ("47.5,8,0,1", "it has 4 numbers"),
            ("47.5,8,north", "`north` is not a number"),
            ("47°,8,0", "`47°` is not a number"),
            ("90,8,0", "latitude 90 "),
            ("-90,8,0", "latitude -90 "),
            ("NaN,8,0", "latitude NaN "),
            ("0,180.5,0", "longitude 180.5 "),
            ("0,inf,0", "longitude inf "),
            ("0,0,361", "bearing 361 "),
            ("0,0,NaN", "bearing NaN "),
        ] {
            let e = parse(text).unwrap_err();
            assert_eq!(e.kind, ErrorKind::BadOption);
            assert!(e.message.contains(why), "{text}: {e}");
        }
    }

    fn given(anchor: &str) -> Options {
        Options::parse(&[GeoAnchor::option("metres")], [("anchor", anchor)]).unwrap()
    }

    #[test]
    fn option_wins_over_document() {
        let (document, none) = (parse("1,2,3").ok(), Options::default());
        assert_eq!(GeoAnchor::chosen(&given("4,5,6"), document).unwrap().unwrap().latitude, 4.0);
        assert_eq!(GeoAnchor::chosen(&none, document).unwrap().unwrap().latitude, 1.0);
        assert_eq!(GeoAnchor::chosen(&none, None).unwrap(), None);
    }

    #[test]
    fn bad_anchor_of_document_is_its_fault() {
        let document = parse("1,2,3").map(|a| GeoAnchor { latitude: 91.0, ..a }).ok();
        let e = GeoAnchor::chosen(&Options::default(), document).unwrap_err();
        assert_eq!(e.kind, ErrorKind::BadInput);
    }

    #[test]
    fn bearings_begin_at_the_anchor_and_end_before_the_pole() {
        let anchor = GeoAnchor { at: Point::new(10.0, -5.0), ..parse("89,8,30").unwrap() };
        let east = anchor.bearing_to(Point::new(12.0, -5.0)).unwrap();
        assert_eq!(east, Bearing { azimuth: 120.0, distance: 2.0 });
        let far = anchor.bearing_to(Point::new(10.0, 110_600.0)).unwrap_err();
        assert_eq!(far.kind, ErrorKind::Unsupported);
        assert_eq!(anchor.bearing_to(Point::new(f64::NAN, 0.0)).unwrap_err().kind, ErrorKind::BadInput);
    }
}
