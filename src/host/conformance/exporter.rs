//! What exporters must stand.

use super::adapter::shortened;
use super::{
    REPEATS, Subject, about_to_try, bad_options, defaults, harmless, information_of, material, not_taken,
    on_threads, typed,
};
use crate::host::Registry;
use planform_sdk::abi::PLANFORM_OK;
use planform_sdk::abi::host::AbiExporter;
use planform_sdk::{Document, Exporter, Layout, Output, PluginError, Scene};
use std::io::{self, Write};

pub fn information(subject: &Subject<'_>) -> Result<(), String> {
    let registry = Registry::builtin();
    subject.plugin.exporters.iter().try_for_each(|e| {
        information_of(e.info())?;
        not_taken(e.info(), registry.builtin_exporters().map(|b| b.info()))?;
        let taken =
            |b: &&dyn Exporter| e.info().extensions.first().is_some_and(|x| b.info().extensions.contains(x));
        registry.builtin_exporters().find(taken).map_or(Ok(()), |b| {
            let (name, by) = (&e.info().name, &b.info().name);
            Err(format!(
                "the files of `{name}` have the extension of the built-in `{by}`, which writes them instead"
            ))
        })
    })
}

fn write(exporter: &AbiExporter, layout: &Layout, scene: Option<&Scene>) -> Result<Vec<u8>, PluginError> {
    let (mut out, mut companions) = (vec![], vec![vec![]; exporter.companions().len()]);
    let output = Output { stem: "two rooms", extension: "", file: &mut out, companions: &mut companions };
    exporter.write_files(&Document { layout, scene }, &defaults(&exporter.info().options), output)?;
    companions.into_iter().for_each(|bytes| out.extend(bytes));
    Ok(out)
}

pub fn writes(subject: &Subject<'_>) -> Result<(), String> {
    for exporter in &subject.plugin.exporters {
        for (what, scene) in [("two rooms", None), ("two rooms and their grid", material::scene(30, 20))] {
            about_to_try(what);
            let out = write(exporter, &material::plain_layout(), scene.as_ref());
            if out.map_err(|e| format!("{what}: {e}"))?.is_empty() {
                return Err(format!("{what}: it writes nothing"));
            }
        }
    }
    Ok(())
}

pub fn writes_odd(subject: &Subject<'_>) -> Result<(), String> {
    let plain = material::plain_layout();
    for exporter in &subject.plugin.exporters {
        for (what, layout) in material::odd_layouts() {
            about_to_try(what);
            harmless(what, write(exporter, &layout, None))?;
        }
        for (what, width, height) in
            [("a grid of one cell", 1, 1), ("a grid of 16 million cells", 4000, 4000)]
        {
            about_to_try(what);
            harmless(what, write(exporter, &plain, material::scene(width, height).as_ref()))?;
        }
    }
    Ok(())
}

pub fn options(subject: &Subject<'_>) -> Result<(), String> {
    let layout = material::plain_layout();
    for exporter in &subject.plugin.exporters {
        for options in bad_options(&exporter.info().options) {
            let what = shortened(&format!("the options {}", typed(&options)));
            about_to_try(&what);
            let document = Document { layout: &layout, scene: None };
            harmless(&what, exporter.write(&document, &options, &mut vec![]))?;
        }
    }
    Ok(())
}

/// Takes so many bytes, and then no more.
struct Disk(usize);

impl Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.0.checked_sub(bytes.len()) {
            Some(left) => self.0 = left,
            None => return Err(io::ErrorKind::StorageFull.into()),
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

pub fn gives_up(subject: &Subject<'_>) -> Result<(), String> {
    let layout = material::plain_layout();
    for exporter in &subject.plugin.exporters {
        let options = defaults(&exporter.info().options);
        let mut alone = vec![];
        let document = Document { layout: &layout, scene: None };
        exporter.write(&document, &options, &mut alone).map_err(|e| format!("two rooms: {e}"))?;
        let length = alone.len();
        for room in [0, 1, length / 2, length.saturating_sub(1)] {
            let what = format!("a disk that is full after {room} bytes");
            about_to_try(&what);
            let mut companions = vec![vec![]; exporter.companions().len()];
            let output = Output {
                stem: "two rooms",
                extension: "",
                file: &mut Disk(room),
                companions: &mut companions,
            };
            let trial = exporter.try_write(&document, &options, output).map_err(|e| e.to_string())?;
            if trial.status == PLANFORM_OK {
                return Err(format!("{what}: it says that all is well"));
            }
            if trial.late_calls > 0 {
                return Err(format!("{what}: it calls back {} times after that", trial.late_calls));
            }
        }
    }
    Ok(())
}

pub fn repeats(subject: &Subject<'_>) -> Result<(), String> {
    let (layout, scene) = (material::plain_layout(), material::scene(30, 20));
    for exporter in &subject.plugin.exporters {
        about_to_try("two rooms several times");
        let first = write(exporter, &layout, scene.as_ref()).map_err(|e| format!("two rooms: {e}"))?;
        let again = || write(exporter, &layout, scene.as_ref()).is_ok_and(|out| out == first);
        let repeat = || (0..REPEATS).all(|_| again());
        if !repeat() {
            return Err("it writes other bytes when it writes the same layout again".into());
        }
        about_to_try("two rooms on several threads at once");
        if exporter.is_thread_safe() && !on_threads(repeat) {
            return Err("it says that it is thread-safe, and writes other bytes on several threads".into());
        }
    }
    Ok(())
}
