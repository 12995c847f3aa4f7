//! Where the map frame lies on the Earth: the option, or what the document says.

use planform_sdk::{ErrorKind, GeoAnchor, PluginError, Point};

/// The anchor of the option, else that of the document, checked.
pub fn choose(option: Option<&str>, document: Option<GeoAnchor>) -> Result<Option<GeoAnchor>, PluginError> {
    match (option, document) {
        (Some(text), _) => parse(text).map(Some),
        (None, Some(anchor)) => match fault(&anchor) {
            Some(fault) => Err(refuse_document(&fault)),
            None => Ok(Some(anchor)),
        },
        (None, None) => Ok(None),
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

/// What makes the anchor unusable. The poles have no north, so nothing can be turned towards it there.
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

    #[test]
    fn option_wins_over_document() {
        let document = parse("1,2,3").ok();
        assert_eq!(choose(Some("4,5,6"), document).unwrap().unwrap().latitude, 4.0);
        assert_eq!(choose(None, document).unwrap().unwrap().latitude, 1.0);
        assert_eq!(choose(None, None).unwrap(), None);
    }

    #[test]
    fn bad_anchor_of_document_is_its_fault() {
        let document = parse("1,2,3").map(|a| GeoAnchor { latitude: 91.0, ..a }).ok();
        assert_eq!(choose(None, document).unwrap_err().kind, ErrorKind::BadInput);
    }
}
