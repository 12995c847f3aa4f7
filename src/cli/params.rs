//! `planform params`, and reading what it prints.

use super::Failure;
use super::failure::print;
use crate::reconstruct::{Method, Params, ReconstructError};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use planform_sdk::Source;
use serde_json::Value;
use std::path::{Path, PathBuf};
use toml::Table;

/// The most bytes of a file of parameters.
const FILE_LIMIT: u64 = 1 << 20;

const EXAMPLES: &str = "\
Example:
  planform params > mine.toml
  (edit mine.toml)
  planform convert map.yaml -o rooms.svg --params mine.toml";

/// Print every parameter of the reconstruction, with its meaning, as a file that `convert --params` reads
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct ParamsArgs {
    /// The method whose parameters to print
    #[arg(long, value_name = "NAME", value_parser = method())]
    method: Option<Method>,
}

/// The flags that choose how to reconstruct.
#[derive(Args)]
pub struct MethodArgs {
    /// The method of reconstruction
    #[arg(long, value_name = "NAME", value_parser = method())]
    method: Option<Method>,
    /// Take the parameters from this file; `planform params` prints one to start from
    #[arg(long, value_name = "FILE.toml")]
    params: Option<PathBuf>,
    /// Set one parameter, over those of the file
    #[arg(long = "param", value_name = "KEY=VALUE")]
    param: Vec<String>,
}

fn method() -> impl TypedValueParser<Value = Method> {
    let named = |name: String| Method::ALL.iter().copied().find(|m| m.name() == name).ok_or("no such method");
    PossibleValuesParser::new(Method::ALL.iter().map(|m| m.name())).try_map(named)
}

pub fn run(args: &ParamsArgs) -> Result<(), Failure> {
    let params = MethodArgs { method: args.method, params: None, param: vec![] }.params()?;
    print(annotated(&params).as_bytes())
}

impl MethodArgs {
    /// The parameters: the file's or the defaults, then the flags'.
    pub fn params(&self) -> Result<Params, Failure> {
        let mut params = self.params.as_deref().map_or_else(|| Ok(Params::default()), read)?;
        params.method = self.method.unwrap_or(params.method);
        self.param.iter().try_fold(params, |params, setting| set(&params, setting))
    }
}

fn read(path: &Path) -> Result<Params, Failure> {
    let source = Source::open(path, FILE_LIMIT).map_err(|e| Failure::of_plugin(path, e))?;
    let text = String::from_utf8(source.bytes).map_err(|_| Failure::over(path, "is not a text in UTF-8"))?;
    let params: Params = toml::from_str(&text).map_err(|e| Failure::over(path, sentence(&e, &text)))?;
    params.check().map_err(|e| Failure::over(path, e))?;
    Ok(params)
}

/// A TOML error in one line, with the number of the line at fault.
fn sentence(error: &toml::de::Error, text: &str) -> String {
    let before = error.span().and_then(|span| text.get(..span.start)).unwrap_or("");
    let line = before.matches('\n').count() + 1;
    let message = plain(error.message());
    format!("line {line}: {message}; `planform params` prints all that there are")
}

/// The parameters with the one changed that `KEY=VALUE` names.
fn set(params: &Params, setting: &str) -> Result<Params, Failure> {
    let usage = |reason: String| Failure::Usage(format!("--param {setting}: {reason}"));
    let (key, value) = setting.split_once('=').ok_or_else(|| usage("write KEY=VALUE".into()))?;
    let mut table = Table::try_from(params).map_err(|e| usage(e.to_string()))?;
    let place = find(&mut table, key).ok_or_else(|| {
        usage(format!("there is no parameter `{key}`; `planform params` prints all that there are"))
    })?;
    *place = parse(value);
    let params: Params = table.try_into().map_err(|e: toml::de::Error| usage(plain(e.message())))?;
    params.check().map_err(|e| usage(e.to_string()))?;
    Ok(params)
}

/// What `serde` says is wrong, in words for people, in one line.
fn plain(message: &str) -> String {
    let message = message.trim_end().replace('\n', ", ");
    let Some((found, expected)) = message.split_once(", expected ") else { return message };
    if let Some(found) = found.strip_prefix("invalid type: ").or(found.strip_prefix("invalid value: ")) {
        return format!("must be {}, not {}", wanted(expected), found.replace("string", "the text"));
    }
    let words = expected.trim_start_matches("one of ");
    if let Some(found) = found.strip_prefix("unknown variant ") {
        return format!("{found} is not one of {words}");
    }
    if let Some(found) = found.strip_prefix("unknown field ") {
        return format!("there is no parameter {found} here, only {words}");
    }
    message
}

/// A type of Rust in words.
fn wanted(expected: &str) -> &str {
    match expected {
        "u8" => "a whole number from 0 to 255",
        "u16" | "u32" | "u64" | "usize" => "a whole number of at least 0",
        "f32" | "f64" => "a number",
        other if other.starts_with("struct ") => "a table of parameters",
        other => other,
    }
}

/// The failure over a flag that sets a parameter.
pub fn exceed(error: &ReconstructError) -> Failure {
    Failure::Usage(error.to_string())
}

fn find<'a>(table: &'a mut Table, key: &str) -> Option<&'a mut toml::Value> {
    match key.split_once('.') {
        Some((first, rest)) => find(table.get_mut(first)?.as_table_mut()?, rest),
        None => table.get_mut(key),
    }
}

/// A TOML value; what is none is a text without its quotes.
fn parse(value: &str) -> toml::Value {
    let line: Option<Table> = toml::from_str(&format!("v = {value}")).ok();
    line.and_then(|mut t| t.remove("v")).unwrap_or_else(|| toml::Value::String(value.into()))
}

/// The parameters as TOML, each under the words that document it.
fn annotated(params: &Params) -> String {
    let schema = schemars::schema_for!(Params);
    let mut text = String::from("# Parameters of planform. Lengths are in metres, angles in radians.\n");
    let mut table = String::new();
    for line in toml::to_string(params).unwrap_or_default().lines().filter(|l| !l.is_empty()) {
        let path = match (line.strip_prefix('['), line.split_once(" = ")) {
            (Some(header), _) => {
                table = format!("{}.", header.trim_end_matches(']'));
                table.clone()
            }
            (None, Some((key, _))) => format!("{table}{key}"),
            (None, None) => continue,
        };
        text += &format!("\n{}{line}\n", comment(schema.as_value(), path.trim_end_matches('.')));
    }
    text
}

/// The description of the property at this path, as comment lines.
fn comment(schema: &Value, path: &str) -> String {
    let property =
        path.split('.').try_fold(schema, |node, key| resolved(schema, node)["properties"].get(key));
    let Some(property) = property else { return String::new() };
    let target = resolved(schema, property);
    let description = property["description"].as_str().or(target["description"].as_str()).unwrap_or("");
    description.lines().map(str::to_string).chain(choices(target)).map(|l| format!("# {l}\n")).collect()
}

fn resolved<'a>(schema: &'a Value, node: &'a Value) -> &'a Value {
    let target = node["$ref"].as_str().and_then(|r| r.strip_prefix('#')).and_then(|r| schema.pointer(r));
    target.unwrap_or(node)
}

/// A line for each word that the value may be.
fn choices(node: &Value) -> Vec<String> {
    let words = node["oneOf"].as_array().into_iter().flatten();
    words
        .filter_map(|w| {
            Some(format!("  \"{}\": {}", w["const"].as_str()?, w["description"].as_str().unwrap_or("")))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_printed_reads_back() {
        let params = Params::default();
        assert_eq!(toml::from_str::<Params>(&annotated(&params)).unwrap(), params);
    }

    #[test]
    fn every_parameter_is_explained() {
        let text = annotated(&Params::default());
        let lines: Vec<_> = text.lines().collect();
        for pair in lines.windows(2).filter(|pair| pair[1].contains(" = ") && !pair[1].starts_with('#')) {
            assert!(pair[0].starts_with("# "), "{} has no comment", pair[1]);
        }
    }

    #[test]
    fn one_parameter_is_set_over_the_others() {
        assert_eq!(set(&Params::default(), "method=paper").unwrap().method, Method::Paper);
        for bad in ["method", "methods=paper", "method=guess", "method.x=1"] {
            let Failure::Usage(sentence) = set(&Params::default(), bad).unwrap_err() else { panic!("{bad}") };
            assert!(sentence.starts_with("--param ") && !sentence.contains('\n'), "{sentence}");
        }
    }

    #[test]
    fn a_parameter_out_of_range_is_blamed_on_its_flag() {
        let Failure::Usage(sentence) = set(&Params::default(), "clutter.radius=-1").unwrap_err() else {
            panic!("no usage")
        };
        assert!(sentence.starts_with("--param clutter.radius=-1: parameter `clutter.radius`"), "{sentence}");
    }

    #[test]
    fn wrong_values_are_told_in_plain_words() {
        for (setting, words) in [
            ("rooms.min_points=x", "must be a whole number of at least 0, not the text \"x\""),
            ("contour.free=300", "must be a whole number from 0 to 255, not integer `300`"),
            ("clutter.radius=wide", "must be a number, not the text \"wide\""),
            ("clutter=1", "must be a table of parameters, not integer `1`"),
            ("method=guess", "`guess` is not one of `basins` or `paper`"),
        ] {
            let Failure::Usage(sentence) = set(&Params::default(), setting).unwrap_err() else {
                panic!("{setting}")
            };
            assert_eq!(sentence, format!("--param {setting}: {words}"));
        }
    }

    #[test]
    fn a_wrong_key_is_answered_with_its_line_and_the_right_ones() {
        let text = "# mine\n\nmethodd = \"paper\"\n";
        let e = sentence(&toml::from_str::<Params>(text).unwrap_err(), text);
        assert!(e.starts_with("line 3: ") && e.contains("`methodd`") && e.contains("`method`"), "{e}");
    }
}
