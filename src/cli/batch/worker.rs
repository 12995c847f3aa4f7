//! The process that works on one document.

use super::digest::{Digest, Seen, Stamp};
use super::task::{Answer, Cause, Converted, Fault, Found, Outcome, Staged, Task, Thumbnails};
use super::thumbnail;
use crate::cli::convert::found;
use crate::cli::failure::{Failure, catch_bugs};
use crate::cli::input::{choose, culprit};
use crate::cli::memory::{MIB, most_held};
use crate::cli::output::Target;
use crate::host::isolated::{Limits, end_at_once, own_output, receive, send};
use crate::host::{Choice, OutsideSettings, Registry, Setting, messages, run_options};
use crate::reconstruct::reconstruct;
use planform_sdk::{
    ErrorKind, InputAdapter, Kept, Layout, OpeningKind, Options, Picture, PluginError, PluginInfo,
    ReadWatcher, RoomState, Scene, Source,
};
use std::ffi::OsString;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

/// The most bytes of a task.
const LARGEST_TASK: u64 = 1 << 26;

/// The most warnings of one document that are kept.
const MOST_WARNINGS: usize = 20;

/// Works on the document that standard input tells of, and answers on standard output.
pub fn serve() -> io::Result<()> {
    let mut out = own_output()?;
    let mut input = io::stdin();
    let (task, _): (Task, _) = receive(&mut input, LARGEST_TASK)?;
    end_with(input);
    limit_memory(task.memory);
    let answer = guarded(&task);
    send(&mut out, &answer, &[])
}

/// Ends this process when the program that asked is gone, however that happened.
fn end_with(mut input: io::Stdin) {
    thread::spawn(move || {
        // Nothing more is ever said: this returns when the other end is closed.
        let _ = input.read(&mut [0]);
        end_at_once();
    });
}

/// Has the system refuse more memory than this, in MiB, and write no core file.
#[cfg(unix)]
fn limit_memory(memory: u64) {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
    let limit = |resource, to: u64| {
        let before = getrlimit(resource);
        let least = |limit: Option<u64>| Some(limit.map_or(to, |l| l.min(to)));
        // Not every system can limit this; the program looks at the memory that is held as well.
        let _ = setrlimit(resource, Rlimit { current: least(before.current), maximum: before.maximum });
    };
    limit(Resource::Core, 0);
    // What a process may write to. Unlike its address space it holds nothing that is only set apart.
    limit(Resource::Data, memory.saturating_mul(MIB));
}

#[cfg(not(unix))]
fn limit_memory(_: u64) {}

/// Does the work; a bug becomes a sentence.
fn guarded(task: &Task) -> Answer {
    let command = ["planform".into(), "convert".into(), task.input.clone()];
    let mut work = Work { task, seen: None, thumbnails: Thumbnails::default() };
    let done = catch_bugs(&command, || Ok(work.outcome()));
    let outcome = done.unwrap_or_else(|e: Failure| {
        Outcome::Failed(Fault::new(Cause::Bug, format!("{}: {}", shown(&task.input), e.sentence())))
    });
    Answer { seen: work.seen, thumbnails: work.thumbnails, memory: most_held(), outcome }
}

fn shown(path: &OsString) -> String {
    Path::new(path).display().to_string()
}

/// The work on one document, and what is known of it so far.
struct Work<'a> {
    task: &'a Task,
    seen: Option<Seen>,
    thumbnails: Thumbnails,
}

/// Why there is nothing to publish.
enum Stop {
    LeftOut(String),
    Fault(Fault),
}

impl From<Fault> for Stop {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl Work<'_> {
    fn outcome(&mut self) -> Outcome {
        match self.convert() {
            Ok(converted) => Outcome::Converted(Box::new(converted)),
            Err(Stop::LeftOut(reason)) => Outcome::LeftOut(reason),
            Err(Stop::Fault(fault)) => Outcome::Failed(fault),
        }
    }

    fn convert(&mut self) -> Result<Converted, Stop> {
        let registry = self.registry();
        let source = self.open()?;
        let targets = self.targets(&registry)?;
        let exporters: Vec<_> = targets.iter().map(|t| t.exporter.info()).collect();
        let Choice { adapter, kept, .. } = self.choose(&source, &registry, &exporters)?;
        let options = self.options(adapter, &exporters)?;
        let scene = self.read(adapter, &source, kept, &options[0])?;
        let layout = reconstruct(&scene, &self.task.how.params, &mut ());
        let layout = layout.map_err(|e| self.fault(Cause::Document, e))?;
        self.thumbnails.after = thumbnail::of_layout(&layout);
        let files = self.stage(&targets, &layout, &scene, &options[1..])?;
        self.check_unchanged()?;
        Ok(Converted { found: tally(&layout, &scene, adapter.info()), files })
    }

    fn registry(&self) -> Registry {
        let outside = &self.task.how.outside;
        let limits = |(seconds, memory): (u64, u64)| Limits {
            program: None,
            time: Duration::from_secs(seconds),
            memory: memory.min(self.task.memory),
            echo: false,
        };
        let folders = outside.folders.iter().map(PathBuf::from).collect();
        Registry::builtin()
            .with_outside(OutsideSettings { folders, isolation: outside.isolation.map(limits) })
    }

    fn path(&self) -> &Path {
        Path::new(&self.task.input)
    }

    fn fault(&self, cause: Cause, reason: impl std::fmt::Display) -> Fault {
        Fault::new(cause, format!("{}: {reason}", shown(&self.task.input)))
    }

    fn files(&self) -> Vec<PathBuf> {
        std::iter::once(&self.task.input).chain(&self.task.siblings).map(PathBuf::from).collect()
    }

    /// Notes what the document is, then reads it.
    fn open(&mut self) -> Result<Source, Fault> {
        let files = self.files();
        let stamps = Stamp::of_files(&files).map_err(|e| self.unreadable(e))?;
        let limit = self.task.how.caps.bytes;
        // Before its digest is made: it may be a device without an end, or far too large.
        let source = Source::open(self.path(), limit).map_err(|e| match e.kind {
            ErrorKind::Io => self.fault(Cause::Missing, e),
            _ => self.fault(Cause::Document, e.advise("`--max-bytes` allows more")),
        })?;
        let digest = Digest::of_files(&files).map_err(|e| self.unreadable(e))?;
        self.seen = Some(Seen { stamps, digest });
        if source.bytes.is_empty() {
            return Err(self.fault(Cause::Document, "is empty; was it saved to the end?"));
        }
        Ok(source)
    }

    fn unreadable(&self, error: io::Error) -> Fault {
        let lasting = [io::ErrorKind::NotFound, io::ErrorKind::PermissionDenied, io::ErrorKind::IsADirectory];
        let cause = if lasting.contains(&error.kind()) { Cause::Missing } else { Cause::System };
        self.fault(cause, PluginError::from(error))
    }

    /// Fails if the document changed since it was first looked at.
    fn check_unchanged(&self) -> Result<(), Fault> {
        let now = Stamp::of_files(&self.files()).map_err(|e| self.unreadable(e))?;
        if self.seen.as_ref().is_some_and(|seen| seen.stamps == now) {
            return Ok(());
        }
        let advice = "`--resume` converts it again when it is whole";
        Err(self.fault(Cause::Changed, format!("was changed while it was converted; {advice}")))
    }

    fn targets<'r>(&self, registry: &'r Registry) -> Result<Vec<Target<'r>>, Fault> {
        let target = |(path, format): &(OsString, String)| {
            let exporter = registry.exporter(format);
            let missing = || self.fault(Cause::Plugin, format!("there is no format `{format}` any more"));
            Ok(Target::new(Path::new(path), exporter.ok_or_else(missing)?))
        };
        self.task.outputs.iter().map(target).collect()
    }

    fn choose<'r>(
        &self,
        source: &Source,
        registry: &'r Registry,
        exporters: &[&PluginInfo],
    ) -> Result<Choice<'r>, Stop> {
        let how = &self.task.how;
        let settings = [how.settings.as_slice(), &how.own_settings].concat();
        match choose(source, how.from.as_deref(), &settings, registry, exporters) {
            Ok(choice) => Ok(choice),
            Err(e) if e.kind == ErrorKind::Unsupported && !self.is_promised(registry) => {
                Err(Stop::LeftOut("is no document that planform knows".into()))
            }
            Err(e) => Err(self.fault(Cause::Document, e).into()),
        }
    }

    /// Whether the user, or the file's name, says that it is a document.
    fn is_promised(&self, registry: &Registry) -> bool {
        let extension = self.path().extension().map(|e| e.to_string_lossy().to_lowercase());
        let known = |extension| registry.adapters().any(|(a, _)| a.info().extensions.contains(extension));
        self.task.named || extension.as_ref().is_some_and(known)
    }

    /// The options of the adapter and of the exporters. A setting that is for the whole batch need not be for all of it.
    fn options(&self, adapter: &dyn InputAdapter, exporters: &[&PluginInfo]) -> Result<Vec<Options>, Fault> {
        let plugins: Vec<_> = std::iter::once(adapter.info()).chain(exporters.iter().copied()).collect();
        let how = &self.task.how;
        let taken = how.settings.iter().filter(|s| plugins.iter().any(|p| s.is_for(p)));
        let settings: Vec<Setting> = taken.chain(&how.own_settings).cloned().collect();
        run_options(&settings, &plugins).map_err(|e| {
            self.fault(Cause::Document, culprit(&settings, &plugins).unwrap_or_else(|| e.to_string()))
        })
    }

    fn read(
        &mut self,
        adapter: &dyn InputAdapter,
        source: &Source,
        kept: Kept,
        options: &Options,
    ) -> Result<Scene, Fault> {
        let mut watcher = FirstPicture::default();
        let caps = self.task.how.caps;
        let read = caps.check_source(source, adapter).and_then(|()| {
            let scene = adapter.read_looked_at(source, kept, options, &mut watcher)?;
            caps.check_scene(&scene)?;
            Ok(scene)
        });
        self.thumbnails.before = watcher.picture;
        let scene = read.map_err(|e| match e.kind {
            ErrorKind::Plugin => self.fault(Cause::Plugin, e),
            _ => self.fault(Cause::Document, e),
        })?;
        if self.thumbnails.before.is_none() {
            self.thumbnails.before = thumbnail::of_grid(&scene.grid);
        }
        Ok(scene)
    }

    /// Writes all outputs into the staging folder.
    fn stage(
        &self,
        targets: &[Target<'_>],
        layout: &Layout,
        scene: &Scene,
        options: &[Options],
    ) -> Result<Vec<Staged>, Fault> {
        let mut staged = vec![];
        for (target, options) in targets.iter().zip(options) {
            let content = target.render(layout, scene, options);
            let content = content.map_err(|e| Fault::new(Cause::Plugin, e.sentence()))?;
            let contents = std::iter::once(content.file).chain(content.companions);
            for (path, bytes) in target.paths().into_iter().zip(contents) {
                let at = Path::new(&self.task.staging).join(staged.len().to_string());
                write(&at, &bytes).map_err(|e| unwritable(&path, e))?;
                let (length, digest) = (bytes.len() as u64, Digest::of(&bytes));
                staged.push(Staged { at: at.into(), path: path.into(), bytes: length, digest });
            }
        }
        Ok(staged)
    }
}

/// Writes a new file, safe on the disk.
fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = File::create_new(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

/// The fault of a file that cannot be written.
pub fn unwritable(path: &Path, error: io::Error) -> Fault {
    let cause = match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded | io::ErrorKind::FileTooLarge => {
            Cause::Disk
        }
        io::ErrorKind::NotFound => Cause::Gone,
        _ => Cause::System,
    };
    Fault::new(cause, Failure::of_io(path, error).sentence())
}

/// Keeps a small copy of the first picture of a reading: the page as it came.
#[derive(Default)]
struct FirstPicture {
    picture: Option<String>,
}

impl ReadWatcher for FirstPicture {
    fn wants_pictures(&self) -> bool {
        self.picture.is_none()
    }

    fn stage(&mut self, _: &str, picture: Option<Picture<'_>>) {
        self.picture = self.picture.take().or_else(|| picture.and_then(thumbnail::of_picture));
    }
}

fn tally(layout: &Layout, scene: &Scene, adapter: &PluginInfo) -> Found {
    let openings = |kind| layout.openings.iter().filter(|o| o.kind == kind).count();
    let plugins = messages().into_iter().filter(|(_, (warning, _))| *warning);
    let plugins = plugins.map(|(plugin, (_, message))| format!("plugin {plugin}: {message}"));
    Found {
        summary: found(layout),
        adapter: adapter.name.clone(),
        rooms: layout.rooms.len(),
        partial_rooms: layout.rooms.iter().filter(|r| r.state == RoomState::Partial).count(),
        area: layout.rooms.iter().map(planform_sdk::Room::area).sum(),
        walls: layout.walls.len(),
        doors: openings(OpeningKind::Door),
        passages: openings(OpeningKind::Passage),
        warnings: scene.warnings.iter().cloned().chain(plugins).take(MOST_WARNINGS).collect(),
    }
}
