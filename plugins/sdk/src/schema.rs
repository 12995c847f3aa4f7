//! What crosses as JSON, as JSON Schemas: layouts, the annotations of a scene, and the options of a plugin.
//!
//! The options of a plugin are described in a part of JSON Schema that can be shown to a user and asked of one: an
//! object whose properties are numbers with bounds, flags, texts, or words to choose from. [`options`] is the schema
//! of such schemas.

use crate::{Annotations, Bounds, Layout, OptionKind, OptionSpec, OptionValue};
use schemars::generate::{Contract, SchemaSettings};
use schemars::transform::transform_subschemas;
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

/// Where the schemas are published: what their `$id`s begin with.
const ADDRESS: &str = "https://github.com/planform/planform/blob/main/schemas/";

/// The schema of layouts.
pub fn layout() -> Value {
    let description = "The layout of one floor: what planform's exporter json writes, and what the exporters of \
        plugins are given. Every coordinate is in metres in the map frame, x to the right, y up. Rings are valid by \
        OGC simple features, exteriors run counter-clockwise, and no two rooms overlap. Later versions of planform \
        may add members: skip those that you do not know.";
    schema::<Layout>("layout", "Layout of a building", description, Contract::Serialize)
}

/// The schema of the annotations of a scene: texts, symbols, anchor, provenance, warnings.
pub fn scene() -> Value {
    let description = "What planform found in a document beside its occupancy grid: what the exporters of plugins \
        are given together with the grid. Every coordinate is in metres in the map frame, x to the right, y up. \
        Later versions of planform may add members: skip those that you do not know.";
    schema::<Annotations>("scene", "Annotations of a scene", description, Contract::Serialize)
}

/// The schema of the schemas that describe a plugin's options.
pub fn options() -> Value {
    let description = "How a plugin describes its options to planform: as a JSON Schema of an object whose \
        properties are the options. Only the keywords listed here may be used. Bounds are for numbers and integers, \
        `enum` is for strings, and a default has to fit its own option.";
    schema::<OptionsSchema>("options", "Options of a plugin", description, Contract::Deserialize)
}

/// The schema of what is read or written as `T`, under this name, with what a reader of the file wants to know first.
fn schema<T: JsonSchema>(name: &str, title: &str, description: &str, contract: Contract) -> Value {
    let settings = SchemaSettings::draft2020_12().with(|s| s.contract = contract).with_transform(plain);
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    schema.insert("$id".into(), format!("{ADDRESS}{name}.schema.json").into());
    schema.insert("title".into(), title.into());
    schema.insert("description".into(), description.into());
    schema.to_value()
}

/// Says in plain JSON Schema what schemars says by formats of its own, which strict validators refuse, and each
/// description on one line.
fn plain(schema: &mut Schema) {
    match schema.remove("format").as_ref().and_then(Value::as_str) {
        Some("uint32") => drop(schema.insert("maximum".into(), u32::MAX.into())),
        Some("double") | None => {}
        Some(standard) => drop(schema.insert("format".into(), standard.into())),
    }
    if let Some(description) = schema.get_mut("description")
        && let Some(text) = description.as_str()
    {
        *description = text.replace('\n', " ").into();
    }
    transform_subschemas(&mut plain, schema);
}

/// The options of a plugin: the part of JSON Schema that planform understands.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
struct OptionsSchema {
    /// The dialect, for other programs.
    #[serde(
        rename = "$schema",
        default,
        deserialize_with = "given",
        skip_serializing_if = "Option::is_none"
    )]
    #[schemars(with = "String")]
    dialect: Option<String>,
    /// A title, for other programs.
    #[serde(default, deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    title: Option<String>,
    /// Options are the properties of an object.
    #[serde(rename = "type")]
    kind: ObjectType,
    /// Each option by its name.
    #[serde(default)]
    properties: BTreeMap<String, Property>,
    /// There are never others.
    #[serde(default)]
    #[schemars(extend("const" = false))]
    additional_properties: bool,
}

/// A member that may be left out, but not be null.
fn given<'a, D: Deserializer<'a>, T: Deserialize<'a>>(value: D) -> Result<Option<T>, D::Error> {
    T::deserialize(value).map(Some)
}

#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum ObjectType {
    Object,
}

/// One option.
#[derive(Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "camelCase", default)]
struct Property {
    /// What kind of value it takes.
    #[serde(rename = "type")]
    kind: PropertyType,
    /// One line for people, units included.
    #[serde(deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    description: Option<String>,
    /// The value when the user gives none.
    #[serde(deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "OptionValue")]
    default: Option<OptionValue>,
    /// The words to choose from.
    #[serde(rename = "enum", deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Vec<String>")]
    words: Option<Vec<String>>,
    /// Only numbers above this one.
    #[serde(deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64")]
    exclusive_minimum: Option<f64>,
    /// No number below this one.
    #[serde(deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64")]
    minimum: Option<f64>,
    /// Only numbers below this one.
    #[serde(deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64")]
    exclusive_maximum: Option<f64>,
    /// No number above this one.
    #[serde(deserialize_with = "given", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64")]
    maximum: Option<f64>,
}

#[derive(Default, PartialEq, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum PropertyType {
    #[default]
    String,
    Number,
    Integer,
    Boolean,
}

/// The schema of these options.
///
/// ```
/// # use planform_sdk::{Boundary, schema};
/// let text = schema::of_options(&[Boundary::option()]).to_string();
/// assert_eq!(schema::read_options(&text).unwrap(), [Boundary::option()]);
/// ```
pub fn of_options(specs: &[OptionSpec]) -> Value {
    let schema = OptionsSchema {
        dialect: None,
        title: None,
        kind: ObjectType::Object,
        properties: specs.iter().map(|s| (s.name.clone(), Property::of(s))).collect(),
        additional_properties: false,
    };
    // Fails for maps whose keys are no texts, which these are.
    serde_json::to_value(schema).unwrap_or_default()
}

/// The options that a schema describes, in the order of their names.
///
/// Fails, with a sentence, where the text is no JSON or uses more of JSON Schema than [`options`] allows.
pub fn read_options(schema: &str) -> Result<Vec<OptionSpec>, String> {
    let schema: OptionsSchema =
        serde_json::from_str(schema).map_err(|e| format!("the schema of its options cannot be read: {e}"))?;
    if schema.additional_properties {
        return Err("the schema of its options has `additionalProperties`, which must be false".into());
    }
    schema.properties.into_iter().map(|(name, property)| property.spec(name)).collect()
}

impl Property {
    fn of(spec: &OptionSpec) -> Self {
        let kind = match &spec.kind {
            OptionKind::Number(Bounds { above, min, below, max, whole }) => Self {
                kind: if *whole { PropertyType::Integer } else { PropertyType::Number },
                exclusive_minimum: *above,
                minimum: *min,
                exclusive_maximum: *below,
                maximum: *max,
                ..Self::default()
            },
            OptionKind::Flag => Self { kind: PropertyType::Boolean, ..Self::default() },
            OptionKind::Choice(words) => Self { words: Some(words.clone()), ..Self::default() },
            OptionKind::Text => Self::default(),
        };
        Self { description: Some(spec.help.clone()), default: spec.default.clone(), ..kind }
    }

    fn spec(self, name: String) -> Result<OptionSpec, String> {
        let kind = self.kind(&name)?;
        let spec = OptionSpec { help: self.description.unwrap_or_default(), default: None, name, kind };
        let default = self.default.map(|d| spec.check(d)).transpose();
        let default = default.map_err(|e| format!("the default of its {e}"))?;
        Ok(OptionSpec { default, ..spec })
    }

    fn kind(&self, name: &str) -> Result<OptionKind, String> {
        let bounds = Bounds {
            above: self.exclusive_minimum,
            min: self.minimum,
            below: self.exclusive_maximum,
            max: self.maximum,
            whole: self.kind == PropertyType::Integer,
        };
        let bounded = Bounds { whole: false, ..bounds } != Bounds::default();
        match (self.kind, &self.words) {
            (PropertyType::Number | PropertyType::Integer, None) => Ok(OptionKind::Number(bounds)),
            _ if bounded => Err(format!("its option `{name}` has bounds but is no number")),
            (PropertyType::String, Some(words)) => Ok(OptionKind::Choice(words.clone())),
            (_, Some(_)) => Err(format!("its option `{name}` has an `enum` but is no string")),
            (PropertyType::Boolean, None) => Ok(OptionKind::Flag),
            (PropertyType::String, None) => Ok(OptionKind::Text),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_survive_their_schema() {
        let bounds =
            Bounds { above: Some(0.0), min: Some(0.1), below: Some(9.0), max: Some(8.0), whole: true };
        let mut specs = [
            OptionSpec::flag("a", "A flag", true),
            OptionSpec::choice("b", "A choice", &["one", "two"], "two"),
            OptionSpec::new("c", "A number, m", OptionKind::Number(bounds), Some(OptionValue::Number(5.0))),
            OptionSpec::new("d", "", OptionKind::Number(Bounds::default()), None),
            OptionSpec::new("e", "A text", OptionKind::Text, Some(OptionValue::Text("true".into()))),
        ];
        assert_eq!(read_options(&of_options(&specs).to_string()).unwrap(), specs);
        specs.reverse();
        assert_ne!(read_options(&of_options(&specs).to_string()).unwrap(), specs);
    }

    #[test]
    fn what_cannot_be_asked_of_a_user_is_refused() {
        let object = |property: &str| format!(r#"{{"type":"object","properties":{{"a":{property}}}}}"#);
        for (schema, words) in [
            ("", "cannot be read"),
            ("[]", "cannot be read"),
            (r#"{"type":"array"}"#, "cannot be read"),
            (r#"{"type":"object","additionalProperties":true}"#, "additionalProperties"),
            (r#"{"type":"object","required":["a"]}"#, "required"),
            (&object(r#"{"type":"string","pattern":"a"}"#), "pattern"),
            (&object(r#"{"type":"object"}"#), "object"),
            (&object(r#"{"type":"string","minimum":1}"#), "`a` has bounds"),
            (&object(r#"{"type":"number","enum":["1"]}"#), "`a` has an `enum`"),
            (&object(r#"{"type":"number","minimum":1,"default":0}"#), "the default of its option `a`"),
            (&object(r#"{"type":"string","enum":["b"],"default":"c"}"#), "the default of its option `a`"),
        ] {
            let e = read_options(schema).unwrap_err();
            assert!(e.contains(words), "{schema}: {e}");
        }
    }
}
