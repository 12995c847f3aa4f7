//! What input adapters must stand.

use super::material::{self, Specimen};
use super::{
    REPEATS, Subject, about_to_try, bad_options, defaults, harmless, information_of, not_taken, on_threads,
    typed,
};
use crate::host::Registry;
use planform_sdk::abi::PLANFORM_OK;
use planform_sdk::abi::host::AbiAdapter;
use planform_sdk::{GeoAnchor, InputAdapter, Picture, PluginError, Probe, ReadWatcher, Scene, Source};
use std::time::{Duration, Instant};

/// The longest that a probe may take: every adapter is asked about every document.
const QUICK: Duration = Duration::from_secs(1);

pub fn information(subject: &Subject<'_>) -> Result<(), String> {
    let registry = Registry::builtin();
    subject.plugin.adapters.iter().try_for_each(|a| {
        information_of(a.info())?;
        not_taken(a.info(), registry.builtin_adapters().map(|b| b.info()))
    })
}

fn extension(adapter: &AbiAdapter) -> &str {
    adapter.info().extensions.first().map_or("", String::as_str)
}

fn read(adapter: &AbiAdapter, source: &Source) -> Result<Scene, PluginError> {
    adapter.read(source, &defaults(&adapter.info().options))
}

pub fn probes_garbage(subject: &Subject<'_>) -> Result<(), String> {
    for adapter in &subject.plugin.adapters {
        for Specimen { what, source } in material::garbage(extension(adapter)) {
            probes(adapter, &what, &Probe::of(&source))?;
        }
        for path in material::paths(extension(adapter)) {
            let probe = Probe { path: &path, head: b"some text\n" };
            probes(adapter, &shortened(&format!("the path {path:?}")), &probe)?;
        }
    }
    Ok(())
}

fn probes(adapter: &AbiAdapter, what: &str, probe: &Probe<'_>) -> Result<(), String> {
    about_to_try(what);
    let start = Instant::now();
    adapter.confidence(probe).map_err(|e| format!("{what}: {}", e.message))?;
    if start.elapsed() > QUICK {
        return Err(format!("{what}: its probe takes {:.1} s", start.elapsed().as_secs_f64()));
    }
    Ok(())
}

/// Reads each of these with each adapter: what comes of it does not matter, as long as an error is a decent one.
fn survives(subject: &Subject<'_>, specimens: impl Fn(&AbiAdapter) -> Vec<Specimen>) -> Result<(), String> {
    for adapter in &subject.plugin.adapters {
        for Specimen { what, source } in specimens(adapter) {
            about_to_try(&what);
            harmless(&what, read(adapter, &source))?;
        }
    }
    Ok(())
}

fn sample<'a>(subject: &Subject<'a>) -> Result<&'a Source, String> {
    subject.sample.ok_or_else(|| "there is no sample".into())
}

pub fn reads_garbage(subject: &Subject<'_>) -> Result<(), String> {
    survives(subject, |adapter| material::garbage(extension(adapter)))
}

pub fn reads_cut(subject: &Subject<'_>) -> Result<(), String> {
    let sample = sample(subject)?;
    survives(subject, |_| material::cut(sample))
}

pub fn reads_damaged(subject: &Subject<'_>) -> Result<(), String> {
    let sample = sample(subject)?;
    survives(subject, |_| material::damaged(sample))
}

pub fn reads_absurd(subject: &Subject<'_>) -> Result<(), String> {
    let sample = sample(subject)?;
    survives(subject, |_| material::absurd(sample))
}

pub fn reads_not_utf8(subject: &Subject<'_>) -> Result<(), String> {
    let sample = sample(subject)?;
    survives(subject, |adapter| {
        let path = material::path_not_utf8(extension(adapter));
        let renamed = path.map(|path| Specimen {
            what: "the sample under a name that is not UTF-8".into(),
            source: Source { path, ..sample.clone() },
        });
        material::not_utf8(sample).into_iter().chain(renamed).collect()
    })
}

pub fn options(subject: &Subject<'_>) -> Result<(), String> {
    let nothing = Source { path: "plan".into(), bytes: b"x".to_vec(), byte_limit: 1000 };
    for adapter in &subject.plugin.adapters {
        for options in bad_options(&adapter.info().options) {
            let what = shortened(&format!("the options {}", typed(&options)));
            about_to_try(&what);
            harmless(&what, adapter.read(subject.sample.unwrap_or(&nothing), &options))?;
        }
    }
    Ok(())
}

/// A description for a line.
pub fn shortened(text: &str) -> String {
    text.chars().take(120).collect()
}

/// The adapters that say the sample is theirs.
fn readers<'a>(subject: &Subject<'a>) -> Result<(&'a Source, Vec<&'a AbiAdapter>), String> {
    let sample = sample(subject)?;
    let mut readers = vec![];
    for adapter in &subject.plugin.adapters {
        let confidence =
            adapter.confidence(&Probe::of(sample)).map_err(|e| format!("the sample: {}", e.message))?;
        readers.extend((confidence.percent > 0).then_some(adapter));
    }
    if readers.is_empty() {
        return Err("it does not recognise the sample: its probe answers 0".into());
    }
    Ok((sample, readers))
}

pub fn reads_sample(subject: &Subject<'_>) -> Result<(), String> {
    let (sample, readers) = readers(subject)?;
    readers.iter().try_for_each(|adapter| {
        let scene = read(adapter, sample).map_err(|e| e.to_string());
        scene.and_then(|scene| sensible(&scene)).map_err(|e| format!("the sample: {e}"))
    })
}

/// Fails if the scene says what cannot be so.
fn sensible(scene: &Scene) -> Result<(), String> {
    if let Some(fault) = scene.anchor.as_ref().and_then(GeoAnchor::fault) {
        return Err(format!("its anchor is unusable: {fault}"));
    }
    let texts = scene.texts.iter().map(|t| ("confidence", &t.content, t.confidence));
    let symbols = scene.symbols.iter().map(|s| ("score", &s.kind, s.score));
    let scale = scene.scale.iter().map(|s| ("confidence", &s.source, s.confidence));
    if let Some(scale) = scene.scale.as_ref().filter(|s| s.metres_per_pixel <= 0.0) {
        return Err(format!("its scale is {} metres per pixel", scale.metres_per_pixel));
    }
    let odd = texts.chain(symbols).chain(scale).find(|(_, _, share)| !(0.0..=1.0).contains(share));
    odd.map_or(Ok(()), |(what, of, share)| {
        Err(shortened(&format!("the {what} {share} is not within 0 to 1, of `{of}`")))
    })
}

pub fn gives_up(subject: &Subject<'_>) -> Result<(), String> {
    let (sample, readers) = readers(subject)?;
    for adapter in readers {
        about_to_try("a grid that is refused");
        let options = defaults(&adapter.info().options);
        let trial = adapter.read_refused(sample, &options).map_err(|e| e.to_string())?;
        if trial.status == PLANFORM_OK {
            return Err("its grid is refused, and it says that all is well".into());
        }
        if trial.late_calls > 0 {
            return Err(format!(
                "its grid is refused, and it calls back {} times after that",
                trial.late_calls
            ));
        }
    }
    Ok(())
}

/// Looks at every picture, and does nothing with it.
struct Onlooker;

impl ReadWatcher for Onlooker {
    fn wants_pictures(&self) -> bool {
        true
    }

    fn stage(&mut self, _: &str, _: Option<Picture<'_>>) {}
}

pub fn repeats(subject: &Subject<'_>) -> Result<(), String> {
    let (sample, readers) = readers(subject)?;
    for adapter in readers {
        about_to_try("the sample several times");
        let first = read(adapter, sample).map_err(|e| format!("the sample: {e}"))?;
        let repeat = || (0..REPEATS).all(|_| read(adapter, sample).is_ok_and(|scene| scene == first));
        if !repeat() {
            return Err("it reads something else from the sample when it reads it again".into());
        }
        about_to_try("the sample while somebody looks on");
        let watched = adapter.read_watched(sample, &defaults(&adapter.info().options), &mut Onlooker);
        if watched.map_err(|e| format!("the sample while somebody looks on: {e}"))? != first {
            return Err("it reads something else from the sample when somebody looks on".into());
        }
        about_to_try("the sample on several threads at once");
        if adapter.is_thread_safe() && !on_threads(repeat) {
            return Err("it says that it is thread-safe, and reads something else on several threads".into());
        }
    }
    Ok(())
}
