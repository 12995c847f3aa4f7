//! A list of documents with their options and outputs: CSV, or one JSON object on each line.

use super::{Listed, Row};
use crate::cli::Failure;
use crate::cli::batch::names::stays_below;
use crate::host::Setting;
use planform_sdk::Source;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The most bytes of a manifest.
const LARGEST: u64 = 1 << 28;

/// One line, as it is written.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    input: PathBuf,
    #[serde(default)]
    outputs: Words,
    #[serde(default)]
    options: Pairs,
    #[serde(default)]
    from: Option<String>,
}

/// Several words: a list, or in one text with semicolons between them.
#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Words {
    Text(String),
    List(Vec<String>),
}

/// Several settings: a text `NAME=VALUE;NAME=VALUE`, a list of such, or an object.
#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Pairs {
    Words(Words),
    Object(BTreeMap<String, serde_json::Value>),
}

impl Default for Words {
    fn default() -> Self {
        Self::List(vec![])
    }
}

impl Default for Pairs {
    fn default() -> Self {
        Self::Words(Words::default())
    }
}

impl Words {
    fn all(self) -> Vec<String> {
        match self {
            Self::List(list) => list,
            Self::Text(text) => {
                text.split(';').map(str::trim).filter(|w| !w.is_empty()).map(Into::into).collect()
            }
        }
    }
}

impl Pairs {
    fn settings(self) -> Result<Vec<Setting>, String> {
        match self {
            Self::Words(words) => {
                words.all().iter().map(|w| w.parse().map_err(|e| format!("`{w}`: {e}"))).collect()
            }
            Self::Object(pairs) => pairs.into_iter().map(|(name, value)| setting(&name, &value)).collect(),
        }
    }
}

fn setting(name: &str, value: &serde_json::Value) -> Result<Setting, String> {
    let value = match value {
        serde_json::Value::String(text) => text.clone(),
        serde_json::Value::Number(_) | serde_json::Value::Bool(_) => value.to_string(),
        _ => return Err(format!("the option `{name}` must be a text, a number, true or false")),
    };
    format!("{name}={value}").parse()
}

/// The documents of a manifest. Paths of inputs are relative to the manifest's folder.
pub fn read(path: &Path) -> Result<Vec<Listed>, Failure> {
    let source = Source::open(path, LARGEST).map_err(|e| Failure::of_plugin(path, e))?;
    let text = String::from_utf8(source.bytes).map_err(|_| Failure::over(path, "is not a text in UTF-8"))?;
    let text = text.trim_start_matches('\u{feff}');
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    let lines = match extension.as_str() {
        "csv" => csv_lines(text),
        "jsonl" | "ndjson" => json_lines(text),
        _ => return Err(Failure::over(path, "must be named `.csv` or `.jsonl`, for what it is")),
    };
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut listed = vec![];
    for line in lines {
        let (number, line) = line.map_err(|e| Failure::over(path, e))?;
        listed.push(document(line, folder).map_err(|e| Failure::over(path, format!("line {number}: {e}")))?);
    }
    Ok(listed)
}

type Numbered = Result<(u64, Line), String>;

const COLUMNS: &str = "the columns are `input`, `options`, `outputs` and `from`";

fn csv_lines(text: &str) -> Vec<Numbered> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let headers = match reader.headers() {
        Ok(headers) => headers.clone(),
        Err(e) => return vec![Err(told(&e))],
    };
    if let Some(odd) = headers.iter().find(|h| !["input", "options", "outputs", "from"].contains(h)) {
        return vec![Err(format!("line 1: there is no column `{odd}`; {COLUMNS}"))];
    }
    if !headers.iter().any(|h| h == "input") {
        return vec![Err(format!("line 1: the column `input` is missing; {COLUMNS}"))];
    }
    let line = |record: csv::Result<csv::StringRecord>| {
        let record = record.map_err(|e| told(&e))?;
        let number = record.position().map_or(0, csv::Position::line);
        let field =
            |name: &str| headers.iter().position(|h| h == name).and_then(|i| record.get(i)).unwrap_or("");
        let from = Some(field("from").to_owned()).filter(|f| !f.is_empty());
        Ok((
            number,
            Line {
                input: field("input").into(),
                outputs: Words::Text(field("outputs").into()),
                options: Pairs::Words(Words::Text(field("options").into())),
                from,
            },
        ))
    };
    reader.records().map(line).collect()
}

fn told(e: &csv::Error) -> String {
    let line = e.position().map_or(1, csv::Position::line);
    match e.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("line {line}: has {len} fields where the first line has {expected_len}")
        }
        _ => format!("line {line}: is no CSV"),
    }
}

fn json_lines(text: &str) -> Vec<Numbered> {
    let lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    let parse = |(number, line): (u64, &str)| match serde_json::from_str(line) {
        Ok(line) => Ok((number, line)),
        Err(e) => {
            let reason = e.to_string();
            let reason = reason.split(" at line ").next().unwrap_or_default().to_owned();
            Err(format!(
                "line {number}: {reason}; each line is an object, with `input` and what else it needs"
            ))
        }
    };
    lines.map(parse).collect()
}

fn document(line: Line, folder: &Path) -> Result<Listed, String> {
    if line.input.as_os_str().is_empty() {
        return Err("`input` is empty; name the document's file".into());
    }
    let outputs: Vec<PathBuf> = line.outputs.all().into_iter().map(PathBuf::from).collect();
    if let Some(out) = outputs.iter().find(|o| !stays_below(o)) {
        let advice = "outputs are named by their paths below the output folder";
        return Err(format!("the output `{}` lies outside; {advice}", out.display()));
    }
    let row = Row { outputs, settings: line.options.settings()?, from: line.from };
    Ok(Listed { row, ..Listed::new(place(&line.input), folder.join(&line.input), true) })
}

/// The input's own path if it leads below the manifest's folder, else its name.
fn place(input: &Path) -> PathBuf {
    let named = || input.file_name().map(PathBuf::from).unwrap_or_else(|| input.into());
    if stays_below(input) { input.components().collect() } else { named() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_text(name: &str, text: &str) -> Result<Vec<Listed>, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        read(&path).map_err(|e| match e {
            Failure::Failed(sentence) => sentence.split_once(": ").unwrap().1.into(),
            other => format!("{other:?}"),
        })
    }

    #[test]
    fn both_kinds_say_the_same() {
        let csv = "input,options,outputs\na/1.png,resolution=0.1;svg.scale=50,a.svg; b/a.dxf\n../2.pdf,,\n";
        let jsonl = r#"
            {"input": "a/1.png", "options": {"resolution": 0.1, "svg.scale": "50"}, "outputs": ["a.svg", "b/a.dxf"]}
            {"input": "../2.pdf"}"#;
        let brief =
            |listed: Vec<Listed>| -> Vec<_> { listed.into_iter().map(|l| (l.place, l.row)).collect() };
        let [one, other] = [("m.csv", csv), ("m.jsonl", jsonl)].map(|(n, t)| brief(read_text(n, t).unwrap()));
        assert_eq!(one, other);
        assert_eq!(one[0].1.outputs, [Path::new("a.svg"), Path::new("b/a.dxf")]);
        assert_eq!(one[0].1.settings.len(), 2);
        assert_eq!((one[0].0.as_path(), one[1].0.as_path()), (Path::new("a/1.png"), Path::new("2.pdf")));
    }

    #[test]
    fn mistakes_are_told_with_their_line() {
        for (name, text, words) in [
            ("m.csv", "file\na.png\n", "line 1: there is no column `file`; the columns are"),
            ("m.csv", "from\na\n", "line 1: the column `input` is missing"),
            (
                "m.csv",
                "input,outputs\na.png,a.svg\nb.png\n",
                "line 3: has 1 fields where the first line has 2",
            ),
            ("m.csv", "input\n\"\"\n", "line 2: `input` is empty"),
            ("m.csv", "input,outputs\na.png,../a.svg\n", "line 2: the output `../a.svg` lies outside"),
            ("m.csv", "input,outputs\na.png,/a.svg\n", "line 2: the output `/a.svg` lies outside"),
            ("m.csv", "input,options\na.png,fast\n", "line 2: `fast`: write NAME=VALUE"),
            ("m.jsonl", "{\"input\": \"a\"}\n{\"inputs\": \"b\"}\n", "line 2: unknown field `inputs`"),
            ("m.jsonl", "{\"input\": \"a\", \"options\": {\"x\": [1]}}", "line 1: the option `x` must be"),
            ("m.jsonl", "[1]", "line 1: invalid type"),
            ("m.txt", "a.png", "must be named `.csv` or `.jsonl`"),
        ] {
            let e = read_text(name, text).unwrap_err();
            assert!(e.starts_with(words), "{text}: {e}");
        }
    }
}
