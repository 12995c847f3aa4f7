//! What a plugin says of itself, and the options it takes.

use crate::{ErrorKind, PluginError};
use std::collections::BTreeMap;
use std::fmt;

/// What a plugin says of itself.
#[derive(Debug, Clone, PartialEq)]
pub struct PluginInfo {
    /// Short name, lower case, as the user types it: `slam-grid`.
    pub name: String,
    /// One line for people.
    pub description: String,
    /// Version of the plugin.
    pub version: String,
    /// Licence as an SPDX expression.
    pub licence: String,
    /// File name extensions without the dot, lower case, the preferred one first.
    pub extensions: Vec<String>,
    /// Media types, the preferred one first.
    pub media_types: Vec<String>,
    /// The options it takes.
    pub options: Vec<OptionSpec>,
}

/// One option of a plugin.
#[derive(Debug, Clone, PartialEq)]
pub struct OptionSpec {
    /// Name as the user types it in `--set NAME=VALUE`.
    pub name: String,
    /// One line for people, units included.
    pub help: String,
    /// What values it takes.
    pub kind: OptionKind,
    /// The value when the user gives none; no default means the option is absent then.
    pub default: Option<OptionValue>,
}

/// What values an option takes.
#[derive(Debug, Clone, PartialEq)]
pub enum OptionKind {
    /// A finite number above `above` (if given) and at most `max` (if given).
    Number {
        /// Exclusive lower bound.
        above: Option<f64>,
        /// Inclusive upper bound.
        max: Option<f64>,
    },
    /// `true` or `false`.
    Flag,
    /// One of these words.
    Choice(Vec<String>),
    /// Any text.
    Text,
}

/// The value of an option.
#[derive(Debug, Clone, PartialEq)]
pub enum OptionValue {
    /// A number.
    Number(f64),
    /// Yes or no.
    Flag(bool),
    /// A text, or one of a choice's words.
    Text(String),
}

/// The options of one run of a plugin: every value checked against its [`OptionSpec`], defaults filled in.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Options(BTreeMap<String, OptionValue>);

impl OptionSpec {
    /// An option of one of these words.
    pub fn choice(name: &str, help: &str, words: &[&str], default: &str) -> Self {
        let kind = OptionKind::Choice(words.iter().map(|w| (*w).to_owned()).collect());
        Self::new(name, help, kind, Some(OptionValue::Text(default.into())))
    }

    /// An option of yes or no.
    pub fn flag(name: &str, help: &str, default: bool) -> Self {
        Self::new(name, help, OptionKind::Flag, Some(OptionValue::Flag(default)))
    }

    /// An option of this kind.
    pub fn new(name: &str, help: &str, kind: OptionKind, default: Option<OptionValue>) -> Self {
        Self { name: name.into(), help: help.into(), kind, default }
    }

    /// Checks and reads a value as the user typed it.
    pub fn parse(&self, value: &str) -> Result<OptionValue, PluginError> {
        match &self.kind {
            OptionKind::Text => Ok(OptionValue::Text(value.into())),
            OptionKind::Flag => value.parse().map(OptionValue::Flag).map_err(|_| self.refuse(value)),
            OptionKind::Choice(words) if words.iter().any(|w| w == value) => {
                Ok(OptionValue::Text(value.into()))
            }
            OptionKind::Choice(_) => Err(self.refuse(value)),
            OptionKind::Number { above, max } => self.parse_number(value, *above, *max),
        }
    }

    fn parse_number(
        &self,
        value: &str,
        above: Option<f64>,
        max: Option<f64>,
    ) -> Result<OptionValue, PluginError> {
        let in_range = |v: f64| v.is_finite() && above.is_none_or(|a| v > a) && max.is_none_or(|m| v <= m);
        match value.trim().parse() {
            Ok(v) if in_range(v) => Ok(OptionValue::Number(v)),
            _ => Err(self.refuse(value)),
        }
    }

    fn refuse(&self, value: &str) -> PluginError {
        let message = format!("option `{}` cannot be `{value}`", self.name);
        PluginError::new(ErrorKind::BadOption, message).advise(format!("give {}", self.kind))
    }
}

/// What values are taken, in words: "a number above 0".
impl fmt::Display for OptionKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text => f.write_str("any text"),
            Self::Flag => f.write_str("true or false"),
            Self::Choice(words) => write!(f, "one of {}", words.join(", ")),
            Self::Number { above, max } => {
                f.write_str("a number")?;
                above.map_or(Ok(()), |a| write!(f, " above {a}"))?;
                max.map_or(Ok(()), |m| write!(f, " of at most {m}"))
            }
        }
    }
}

/// The value as the user types it.
impl fmt::Display for OptionValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(v) => v.fmt(f),
            Self::Flag(v) => v.fmt(f),
            Self::Text(v) => v.fmt(f),
        }
    }
}

impl Options {
    /// Checks the `given` names and values against the specs and fills in the defaults.
    pub fn parse<'a>(
        specs: &[OptionSpec],
        given: impl IntoIterator<Item = (&'a str, &'a str)>,
    ) -> Result<Self, PluginError> {
        let mut values: BTreeMap<_, _> =
            specs.iter().filter_map(|s| Some((s.name.clone(), s.default.clone()?))).collect();
        for (name, value) in given {
            let spec = specs.iter().find(|s| s.name == name).ok_or_else(|| unknown(specs, name))?;
            values.insert(name.into(), spec.parse(value)?);
        }
        Ok(Self(values))
    }

    /// The number of this name, if set.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.0.get(name) {
            Some(OptionValue::Number(v)) => Some(*v),
            _ => None,
        }
    }

    /// Whether the flag of this name is set.
    pub fn flag(&self, name: &str) -> bool {
        self.0.get(name) == Some(&OptionValue::Flag(true))
    }

    /// The text or choice of this name, if set.
    pub fn text(&self, name: &str) -> Option<&str> {
        match self.0.get(name) {
            Some(OptionValue::Text(v)) => Some(v),
            _ => None,
        }
    }
}

fn unknown(specs: &[OptionSpec], name: &str) -> PluginError {
    let known: Vec<_> = specs.iter().map(|s| s.name.as_str()).collect();
    let advice =
        if known.is_empty() { "it takes none".into() } else { format!("it takes {}", known.join(", ")) };
    PluginError::new(ErrorKind::BadOption, format!("there is no option `{name}`")).advise(advice)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn specs() -> Vec<OptionSpec> {
        let spec =
            |name: &str, kind, default| OptionSpec { name: name.into(), help: String::new(), kind, default };
        vec![
            spec(
                "resolution",
                OptionKind::Number { above: Some(0.0), max: None },
                Some(OptionValue::Number(0.05)),
            ),
            spec("version", OptionKind::Choice(vec!["R12".into(), "R2000".into()]), None),
            spec("grid", OptionKind::Flag, None),
        ]
    }

    #[test]
    fn defaults_are_filled_in() {
        let o = Options::parse(&specs(), []).unwrap();
        assert_eq!((o.number("resolution"), o.text("version"), o.flag("grid")), (Some(0.05), None, false));
    }

    #[test]
    fn values_are_checked() {
        for (name, bad) in [
            ("resolution", "0"),
            ("resolution", "NaN"),
            ("resolution", "x"),
            ("version", "R9"),
            ("grid", "yes"),
        ] {
            assert_eq!(Options::parse(&specs(), [(name, bad)]).unwrap_err().kind, ErrorKind::BadOption);
        }
        let o =
            Options::parse(&specs(), [("resolution", "0.1"), ("version", "R12"), ("grid", "true")]).unwrap();
        assert_eq!(
            (o.number("resolution"), o.text("version"), o.flag("grid")),
            (Some(0.1), Some("R12"), true)
        );
    }

    #[test]
    fn unknown_names_are_answered_with_the_known() {
        let e = Options::parse(&specs(), [("colour", "red")]).unwrap_err();
        assert_eq!(e.to_string(), "there is no option `colour`; it takes resolution, version, grid");
    }
}
