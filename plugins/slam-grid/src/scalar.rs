//! Reads the scalars of YAML files as the map servers' parser does: leniently.

/// A number: also `.5`, `1e-2`, `.inf`, and not-a-number in every spelling that C++ programs print.
pub fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let (sign, digits) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    match digits.to_lowercase().trim_start_matches('.') {
        "nan" => Some(f64::NAN),
        "inf" => Some(sign * f64::INFINITY),
        // Rust's own parser would take a second sign.
        _ if digits.starts_with(['-', '+']) => None,
        _ => digits.parse::<f64>().ok().map(|v| sign * v),
    }
}

/// Yes or no: an integer, of which 0 is no, or a word of YAML 1.1.
pub fn flag(text: &str) -> Option<bool> {
    let text = text.trim();
    if let Ok(number) = text.parse::<i64>() {
        return Some(number != 0);
    }
    match text.to_lowercase().as_str() {
        "true" | "yes" | "on" | "y" => Some(true),
        "false" | "no" | "off" | "n" => Some(false),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_every_spelling() {
        for (text, value) in
            [("0.05", 0.05), (" -1e-2 ", -0.01), (".5", 0.5), ("+3", 3.0), ("-.inf", f64::NEG_INFINITY)]
        {
            assert_eq!(number(text), Some(value), "{text}");
        }
        for text in ["nan", "-nan", ".nan", ".NaN", "-NAN"] {
            assert!(number(text).is_some_and(f64::is_nan), "{text}");
        }
        for text in ["", "--1", "0.05m", "a", "-"] {
            assert_eq!(number(text), None, "{text}");
        }
    }

    #[test]
    fn flags_as_numbers_and_words() {
        for (text, value) in [("0", false), ("1", true), ("2", true), ("False", false), ("yes", true)] {
            assert_eq!(flag(text), Some(value), "{text}");
        }
        assert_eq!(flag("maybe"), None);
    }
}
