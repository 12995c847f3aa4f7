//! Where a conversion writes to: checked before the work, written whole or not at all.

use super::Failure;
use super::failure::print;
use super::passing::{self, Entry};
use crate::host::Registry;
use planform_sdk::{Document, Exporter, Layout, Options, Output, Scene};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// One output and who writes it.
pub struct Target<'a> {
    /// As the user typed it.
    pub path: PathBuf,
    /// The format.
    pub exporter: &'a dyn Exporter,
    place: Place,
    /// The files beside it, in the order of the exporter's companions.
    companions: Vec<Companion>,
}

/// A file beside an output that belongs to it.
struct Companion {
    /// As the user would type it.
    path: PathBuf,
    place: Place,
}

/// What is written to an output and to its companions.
pub struct Content {
    /// The document.
    pub file: Vec<u8>,
    /// One for each companion of the exporter's.
    pub companions: Vec<Vec<u8>>,
}

/// What kind of thing an output is.
#[derive(Debug, PartialEq, Eq)]
enum Place {
    /// `-`.
    Stdout,
    /// Something that is there and is no regular file, such as `/dev/null`: written to directly.
    Device,
    /// A file, by its path without symbolic links.
    File(PathBuf),
}

/// The outputs of these paths. The format is that of the extension; `to` is that of the others.
pub fn plan<'a>(
    paths: &[PathBuf],
    to: Option<&str>,
    registry: &'a Registry,
) -> Result<Vec<Target<'a>>, Failure> {
    let formats: Vec<_> = paths.iter().map(|p| format(p, to, registry)).collect::<Result<_, _>>()?;
    if let Some(to) = to
        && formats.iter().all(|(_, named_by)| *named_by == NamedBy::Extension)
    {
        let message = format!("--to {to} has no use: every output's extension already names its format");
        return Err(Failure::Usage(message));
    }
    let target = |(path, (exporter, _)): (&PathBuf, _)| Target::new(path, exporter);
    let targets: Vec<_> = paths.iter().zip(formats).map(target).collect();
    check_distinct(&targets)?;
    Ok(targets)
}

/// Fails if two outputs, or what lies beside them, are one file.
fn check_distinct(targets: &[Target<'_>]) -> Result<(), Failure> {
    let files: Vec<_> = targets.iter().flat_map(Target::files).collect();
    let again = |(i, (_, place)): &(usize, (&PathBuf, &Place))| files[..*i].iter().any(|(_, p)| p == place);
    let files = || files.iter().copied().enumerate().filter(|(_, (_, place))| **place != Place::Device);
    match files().find(again) {
        None => Ok(()),
        Some((_, (_, Place::Stdout))) => {
            Err(Failure::Usage("standard output: is given as an output twice".into()))
        }
        Some((_, (path, _))) if targets.iter().flat_map(|t| &t.companions).any(|c| c.path == *path) => {
            let message = "belongs to two outputs, or to one and is another; give them other names";
            Err(Failure::Usage(format!("{}: {message}", path.display())))
        }
        Some((_, (path, _))) => {
            Err(Failure::Usage(format!("{}: is given as an output twice", path.display())))
        }
    }
}

const FOLDER: &str = "is a folder; give the name of a file in it";
const PRESENT: &str = "is there already; `--force` overwrites it";

/// What named an output's format.
#[derive(Clone, Copy, PartialEq, Eq)]
enum NamedBy {
    Extension,
    To,
}

/// The format of an output: that of its extension, else `to`. Those from outside are asked only when the built-in ones
/// do not settle it.
fn format<'a>(
    path: &Path,
    to: Option<&str>,
    registry: &'a Registry,
) -> Result<(&'a dyn Exporter, NamedBy), Failure> {
    let by_extension = |exporter| (exporter, NamedBy::Extension);
    let by_to = |exporter| (exporter, NamedBy::To);
    let built_in = registry.builtin_exporter_for(path).map(by_extension);
    let settled = built_in.or_else(|| registry.builtin_exporter(to?).map(by_to));
    let found = settled.or_else(|| registry.exporter_for(path).map(by_extension));
    found.or_else(|| registry.exporter(to?).map(by_to)).ok_or_else(|| match to {
        Some(to) => no_exporter(to, registry),
        None => no_format(path, registry),
    })
}

fn no_exporter(name: &str, registry: &Registry) -> Failure {
    let names: Vec<_> = registry.exporters().map(|(e, _)| e.info().name.as_str()).collect();
    let names = names.join(", ");
    Failure::Usage(format!("--to: there is no format `{name}`; there are {names}{}", registry.refused()))
}

fn no_format(path: &Path, registry: &Registry) -> Failure {
    if path.is_dir() {
        return Failure::over(path, FOLDER);
    }
    let names: Vec<_> = registry.exporters().map(|(e, _)| e.info().name.as_str()).collect();
    let name = if path == Path::new("-") { "standard output".into() } else { path.display().to_string() };
    let advice = format!("`--to FORMAT` names it, one of {}{}", names.join(", "), registry.refused());
    Failure::Usage(format!("{name}: the name does not tell which format to write; {advice}"))
}

impl Place {
    fn of(path: &Path) -> Self {
        if path == Path::new("-") {
            return Self::Stdout;
        }
        match fs::metadata(path) {
            Ok(m) if !m.is_file() && !m.is_dir() => Self::Device,
            _ => Self::File(real(path)),
        }
    }
}

/// The path without symbolic links, also for a file that is not there yet.
fn real(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| match (folder(path).canonicalize(), path.file_name()) {
        (Ok(folder), Some(name)) => folder.join(name),
        _ => path.into(),
    })
}

/// The folder that a file lies in.
fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

/// The file name's stem and extension: one of the exporter's, or else what follows the last dot.
fn parted(path: &Path, exporter: &dyn Exporter) -> (String, String) {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let lower = name.to_lowercase();
    let extensions = exporter.info().extensions.iter().filter(|e| lower.ends_with(&format!(".{e}")));
    // Lower case may be longer than the name: then no place in the one is a place in the other.
    let length = extensions.filter_map(|e| name.len().checked_sub(e.len() + 1)).filter(|l| *l > 0).min();
    let known = length.and_then(|length| Some((name.get(..length)?, name.get(length + 1..)?)));
    let (stem, extension) =
        known.or_else(|| name.rsplit_once('.').filter(|(stem, _)| !stem.is_empty())).unwrap_or((&name, ""));
    (stem.into(), extension.into())
}

impl<'a> Target<'a> {
    /// The output of this path and format.
    pub fn new(path: &Path, exporter: &'a dyn Exporter) -> Self {
        let (stem, _) = parted(path, exporter);
        let companion = |extension: &String| {
            let path = path.with_file_name(format!("{stem}.{extension}"));
            Companion { place: Place::of(&path), path }
        };
        let companions = exporter.companions().iter().map(companion).collect();
        Self { path: path.into(), exporter, place: Place::of(path), companions }
    }

    /// The file name's stem and extension; none for what is no file.
    pub fn name(&self) -> (String, String) {
        match self.place {
            Place::Stdout => Default::default(),
            Place::Device | Place::File(_) => parted(&self.path, self.exporter),
        }
    }

    /// What the document's file and its companions hold.
    pub fn render(&self, layout: &Layout, scene: &Scene, options: &Options) -> Result<Content, Failure> {
        let (mut file, mut companions) = (vec![], vec![vec![]; self.exporter.companions().len()]);
        let document = Document { layout, scene: Some(scene) };
        let (stem, extension) = self.name();
        let output =
            Output { stem: &stem, extension: &extension, file: &mut file, companions: &mut companions };
        let written = self.exporter.write_files(&document, options, output);
        written.map_err(|e| Failure::of_plugin(self.shown(), e))?;
        Ok(Content { file, companions })
    }

    /// Its own path and those of its companions.
    pub fn paths(&self) -> Vec<PathBuf> {
        self.files().map(|(path, _)| path.clone()).collect()
    }

    /// Its own path and place, and those of its companions.
    fn files(&self) -> impl Iterator<Item = (&PathBuf, &Place)> {
        let companions = self.companions.iter().map(|c| (&c.path, &c.place));
        std::iter::once((&self.path, &self.place)).chain(companions)
    }

    /// The output as the user knows it.
    pub fn shown(&self) -> String {
        if self.place == Place::Stdout { "standard output".into() } else { self.path.display().to_string() }
    }

    /// Fails if the output or a companion cannot be written, or must not be, while nothing has been done yet.
    pub fn check(&self, input: &Path, force: bool) -> Result<(), Failure> {
        self.check_named()?;
        let input = input.canonicalize().ok();
        self.files().try_for_each(|(path, place)| {
            let Place::File(real) = place else { return Ok(()) };
            if input.as_ref() == Some(real) {
                return Err(Failure::Usage(format!("{}: is both input and output", path.display())));
            }
            check_file(path, force)
        })
    }

    /// Fails if there is no place beside the output for what belongs there.
    fn check_named(&self) -> Result<(), Failure> {
        let in_folder = |(_, place): (_, &Place)| matches!(place, Place::File(_));
        let Some(companion) = self.exporter.companions().first() else { return Ok(()) };
        if self.files().all(in_folder) {
            return Ok(());
        }
        let name = &self.exporter.info().name;
        let message =
            format!("`{name}` writes a `.{companion}` file beside it; give the name of a file in a folder");
        Err(Failure::Usage(format!("{}: {message}", self.shown())))
    }

    /// Writes a device or standard output.
    fn write_directly(&self, bytes: &[u8]) -> Result<(), Failure> {
        match &self.place {
            Place::Stdout => print(bytes),
            Place::Device => fs::OpenOptions::new()
                .write(true)
                .open(&self.path)
                .and_then(|mut file| file.write_all(bytes))
                .map_err(|e| Failure::of_io(&self.path, e)),
            Place::File(_) => Ok(()),
        }
    }
}

/// Fails if a file cannot be written here, or must not be.
pub fn check_file(path: &Path, force: bool) -> Result<(), Failure> {
    let refuse = |reason: &str| Err(Failure::over(path, reason));
    match fs::metadata(path) {
        Ok(m) if m.is_dir() => refuse(FOLDER),
        Ok(_) if !force => refuse(PRESENT),
        Ok(m) if m.permissions().readonly() => refuse("is read-only; choose another name"),
        Err(_) if path.is_symlink() => refuse("is a link to a file that is not there; give that file's name"),
        Err(e) if e.kind() == io::ErrorKind::InvalidFilename => Err(Failure::of_io(path, e)),
        _ => check_folder(path),
    }
}

fn check_folder(path: &Path) -> Result<(), Failure> {
    let folder = folder(path);
    match fs::metadata(folder) {
        Ok(m) if !m.is_dir() => Err(Failure::over(path, format!("`{}` is not a folder", folder.display()))),
        Err(e) if e.kind() == io::ErrorKind::NotFound => Err(Failure::over(
            path,
            format!("the folder `{}` is not there; create it first", folder.display()),
        )),
        // A file without a name, that nobody ever sees, tells whether the folder takes files.
        Ok(_) => tempfile::tempfile_in(folder).map(drop).map_err(|e| unwritable(path, e)),
        Err(e) => Err(unwritable(path, e)),
    }
}

fn unwritable(path: &Path, error: io::Error) -> Failure {
    let reason = planform_sdk::PluginError::from(error);
    Failure::over(path, format!("the folder `{}` takes no file: {reason}", folder(path).display()))
}

/// Writes every output. Files appear under their names only when all of them are safe on the disk; companions first,
/// so that no document refers to what is not there yet.
pub fn write(targets: &[Target<'_>], contents: &[Content], force: bool) -> Result<(), Failure> {
    let mut staged = Vec::new();
    for (target, content) in targets.iter().zip(contents) {
        let contents = std::iter::once(&content.file).chain(&content.companions);
        for ((path, place), bytes) in target.files().zip(contents) {
            if let Place::File(real) = place {
                staged.push(stage(real, bytes).map_err(|e| Failure::of_io(path, e))?);
            }
        }
    }
    staged.into_iter().rev().try_for_each(|file| file.publish(force))?;
    targets.iter().zip(contents).try_for_each(|(target, content)| target.write_directly(&content.file))
}

/// Writes one file, whole or not at all.
pub fn write_file(path: &Path, bytes: &[u8], force: bool) -> Result<(), Failure> {
    stage(path, bytes).map_err(|e| Failure::of_io(path, e))?.publish(force)
}

/// A file that is safe on the disk under a passing name; removed when dropped, or when the program is interrupted.
struct Staged {
    file: NamedTempFile,
    path: PathBuf,
    entry: Entry<'static>,
}

fn stage(path: &Path, bytes: &[u8]) -> io::Result<Staged> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".planform-");
    // A file like any other that the user makes; without this, nobody else could read it.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let (mut file, entry) = passing::create(|| builder.tempfile_in(folder(path)))?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    Ok(Staged { file, path: path.into(), entry })
}

impl Staged {
    fn publish(self, force: bool) -> Result<(), Failure> {
        let Self { file, path, entry } = self;
        let done = if force { file.persist(&path) } else { file.persist_noclobber(&path) };
        drop(entry);
        // Somebody else may have made the file since it was checked.
        done.map(drop).map_err(|e| match e.error.kind() {
            io::ErrorKind::AlreadyExists => Failure::over(path, PRESENT),
            _ => Failure::of_io(path, e.error),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_appears_whole_and_alone() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.svg");
        write_file(&path, b"one", false).unwrap();
        assert_eq!(write_file(&path, b"two", false).unwrap_err(), Failure::over(&path, PRESENT));
        write_file(&path, b"three", true).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"three");
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
    }

    #[test]
    fn one_file_by_two_names_is_one_place() {
        let dir = tempfile::tempdir().unwrap();
        let plain = dir.path().join("a.svg");
        assert_eq!(Place::of(&plain), Place::of(&dir.path().join(".").join("a.svg")));
        assert_ne!(Place::of(&plain), Place::of(&dir.path().join("b.svg")));
        assert_eq!(Place::of(Path::new("/dev/null")), Place::Device);
    }
}
