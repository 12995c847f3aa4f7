//! How large a page may be.

use planform_sdk::{ErrorKind, MAX_SIDE, PluginError};

/// The most pixels of a page: an A0 sheet at 240 pixels per inch, or an A1 sheet at 350.
pub const MAX_PIXELS: u64 = 100_000_000;

/// Refuses pictures without pixels, and those with too many. To be asked before memory is taken.
pub fn check_size(width: u32, height: u32) -> Result<(), PluginError> {
    if width == 0 || height == 0 {
        let message = format!("the picture has no pixels ({width} x {height})");
        return Err(PluginError::new(ErrorKind::BadInput, message));
    }
    let scale = largest_scale(f64::from(width), f64::from(height));
    if scale >= 1.0 {
        return Ok(());
    }
    let message = format!(
        "the picture has {width} x {height} pixels; at most {} million are read, and {MAX_SIDE} a side",
        MAX_PIXELS / 1_000_000
    );
    let advice = format!(
        "scale it to {} x {} or smaller, or cut the plan out of it",
        (f64::from(width) * scale).floor().max(1.0),
        (f64::from(height) * scale).floor().max(1.0)
    );
    Err(PluginError::new(ErrorKind::Limit, message).advise(advice))
}

/// By how much a page of this size can be enlarged before it has too many pixels; below 1 if it has so already.
pub fn largest_scale(width: f64, height: f64) -> f64 {
    let by_area = (MAX_PIXELS as f64 / (width * height)).sqrt();
    by_area.min(f64::from(MAX_SIDE) / width.max(height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_pictures_are_told_what_to_become() {
        assert!(check_size(10_000, 10_000).is_ok());
        let message = check_size(30_000, 30_000).unwrap_err().to_string();
        assert_eq!(
            message,
            "the picture has 30000 x 30000 pixels; at most 100 million are read, and 65536 a side; scale it to 10000 x \
             10000 or smaller, or cut the plan out of it"
        );
        assert!(check_size(100_000, 10).unwrap_err().to_string().contains("scale it to 65536 x 6 "));
        assert_eq!(check_size(0, 5).unwrap_err().kind, ErrorKind::BadInput);
    }
}
