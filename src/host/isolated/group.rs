//! A process with whatever it starts: ended together.

use std::io::{self, BufRead, BufReader, Write};
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// How much of what a process printed last is kept, bytes.
const LAST_WORDS: usize = 4096;

/// Standard input, output and error of a process.
pub type Pipes = (ChildStdin, ChildStdout, ChildStderr);

/// A process in a group of its own; ended when dropped.
pub struct Group {
    child: Child,
    has_been_waited_for: bool,
}

impl Group {
    /// Starts the process, with pipes to this one.
    pub fn start(mut command: Command) -> io::Result<(Self, Pipes)> {
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // With a group of its own, what the process starts is ended with it.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn()?;
        let pipes = child.stdin.take().zip(child.stdout.take()).zip(child.stderr.take());
        let group = Self { child, has_been_waited_for: false };
        let ((input, output), errors) = pipes.ok_or_else(|| io::Error::other("it has no pipes"))?;
        Ok((group, (input, output, errors)))
    }

    /// The process's number.
    pub fn id(&self) -> u32 {
        self.child.id()
    }

    /// Whether the process has ended. It is not waited for: until then its group is its own.
    #[cfg(unix)]
    pub fn has_ended(&mut self) -> bool {
        use rustix::process::{Pid, WaitId, WaitIdOptions, waitid};
        let options = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
        let id = i32::try_from(self.child.id()).ok().and_then(Pid::from_raw).map(WaitId::Pid);
        id.is_none_or(|id| !matches!(waitid(id, options), Ok(None)))
    }

    /// Whether the process has ended.
    #[cfg(not(unix))]
    pub fn has_ended(&mut self) -> bool {
        !matches!(self.child.try_wait(), Ok(None))
    }

    /// Ends the process and what it started, and waits for it. None if that was done before.
    pub fn end(&mut self) -> Option<ExitStatus> {
        // From then on its number may be another's.
        if std::mem::replace(&mut self.has_been_waited_for, true) {
            return None;
        }
        #[cfg(unix)]
        if let Some(group) = i32::try_from(self.child.id()).ok().and_then(rustix::process::Pid::from_raw) {
            // Fails when all of them have ended.
            let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
        }
        let _ = self.child.kill();
        self.child.wait().ok()
    }
}

impl Drop for Group {
    fn drop(&mut self) {
        self.end();
    }
}

/// Keeps the last that the process prints on standard error, and shows it if that is asked for. The channel closes
/// when there is no more.
pub fn overhear(errors: ChildStderr, last_words: Arc<Mutex<Vec<u8>>>, echo: bool) -> Receiver<()> {
    let (open, closed) = channel();
    thread::spawn(move || {
        let _open = open;
        let mut errors = BufReader::new(errors);
        // Nobody is left to be told when standard error is closed.
        while let Ok(line @ [_, ..]) = errors.fill_buf() {
            if echo {
                let _ = io::stderr().write_all(line);
            }
            let mut words = last_words.lock().unwrap_or_else(PoisonError::into_inner);
            words.extend_from_slice(line);
            let excess = words.len().saturating_sub(LAST_WORDS);
            words.drain(..excess);
            let length = line.len();
            errors.consume(length);
        }
    });
    closed
}
