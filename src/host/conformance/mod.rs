//! What every plugin must stand: tried on a library by `planform plugins check`.
//!
//! Each check runs in a process of its own, so that one that kills the plugin is a finding like any other.

mod adapter;
mod exporter;
mod material;

use super::isolated::{Limits, Process};
use planform_sdk::abi::host::Plugin;
use planform_sdk::{ErrorKind, OptionSpec, OptionValue, Options, PluginError, PluginInfo, Source};
use std::path::Path;
use std::sync::Arc;
use std::thread;

/// What is tried: a library's plugins, and a document that its input adapters read.
pub struct Subject<'a> {
    /// The library's plugins.
    pub plugin: &'a Plugin,
    /// The document, if the user gave one.
    pub sample: Option<&'a Source>,
}

/// How a check is done: the fault that it found, if any, as a sentence.
type Try = fn(&Subject<'_>) -> Result<(), String>;

/// What a check needs of a library.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Needs {
    Adapter,
    AdapterAndSample,
    Exporter,
}

/// One check.
struct Check {
    /// What the plugin does if all is well, after "it": "reads garbage without harm".
    title: &'static str,
    needs: Needs,
    run: Try,
}

const fn check(title: &'static str, needs: Needs, run: Try) -> Check {
    Check { title, needs, run }
}

const CHECKS: [Check; 17] = [
    check("says what it reads", Needs::Adapter, adapter::information),
    check("probes garbage, and paths of every kind", Needs::Adapter, adapter::probes_garbage),
    check("reads garbage without harm", Needs::Adapter, adapter::reads_garbage),
    check("refuses options outside its schema, or ignores them", Needs::Adapter, adapter::options),
    check("recognises and reads its sample", Needs::AdapterAndSample, adapter::reads_sample),
    check("reads a sample that is cut short without harm", Needs::AdapterAndSample, adapter::reads_cut),
    check("reads a damaged sample without harm", Needs::AdapterAndSample, adapter::reads_damaged),
    check("reads a sample of absurd sizes without harm", Needs::AdapterAndSample, adapter::reads_absurd),
    check("reads what is not UTF-8 without harm", Needs::AdapterAndSample, adapter::reads_not_utf8),
    check("gives up when its grid is refused", Needs::AdapterAndSample, adapter::gives_up),
    check("reads the same from the same, also on several threads", Needs::AdapterAndSample, adapter::repeats),
    check("says what it writes", Needs::Exporter, exporter::information),
    check("writes a layout", Needs::Exporter, exporter::writes),
    check("writes odd layouts without harm", Needs::Exporter, exporter::writes_odd),
    check("refuses options outside its schema, or ignores them", Needs::Exporter, exporter::options),
    check("gives up when the disk is full", Needs::Exporter, exporter::gives_up),
    check("writes the same from the same, also on several threads", Needs::Exporter, exporter::repeats),
];

/// How a check went.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Outcome {
    /// All is well.
    Passed,
    /// This is wrong.
    Failed(String),
    /// It was not done, for this reason.
    NotRun(&'static str),
}

/// A check and how it went.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// What the plugin does if all is well, after "it".
    pub title: &'static str,
    /// How it went.
    pub outcome: Outcome,
}

/// Tries a library: a finding for each check, told as they come. Fails if the library cannot be loaded.
pub fn try_library(
    library: &Path,
    sample: Option<&Source>,
    limits: &Limits,
    mut tell: impl FnMut(&Finding),
) -> Result<Vec<Finding>, String> {
    let (adapters, exporters) = Arc::new(Process::new(library, limits)).describe()?;
    let is_met = |needs| match needs {
        Needs::Adapter | Needs::AdapterAndSample => !adapters.is_empty(),
        Needs::Exporter => !exporters.is_empty(),
    };
    let findings =
        CHECKS.iter().enumerate().filter(|(_, check)| is_met(check.needs)).map(|(number, check)| {
            let outcome = match (check.needs, sample) {
                (Needs::AdapterAndSample, None) => {
                    Outcome::NotRun("give a document that it reads, `--sample FILE`")
                }
                _ => outcome(&Process::new(library, limits), number, sample),
            };
            let finding = Finding { title: check.title, outcome };
            tell(&finding);
            finding
        });
    Ok(findings.collect())
}

fn outcome(process: &Process, number: usize, sample: Option<&Source>) -> Outcome {
    match process.check(number, sample) {
        Ok(None) => Outcome::Passed,
        Ok(Some(fault)) => Outcome::Failed(fault),
        Err(e) => {
            let words = process.last_words();
            let tried = words.lines().rev().find_map(|line| line.strip_prefix(AT));
            Outcome::Failed(tried.map_or_else(|| e.message.clone(), |what| format!("{what}: {}", e.message)))
        }
    }
}

/// Does one check in this process, by its number.
pub fn run(number: usize, subject: &Subject<'_>) -> Result<(), String> {
    CHECKS.get(number).map_or_else(|| Err("there is no such check".into()), |check| (check.run)(subject))
}

/// What comes before the words by which a check says on standard error what it is about to try.
pub const AT: &str = "trying: ";

/// Says what is about to be tried, for the case that the plugin does not survive it.
fn about_to_try(what: &str) {
    eprintln!("{AT}{}", what.replace('\n', " "));
}

/// Fails if there is nothing, or nothing usable, where a plugin says something of itself.
fn information_of(info: &PluginInfo) -> Result<(), String> {
    for (what, text) in
        [("description", &info.description), ("version", &info.version), ("licence", &info.licence)]
    {
        if text.trim().is_empty() {
            return Err(format!("`{}` has no {what}", info.name));
        }
        if text.contains('\n') {
            return Err(format!("`{}` has a {what} of several lines", info.name));
        }
    }
    if info.extensions.is_empty() {
        return Err(format!("`{}` has no extension", info.name));
    }
    let silent = info.options.iter().find(|o| o.help.trim().is_empty());
    silent.map_or(Ok(()), |o| Err(format!("option `{}` of `{}` has no description", o.name, info.name)))
}

/// Fails if a built-in plugin has the name.
fn not_taken<'a>(
    info: &PluginInfo,
    mut built_in: impl Iterator<Item = &'a PluginInfo>,
) -> Result<(), String> {
    match built_in.find(|b| b.name == info.name) {
        Some(_) => {
            Err(format!("`{}` is the name of a built-in plugin, which is used in its place", info.name))
        }
        None => Ok(()),
    }
}

/// Options as a user would type them.
fn typed(options: &Options) -> String {
    let options: Vec<_> = options.iter().map(|(name, value)| format!("{name}={value}")).collect();
    if options.is_empty() { "(none)".into() } else { options.join(" ") }
}

/// Fails unless it worked, or failed in a decent way: with damaged material both are right.
fn harmless<T>(what: &str, result: Result<T, PluginError>) -> Result<(), String> {
    result.map_or_else(|e| decent(what, &e), |_| Ok(()))
}

/// Fails if an error is the plugin's own fault, or says nothing.
fn decent(what: &str, error: &PluginError) -> Result<(), String> {
    if error.kind == ErrorKind::Plugin {
        return Err(format!("{what}: {}", error.message));
    }
    if error.message.trim().is_empty() || error.message.contains("did not say why") {
        return Err(format!("{what}: it fails without a message"));
    }
    if error.message.chars().count() > LONGEST_MESSAGE {
        return Err(format!(
            "{what}: its message has more than {LONGEST_MESSAGE} characters; cut what it quotes"
        ));
    }
    Ok(())
}

/// The longest decent message, characters.
const LONGEST_MESSAGE: usize = 1000;

/// How often, and on how many threads at once, the same is read or written.
const REPEATS: usize = 20;
const THREADS: usize = 4;

/// Whether a repetition comes to the same on several threads at once.
fn on_threads(repeat: impl Fn() -> bool + Sync) -> bool {
    thread::scope(|scope| {
        let threads: Vec<_> = (0..THREADS).map(|_| scope.spawn(&repeat)).collect();
        threads.into_iter().all(|thread| thread.join().unwrap_or(false))
    })
}

/// The options that a user gets who sets none.
fn defaults(specs: &[OptionSpec]) -> Options {
    // No option is given that could be refused.
    Options::parse(specs, []).unwrap_or_default()
}

/// Options that no user can set: unknown ones, and known ones with values of the wrong kind.
fn bad_options(specs: &[OptionSpec]) -> Vec<Options> {
    let values = [
        OptionValue::Number(-1e300),
        OptionValue::Number(1e300),
        OptionValue::Number(0.0),
        OptionValue::Flag(true),
        OptionValue::Text(String::new()),
        OptionValue::Text("\u{0}\u{1f6aa}%n%s".repeat(20)),
    ];
    let names = specs.iter().map(|s| s.name.clone()).chain(["no-such-option".into(), String::new()]);
    let with = |name: String, value: &OptionValue| {
        let defaults = defaults(specs).values().into_iter();
        Options::unchecked(defaults.chain([(name, value.clone())]))
    };
    let bad = names.flat_map(|name| values.iter().map(move |value| with(name.clone(), value)));
    bad.chain([Options::default()]).collect()
}

/// A path that is not UTF-8, where there can be one.
#[cfg(test)]
pub fn odd_path() -> std::ffi::OsString {
    material::path_not_utf8("plan").map_or_else(|| "plan".into(), Into::into)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_must_have_a_reason() {
        let error = |kind, message: &str| PluginError::new(kind, message);
        assert!(decent("x", &error(ErrorKind::BadInput, "is empty")).is_ok());
        assert!(decent("x", &error(ErrorKind::Plugin, "panicked")).unwrap_err().starts_with("x: panicked"));
        assert!(decent("x", &error(ErrorKind::BadInput, "")).is_err());
    }

    #[test]
    fn bad_options_are_many_and_bad() {
        let spec = OptionSpec::flag("frame", "Whether there is one", false);
        let bad = bad_options(std::slice::from_ref(&spec));
        let taken = |o: &&Options| Options::of_values(std::slice::from_ref(&spec), o.values()).is_ok();
        // The right kind of value, and none.
        assert_eq!((bad.len(), bad.iter().filter(taken).count()), (19, 2));
    }
}
