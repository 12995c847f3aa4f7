//! What a plugin says of itself, and the options it takes.

use crate::{ErrorKind, PluginError};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;

/// What a plugin says of itself.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum OptionKind {
    /// A finite number within these bounds.
    Number(Bounds),
    /// `true` or `false`.
    Flag,
    /// One of these words.
    Choice(Vec<String>),
    /// Any text.
    Text,
}

/// What numbers an option takes. By default, all.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Bounds {
    /// Only numbers above this one.
    pub above: Option<f64>,
    /// No number below this one.
    pub min: Option<f64>,
    /// Only numbers below this one.
    pub below: Option<f64>,
    /// No number above this one.
    pub max: Option<f64>,
    /// Only whole numbers.
    pub whole: bool,
}

impl Bounds {
    /// The numbers above this one.
    pub fn above(above: f64) -> Self {
        Self { above: Some(above), ..Self::default() }
    }

    /// Whether the number is finite and within these bounds.
    pub fn contains(&self, v: f64) -> bool {
        v.is_finite()
            && self.above.is_none_or(|a| v > a)
            && self.min.is_none_or(|m| v >= m)
            && self.below.is_none_or(|b| v < b)
            && self.max.is_none_or(|m| v <= m)
            && (!self.whole || v.fract() == 0.0)
    }
}

/// In words: "a number above 0".
impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.whole { "a whole number" } else { "a number" })?;
        let bounds = [
            ("above", self.above),
            ("of at least", self.min),
            ("below", self.below),
            ("of at most", self.max),
        ];
        let bounds = bounds.iter().filter_map(|(words, bound)| Some((words, (*bound)?)));
        bounds.enumerate().try_for_each(|(i, (words, bound))| {
            let and = if i > 0 { " and" } else { "" };
            write!(f, "{and} {words} {bound}")
        })
    }
}

/// The value of an option.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum OptionValue {
    /// A number.
    Number(f64),
    /// Yes or no.
    Flag(bool),
    /// A text, or one of a choice's words.
    Text(String),
}

/// The options of one run of a plugin: every value checked against its [`OptionSpec`], defaults filled in.
/// As JSON, an object of them.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[serde(transparent)]
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
            OptionKind::Number(bounds) => match value.trim().parse() {
                Ok(v) if bounds.contains(v) => Ok(OptionValue::Number(v)),
                _ => Err(self.refuse(value)),
            },
        }
    }

    /// Checks a value that is typed already.
    pub fn check(&self, value: OptionValue) -> Result<OptionValue, PluginError> {
        let fits = match (&self.kind, &value) {
            (OptionKind::Number(bounds), OptionValue::Number(v)) => bounds.contains(*v),
            (OptionKind::Choice(words), OptionValue::Text(v)) => words.contains(v),
            (OptionKind::Flag, OptionValue::Flag(_)) | (OptionKind::Text, OptionValue::Text(_)) => true,
            _ => false,
        };
        if fits { Ok(value) } else { Err(self.refuse(&value.to_string())) }
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
            Self::Number(bounds) => bounds.fmt(f),
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

    /// Checks these values against the specs and fills in the defaults.
    pub fn of_values(
        specs: &[OptionSpec],
        given: impl IntoIterator<Item = (String, OptionValue)>,
    ) -> Result<Self, PluginError> {
        let mut options = Self::parse(specs, [])?;
        for (name, value) in given {
            let spec = specs.iter().find(|s| s.name == name).ok_or_else(|| unknown(specs, &name))?;
            options.0.insert(name, spec.check(value)?);
        }
        Ok(options)
    }

    /// These values as they are: for trying what a plugin does with options that it does not have.
    pub fn unchecked(values: impl IntoIterator<Item = (String, OptionValue)>) -> Self {
        Self(values.into_iter().collect())
    }

    /// All names and values, as they cross to plugins.
    pub fn values(&self) -> BTreeMap<String, OptionValue> {
        self.0.clone()
    }

    /// All names and values, in the order of the names.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &OptionValue)> {
        self.0.iter().map(|(name, value)| (name.as_str(), value))
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
            spec("resolution", OptionKind::Number(Bounds::above(0.0)), Some(OptionValue::Number(0.05))),
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
