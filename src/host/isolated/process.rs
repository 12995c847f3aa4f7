//! The program's end: starts the process, asks it, and finds out why it does not answer.

use super::death::{Death, address_space};
use super::group::{Group, overhear};
use super::wire::{self, Answer, Reply, Request, SceneHeader};
use super::{Limits, VERB};
use planform_sdk::abi::host::{exact, note};
use planform_sdk::{
    Confidence, Document, ErrorKind, Exporter, InputAdapter, Options, Output, Picture, PluginError,
    PluginInfo, Probe, ReadWatcher, Scene, Source,
};
use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{ChildStdin, ChildStdout, Command};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// How often a working process's memory is looked at.
const LOOK: Duration = Duration::from_millis(10);

/// The longest that a library may take to be loaded and to say what is in it: nobody has asked for it yet.
const LOADING: Duration = Duration::from_secs(10);

/// How long to wait for what a process printed before it ended.
const LAST_WAIT: Duration = Duration::from_millis(200);

/// A request and its block.
type Call = (Request, Vec<u8>);

/// A reply and its block.
type Answered = (Reply, Vec<u8>);

/// A library that is served by a process of its own.
pub struct Process {
    library: PathBuf,
    limits: Limits,
    /// None before the first call, and after the process came to an end.
    running: Mutex<Option<Running>>,
    /// The end of what the process printed on standard error before it came to an end.
    last_words: Mutex<String>,
}

impl Process {
    /// The process for this library; it is not started yet.
    pub fn new(library: &Path, limits: &Limits) -> Self {
        Self {
            library: library.into(),
            limits: limits.clone(),
            running: Mutex::default(),
            last_words: Mutex::default(),
        }
    }

    /// The adapters and exporters of the library; or why it has none, in words that follow the library's name.
    pub fn describe(self: &Arc<Self>) -> Result<(Vec<Remote>, Vec<Remote>), String> {
        let time = self.limits.time.min(LOADING);
        match self.ask_within(Request::Describe, vec![], time, &mut ()) {
            Ok((Answer::Described { adapters, exporters, companions }, _)) => {
                let remotes = |infos: Vec<PluginInfo>, companions: Vec<Vec<String>>| {
                    let companions = companions.into_iter().chain(std::iter::repeat(vec![]));
                    let remote = |(number, (info, companions))| Remote {
                        process: Arc::clone(self),
                        number,
                        info,
                        companions,
                    };
                    infos.into_iter().zip(companions).enumerate().map(remote).collect()
                };
                Ok((remotes(adapters, vec![]), remotes(exporters, companions)))
            }
            Ok((Answer::Unusable(reason), _)) => Err(reason),
            Ok(_) => Err(out_of_turn().to_string()),
            Err(e) => Err(e.to_string()),
        }
    }

    /// Does a check of the conformance suite; the fault that it found.
    pub fn check(&self, number: usize, sample: Option<&Source>) -> Result<Option<String>, PluginError> {
        let path = sample.map(|s| s.path.clone().into());
        let block = sample.map(|s| s.bytes.clone()).unwrap_or_default();
        match self.ask(Request::Check { number, path }, block)? {
            (Answer::Checked(fault), _) => Ok(fault),
            (Answer::Unusable(reason), _) => Ok(Some(reason)),
            _ => Err(out_of_turn()),
        }
    }

    /// The end of what the process printed on standard error before it came to an end.
    pub fn last_words(&self) -> String {
        self.last_words.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Asks the process, which is started if it does not run.
    fn ask(&self, request: Request, block: Vec<u8>) -> Result<(Answer, Vec<u8>), PluginError> {
        self.ask_within(request, block, self.limits.time, &mut ())
    }

    fn ask_within(
        &self,
        request: Request,
        block: Vec<u8>,
        time: Duration,
        watcher: &mut dyn ReadWatcher,
    ) -> Result<(Answer, Vec<u8>), PluginError> {
        let limits = Limits { time, ..self.limits.clone() };
        let mut running = self.running.lock().unwrap_or_else(PoisonError::into_inner);
        let started = match running.take() {
            Some(started) => started,
            None => Running::start(&self.library, &self.limits).map_err(|e| self.cannot_start(&e))?,
        };
        let (Reply { answer, logged }, block) = match started.ask(request, block, &limits, watcher) {
            Ok((reply, started)) => {
                *running = Some(started);
                reply
            }
            Err(death) => return Err(self.told(&death, &limits)),
        };
        logged.into_iter().for_each(note);
        match answer {
            Answer::Failed(e) => Err(e),
            answer => Ok((answer, block)),
        }
    }

    fn told(&self, death: &Death, limits: &Limits) -> PluginError {
        self.last_words.lock().unwrap_or_else(PoisonError::into_inner).clone_from(&death.last_words);
        let (message, advice) = death.told(limits);
        let advice = advice.unwrap_or_else(|| "tell its maker".into());
        PluginError::new(ErrorKind::Plugin, message).advise(advice)
    }

    fn cannot_start(&self, error: &io::Error) -> PluginError {
        let message = format!("no process of planform can be started for it: {error}");
        PluginError::new(ErrorKind::Io, message)
    }
}

fn out_of_turn() -> PluginError {
    PluginError::new(ErrorKind::Plugin, "it answers what it was not asked").advise("tell its maker")
}

/// A process at work.
struct Running {
    group: Group,
    calls: Sender<Call>,
    replies: Receiver<Answered>,
    errors: Receiver<()>,
    last_words: Arc<Mutex<Vec<u8>>>,
    /// The most address space that it was seen with, bytes.
    peak: u64,
    /// How much of that is planform's own, which it says before it loads the library.
    own: Option<u64>,
}

impl Running {
    fn start(library: &Path, limits: &Limits) -> io::Result<Self> {
        let program = limits.program.clone().map_or_else(std::env::current_exe, Ok)?;
        let mut command = Command::new(program);
        command.arg(VERB).arg(library).arg(limits.memory.to_string());
        let (group, (input, output, errors)) = Group::start(command)?;
        let last_words = Arc::default();
        Ok(Self {
            group,
            calls: speak(input),
            replies: hear(output, limits.bytes()),
            errors: overhear(errors, Arc::clone(&last_words), limits.echo),
            last_words,
            peak: 0,
            own: None,
        })
    }

    /// Asks; the process comes back only if it lives.
    fn ask(
        mut self,
        request: Request,
        block: Vec<u8>,
        limits: &Limits,
        watcher: &mut dyn ReadWatcher,
    ) -> Result<(Answered, Self), Box<Death>> {
        // A process that is gone takes no call, and gives no answer either.
        let _ = self.calls.send((request, block));
        let mut end = Instant::now() + limits.time;
        loop {
            match self.replies.recv_timeout(LOOK.min(end.saturating_duration_since(Instant::now()))) {
                Ok((Reply { answer: Answer::Ready(own), .. }, _)) => self.own = Some(own),
                Ok((Reply { answer: Answer::Stage { name, sides }, .. }, rgb)) => {
                    let start = Instant::now();
                    if start >= end {
                        return Err(Box::new(self.end(true)));
                    }
                    watcher.stage(&name, sides.and_then(|(w, h)| Picture::new(w, h, &rgb)));
                    // The plugin waits meanwhile, which is no fault of its own.
                    end += start.elapsed();
                }
                Ok(reply) => return Ok((reply, self)),
                Err(RecvTimeoutError::Timeout) if self.goes_on(limits) && Instant::now() < end => {}
                Err(e) => {
                    let late = e == RecvTimeoutError::Timeout && Instant::now() >= end;
                    return Err(Box::new(self.end(late)));
                }
            }
        }
    }

    /// Whether the process lives and has not taken too much memory.
    fn goes_on(&mut self, limits: &Limits) -> bool {
        self.peak = self.peak.max(address_space(self.group.id()).unwrap_or(0));
        let within = self.own.is_none_or(|own| self.peak.saturating_sub(own) <= limits.bytes());
        within && !self.group.has_ended()
    }

    /// Ends the process, if it has not ended by itself, and what it started.
    fn end(mut self, late: bool) -> Death {
        let by_itself = !late && self.is_ending();
        let status = self.group.end().filter(|_| by_itself);
        let words = self.last_words.lock().unwrap_or_else(PoisonError::into_inner);
        let peak = self.peak.saturating_sub(self.own.unwrap_or(0));
        Death { status, late, last_words: String::from_utf8_lossy(&words).into_owned(), peak }
    }

    /// Whether the process ends by itself: it closes its output shortly before that, and what it printed arrives
    /// shortly after.
    fn is_ending(&mut self) -> bool {
        let end = Instant::now() + LAST_WAIT;
        let _ = self.errors.recv_timeout(LAST_WAIT);
        while !self.group.has_ended() && Instant::now() < end {
            thread::sleep(Duration::from_millis(1));
        }
        self.group.has_ended()
    }
}

/// Writes calls to the process as they come. Not the caller's work: a process that does not read would stop it.
fn speak(mut input: ChildStdin) -> Sender<Call> {
    let (calls, received) = channel::<Call>();
    thread::spawn(move || {
        received.into_iter().try_for_each(|(request, block)| wire::send(&mut input, &request, &block))
    });
    calls
}

/// Reads replies as they come. The channel closes when the process closes its output, or says what makes no sense.
fn hear(output: ChildStdout, limit: u64) -> Receiver<Answered> {
    // A reply waits here and no more do: pictures are large.
    let (replies, received) = sync_channel(1);
    thread::spawn(move || {
        let mut output = BufReader::new(output);
        while let Ok(reply) = wire::receive(&mut output, limit) {
            if replies.send(reply).is_err() {
                return;
            }
        }
    });
    received
}

/// An adapter or exporter in a process of its own.
pub struct Remote {
    process: Arc<Process>,
    number: usize,
    info: PluginInfo,
    companions: Vec<String>,
}

impl Remote {
    /// As [`InputAdapter::probe`], but a plugin that fails at it is told.
    fn confidence(&self, probe: &Probe<'_>) -> Result<Confidence, PluginError> {
        let path = probe.path.into();
        let request = Request::Probe { adapter: self.number, path };
        match self.process.ask(request, probe.head.to_vec())? {
            (Answer::Claim(confidence), _) => Ok(confidence),
            _ => Err(out_of_turn()),
        }
    }
}

impl InputAdapter for Remote {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn probe(&self, probe: &Probe<'_>) -> Confidence {
        self.confidence(probe).unwrap_or_else(|e| {
            note((true, format!("it cannot tell whose document this is: {e}")));
            Confidence::no()
        })
    }

    fn read(&self, source: &Source, options: &Options) -> Result<Scene, PluginError> {
        self.read_watched(source, options, &mut ())
    }

    fn read_watched(
        &self,
        source: &Source,
        options: &Options,
        watcher: &mut dyn ReadWatcher,
    ) -> Result<Scene, PluginError> {
        let request = Request::Read {
            adapter: self.number,
            path: source.path.clone().into(),
            byte_limit: source.byte_limit,
            options: options.values(),
            pictures: watcher.wants_pictures(),
        };
        let process = &self.process;
        match process.ask_within(request, source.bytes.clone(), process.limits.time, watcher)? {
            (Answer::Scene(header), cells) => header.with(&cells).map_err(|_| out_of_turn()),
            _ => Err(out_of_turn()),
        }
    }
}

impl Exporter for Remote {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn write(
        &self,
        document: &Document<'_>,
        options: &Options,
        out: &mut dyn Write,
    ) -> Result<(), PluginError> {
        let mut companions = vec![vec![]; self.companions.len()];
        self.write_files(
            document,
            options,
            Output { stem: "", extension: "", file: out, companions: &mut companions },
        )
    }

    fn companions(&self) -> &[String] {
        &self.companions
    }

    fn write_files(
        &self,
        document: &Document<'_>,
        options: &Options,
        output: Output<'_>,
    ) -> Result<(), PluginError> {
        // Told here: the plugin's process could not even read it.
        exact(document.layout)?;
        document.scene.map(|scene| exact(&scene.annotations())).transpose()?;
        let request = Request::Write {
            exporter: self.number,
            stem: output.stem.into(),
            extension: output.extension.into(),
            layout: Box::new(document.layout.clone()),
            scene: document.scene.map(|scene| Box::new(SceneHeader::of(scene))),
            options: options.values(),
        };
        let cells = document.scene.map(|scene| wire::cells_of(&scene.grid)).unwrap_or_default();
        match self.process.ask(request, cells)? {
            (Answer::Written { lengths }, bytes) => hand_out(&bytes, &lengths, output),
            _ => Err(out_of_turn()),
        }
    }
}

/// Parts a block into the document and its companions, which have these lengths and come last.
fn hand_out(mut bytes: &[u8], lengths: &[usize], output: Output<'_>) -> Result<(), PluginError> {
    if lengths.len() != output.companions.len() {
        return Err(out_of_turn());
    }
    for (companion, length) in output.companions.iter_mut().zip(lengths).rev() {
        let from = bytes.len().checked_sub(*length).ok_or_else(out_of_turn)?;
        companion.extend_from_slice(&bytes[from..]);
        bytes = &bytes[..from];
    }
    Ok(output.file.write_all(bytes)?)
}
