//! A library's input adapter.
#![allow(unsafe_code)]

use super::fault::{Trial, of_plugin};
use super::json::Json;
use super::scene::Receiver;
use super::{LoadError, info};
use crate::abi::guard::guard;
use crate::abi::string::Terminated;
use crate::abi::table::look;
use crate::abi::{
    PLANFORM_OK, PLANFORM_PLUGIN_FAULT, PLANFORM_THREAD_SAFE, PlanformAdapter, PlanformProbe, PlanformSource,
    PlanformStatus, PlanformString, PlanformTake,
};
use crate::{
    Confidence, InputAdapter, Options, PluginError, PluginInfo, Probe, Provenance, ReadWatcher, Scene, Source,
};
use std::cell::RefCell;
use std::ffi::c_void;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// An input adapter by its table.
pub struct AbiAdapter {
    /// What its functions are given.
    address: *const PlanformAdapter,
    table: PlanformAdapter,
    info: PluginInfo,
    /// Held during calls of a library that does not claim to be safe with threads.
    lock: Option<Arc<Mutex<()>>>,
}

// SAFETY: the table is valid for ever and constant; calls are made one at a time unless the plugin claims that they
// may be made from several threads at once.
unsafe impl Send for AbiAdapter {}
// SAFETY: as above.
unsafe impl Sync for AbiAdapter {}

impl AbiAdapter {
    /// The adapter of the table at this address; `lock` is held during its calls if it needs that.
    ///
    /// # Safety
    ///
    /// `address` is NULL or that of an adapter's table of a library that keeps to the ABI and is never unloaded.
    pub(super) unsafe fn new(
        address: *const PlanformAdapter,
        lock: &Arc<Mutex<()>>,
    ) -> Result<Self, LoadError> {
        // SAFETY: as the caller promises.
        let table = unsafe { look(address) }?;
        // SAFETY: as the caller promises.
        let (info, flags) = unsafe { info::read(table.info) }?;
        for (function, is_there) in [("probe", table.probe.is_some()), ("read", table.read.is_some())] {
            if !is_there {
                return Err(LoadError::NoFunction { name: info.name, function });
            }
        }
        Ok(Self { address, table, info, lock: (flags & PLANFORM_THREAD_SAFE == 0).then(|| Arc::clone(lock)) })
    }

    /// Whether it claims that it may be called from several threads at once.
    pub fn is_thread_safe(&self) -> bool {
        self.lock.is_none()
    }

    fn locked(&self) -> Option<MutexGuard<'_, ()>> {
        self.lock.as_ref().map(|lock| lock.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl InputAdapter for AbiAdapter {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn probe(&self, probe: &Probe<'_>) -> Confidence {
        self.confidence(probe).unwrap_or_else(|_| Confidence::no())
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
        self.read_into(self.receiver(source, watcher), source, options)?.result
    }
}

impl AbiAdapter {
    fn receiver<'a>(&self, source: &Source, watcher: &'a mut dyn ReadWatcher) -> Receiver<'a> {
        Receiver::new(Provenance { source: source.name(), adapter: self.info.name.clone() }, watcher)
    }

    /// Reads a document whose grid is refused, as one of an absurd size is.
    pub fn read_refused(&self, source: &Source, options: &Options) -> Result<Trial<Scene>, PluginError> {
        self.read_into(self.receiver(source, &mut ()).refusing(), source, options)
    }

    fn read_into<'a>(
        &self,
        receiver: Receiver<'a>,
        source: &'a Source,
        options: &Options,
    ) -> Result<Trial<Scene>, PluginError> {
        let options = Json::of_options(options)?;
        let files = Files { source, receiver };
        let path = Terminated::of_path(&source.path);
        let crossing = PlanformSource {
            size: size_of::<PlanformSource>(),
            context: std::ptr::from_ref(&files).cast_mut().cast(),
            path: path.as_string(),
            bytes: source.bytes.as_ptr(),
            length: source.bytes.len(),
            byte_limit: source.byte_limit,
            sibling,
        };
        let _locked = self.locked();
        let Some(read) = self.table.read else { return Err(of_plugin("it has no function `read`")) };
        // SAFETY: the table is valid, and everything that is handed over lives until the call returns.
        let status = unsafe { read(self.address, &crossing, &options.as_table(), &files.receiver.sink()) };
        Ok(files.receiver.end(status))
    }

    /// As [`InputAdapter::probe`], but an answer that is none is an error.
    pub fn confidence(&self, probe: &Probe<'_>) -> Result<Confidence, PluginError> {
        let said = RefCell::new(String::new());
        let path = Terminated::of_path(probe.path);
        let crossing = PlanformProbe {
            size: size_of::<PlanformProbe>(),
            context: std::ptr::from_ref(&said).cast_mut().cast(),
            path: path.as_string(),
            head: probe.head.as_ptr(),
            head_length: probe.head.len(),
            reason,
        };
        let _locked = self.locked();
        let Some(probe) = self.table.probe else { return Err(of_plugin("it has no function `probe`")) };
        // SAFETY: the table is valid, and everything that is handed over lives until the call returns.
        let answer = unsafe { probe(self.address, &crossing) };
        match u8::try_from(answer) {
            Ok(percent) if percent <= 100 => Ok(Confidence { percent, reason: said.into_inner() }),
            // It failed, and said why in place of what it judged by.
            _ if answer < 0 && !said.borrow().is_empty() => Err(of_plugin(&said.into_inner())),
            _ => Err(of_plugin(&format!("its probe answers {answer}, which is not within 0 to 100"))),
        }
    }
}

unsafe extern "C" fn reason(context: *mut c_void, reason: PlanformString) {
    // Nobody can be told that a reason is lost.
    let _ = guard(|| {
        // SAFETY: the plugin hands back the context that it was given, on the thread that it was called on.
        let said = unsafe { &*context.cast::<RefCell<String>>() };
        // SAFETY: the text lives until this returns.
        said.replace(unsafe { reason.to_text() });
    });
}

/// A document whose files an adapter asks for.
struct Files<'a> {
    source: &'a Source,
    receiver: Receiver<'a>,
}

unsafe extern "C" fn sibling(
    context: *mut c_void,
    reference: PlanformString,
    take: PlanformTake,
    receiver: *mut c_void,
) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, during the call.
    let files = unsafe { &*context.cast::<Files<'_>>() };
    let read = guard(|| {
        // SAFETY: the text lives until this returns.
        let reference = unsafe { reference.to_text() };
        files.source.read_sibling(&reference)
    });
    match read {
        Ok(Ok(bytes)) => {
            // SAFETY: the plugin's own function with its own receiver; the bytes live until it returns.
            unsafe { take(receiver, bytes.as_ptr(), bytes.len()) };
            PLANFORM_OK
        }
        Ok(Err(e)) => files.receiver.with(|taken| taken.refuse(e)),
        Err(_) => PLANFORM_PLUGIN_FAULT,
    }
}
