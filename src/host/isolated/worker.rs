//! The process that runs a plugin.

use super::wire::{self, Answer, PathName, Reply, Request, SceneHeader, Values};
use crate::host::conformance::{self, Subject};
use crate::host::library;
use planform_sdk::abi::host::{Plugin, logged};
use planform_sdk::{
    Document, ErrorKind, Exporter, InputAdapter, Options, Output, Picture, PluginError, PluginInfo, Probe,
    ReadWatcher, Source,
};
use std::io::{self, Write};
use std::path::Path;
use std::sync::mpsc::{Receiver, channel};
use std::thread;

/// How much more memory than it may a plugin can take before the system refuses it, MiB: the program sees it pass the
/// limit, and can tell that this was the reason.
#[cfg(unix)]
const MARGIN: u64 = 64;

/// A request and its block.
type Call = (Request, Vec<u8>);

/// Serves the plugins of this library to the program at the other end of standard input and output, until it closes
/// them. At most `memory` MiB are taken.
pub fn serve(library: &Path, memory: u64) -> io::Result<()> {
    let mut out = own_output()?;
    let own = limit_memory(memory)?;
    wire::send(&mut out, &Reply { answer: Answer::Ready(own), logged: vec![] }, &[])?;
    let calls = listen(memory.saturating_mul(1 << 20));
    // Not before somebody listens: it may never come back.
    let plugin = library::load(library);
    for (request, block) in calls {
        let (answer, block) = match &plugin {
            Ok(plugin) => answer(plugin, request, block, &mut out),
            Err(reason) => (Answer::Unusable(reason.clone()), vec![]),
        };
        library::flush_output();
        wire::send(&mut out, &Reply { answer, logged: logged() }, &block)?;
    }
    Ok(())
}

/// Standard output for answers alone: what the plugin prints there goes to standard error.
#[cfg(unix)]
pub fn own_output() -> io::Result<std::fs::File> {
    let own = rustix::io::fcntl_dupfd_cloexec(rustix::stdio::stdout(), 3)?;
    rustix::stdio::dup2_stdout(rustix::stdio::stderr())?;
    Ok(own.into())
}

#[cfg(not(unix))]
pub fn own_output() -> io::Result<io::Stdout> {
    Ok(io::stdout())
}

/// Has the system refuse more memory than this, in MiB, and write no core file. How much address space this process
/// takes by itself, bytes.
#[cfg(unix)]
fn limit_memory(memory: u64) -> io::Result<u64> {
    use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
    let limit = |resource, to: u64| {
        let before = getrlimit(resource);
        let least = |limit: Option<u64>| Some(limit.map_or(to, |l| l.min(to)));
        setrlimit(resource, Rlimit { current: least(before.current), maximum: least(before.maximum) })
    };
    limit(Resource::Core, 0)?;
    let own = super::death::address_space(std::process::id()).unwrap_or(0);
    let most = memory.saturating_add(MARGIN).saturating_mul(1 << 20).saturating_add(own);
    // Not every system can limit the address space; the time limit holds there too.
    let _ = limit(Resource::As, most);
    Ok(own)
}

#[cfg(not(unix))]
fn limit_memory(_: u64) -> io::Result<u64> {
    Ok(0)
}

/// Reads requests as they come. When no more can come, this process ends, whatever the plugin is doing.
fn listen(limit: u64) -> Receiver<Call> {
    // Nothing keeps the thread from noticing the end: calls wait here, and there is only ever one.
    let (calls, received) = channel();
    thread::spawn(move || {
        let mut input = io::stdin().lock();
        while let Ok(call) = wire::receive(&mut input, limit) {
            if calls.send(call).is_err() {
                break;
            }
        }
        end_at_once();
    });
    received
}

/// Ends this process at once: the plugin's own exit handlers may hang.
pub fn end_at_once() {
    #[cfg(unix)]
    let _ = rustix::process::kill_process(rustix::process::getpid(), rustix::process::Signal::KILL);
    std::process::exit(0);
}

/// What the plugin answers, and the block with it.
fn answer(
    plugin: &Plugin,
    request: Request,
    block: Vec<u8>,
    out: &mut (impl Write + Send),
) -> (Answer, Vec<u8>) {
    let answer = match request {
        Request::Describe => Ok((describe(plugin), vec![])),
        Request::Probe { adapter, path } => probe(plugin, adapter, Path::new(&path), &block),
        Request::Read { adapter, path, byte_limit, options, pictures } => {
            let source = Source { path: path.into(), bytes: block, byte_limit };
            read(plugin, adapter, &source, options, &mut Teller { out, pictures })
        }
        Request::Write { exporter, stem, extension, layout, scene, options } => {
            let scene = scene.map(|header| header.with(&block)).transpose();
            scene.map_err(PluginError::from).and_then(|scene| {
                let document = Document { layout: &layout, scene: scene.as_ref() };
                write(plugin, exporter, [&stem, &extension], &document, options)
            })
        }
        Request::Check { number, path } => Ok((check(plugin, number, path, block), vec![])),
    };
    answer.unwrap_or_else(|e| (Answer::Failed(e), vec![]))
}

/// Tells the program of the stages of a reading.
struct Teller<'a, W> {
    out: &'a mut W,
    pictures: bool,
}

impl<W: Write + Send> ReadWatcher for Teller<'_, W> {
    fn wants_pictures(&self) -> bool {
        self.pictures
    }

    fn stage(&mut self, name: &str, picture: Option<Picture<'_>>) {
        let picture = picture.filter(|_| self.pictures);
        let sides = picture.map(|p| (p.width(), p.height()));
        let rgb = picture.map_or([].as_slice(), |p| p.rgb());
        let answer = Answer::Stage { name: name.into(), sides };
        // Fails when nobody listens any more: then this process ends.
        let _ = wire::send(self.out, &Reply { answer, logged: vec![] }, rgb);
    }
}

fn describe(plugin: &Plugin) -> Answer {
    let infos = |infos: Vec<&PluginInfo>| infos.into_iter().cloned().collect();
    Answer::Described {
        adapters: infos(plugin.adapters.iter().map(|a| a.info()).collect()),
        exporters: infos(plugin.exporters.iter().map(|e| e.info()).collect()),
        companions: plugin.exporters.iter().map(|e| e.companions().to_vec()).collect(),
    }
}

type Answered = Result<(Answer, Vec<u8>), PluginError>;

fn probe(plugin: &Plugin, adapter: usize, path: &Path, head: &[u8]) -> Answered {
    let adapter = plugin.adapters.get(adapter).ok_or_else(no_such)?;
    let confidence = adapter.confidence(&Probe { path, head })?;
    Ok((Answer::Claim(confidence), vec![]))
}

fn read(
    plugin: &Plugin,
    adapter: usize,
    source: &Source,
    options: Values,
    watcher: &mut dyn ReadWatcher,
) -> Answered {
    let adapter = plugin.adapters.get(adapter).ok_or_else(no_such)?;
    let options = Options::of_values(&adapter.info().options, options)?;
    let scene = adapter.read_watched(source, &options, watcher)?;
    Ok((Answer::Scene(SceneHeader::of(&scene)), wire::cells_of(&scene.grid)))
}

fn write(
    plugin: &Plugin,
    exporter: usize,
    [stem, extension]: [&str; 2],
    document: &Document<'_>,
    options: Values,
) -> Answered {
    let exporter = plugin.exporters.get(exporter).ok_or_else(no_such)?;
    let options = Options::of_values(&exporter.info().options, options)?;
    let (mut file, mut companions) = (vec![], vec![vec![]; exporter.companions().len()]);
    exporter.write_files(
        document,
        &options,
        Output { stem, extension, file: &mut file, companions: &mut companions },
    )?;
    let lengths = companions.iter().map(Vec::len).collect();
    companions.into_iter().for_each(|bytes| file.extend(bytes));
    Ok((Answer::Written { lengths }, file))
}

fn check(plugin: &Plugin, number: usize, path: Option<PathName>, bytes: Vec<u8>) -> Answer {
    let sample = path.map(|path| Source { path: path.into(), bytes, byte_limit: Source::BYTE_LIMIT });
    Answer::Checked(conformance::run(number, &Subject { plugin, sample: sample.as_ref() }).err())
}

fn no_such() -> PluginError {
    PluginError::new(ErrorKind::Plugin, "the library holds no plugin of this number")
}
