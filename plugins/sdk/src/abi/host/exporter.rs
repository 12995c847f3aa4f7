//! A library's exporter.
#![allow(unsafe_code)]

use super::fault::{Fault, Trial, of_plugin};
use super::json::Json;
use super::{LoadError, info};
use crate::abi::guard::guard;
use crate::abi::string::Terminated;
use crate::abi::table::look;
use crate::abi::{
    PLANFORM_OK, PLANFORM_PLUGIN_FAULT, PLANFORM_THREAD_SAFE, PlanformDocument, PlanformExporter,
    PlanformGrid, PlanformOutput, PlanformProblem, PlanformStatus,
};
use crate::{Document, Exporter, Options, Output, PluginError, PluginInfo};
use std::ffi::c_void;
use std::io::Write;
use std::ptr;
use std::slice;
use std::sync::{Arc, Mutex, PoisonError};

/// An exporter by its table.
pub struct AbiExporter {
    /// What its functions are given.
    address: *const PlanformExporter,
    table: PlanformExporter,
    info: PluginInfo,
    companions: Vec<String>,
    /// Held during calls of a library that does not claim to be safe with threads.
    lock: Option<Arc<Mutex<()>>>,
}

// SAFETY: the table is valid for ever and constant; calls are made one at a time unless the plugin claims that they
// may be made from several threads at once.
unsafe impl Send for AbiExporter {}
// SAFETY: as above.
unsafe impl Sync for AbiExporter {}

impl AbiExporter {
    /// The exporter of the table at this address; `lock` is held during its calls if it needs that.
    ///
    /// # Safety
    ///
    /// `address` is NULL or that of an exporter's table of a library that keeps to the ABI and is never unloaded.
    pub(super) unsafe fn new(
        address: *const PlanformExporter,
        lock: &Arc<Mutex<()>>,
    ) -> Result<Self, LoadError> {
        // SAFETY: as the caller promises.
        let table = unsafe { look(address) }?;
        // SAFETY: as the caller promises.
        let (info, flags) = unsafe { info::read(table.info) }?;
        if table.write.is_none() {
            return Err(LoadError::NoFunction { name: info.name, function: "write" });
        }
        // SAFETY: as the caller promises; NULL in tables of before version 1.2.
        let companions = unsafe { info::companions(table.companions, &info.name) }?;
        let lock = (flags & PLANFORM_THREAD_SAFE == 0).then(|| Arc::clone(lock));
        Ok(Self { address, table, info, companions, lock })
    }

    /// Whether it claims that it may be called from several threads at once.
    pub fn is_thread_safe(&self) -> bool {
        self.lock.is_none()
    }
}

impl Exporter for AbiExporter {
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
        self.try_write(document, options, output)?.result
    }
}

impl AbiExporter {
    /// As [`Exporter::write_files`], and tells how the plugin took it if the file failed.
    pub fn try_write(
        &self,
        document: &Document<'_>,
        options: &Options,
        output: Output<'_>,
    ) -> Result<Trial<()>, PluginError> {
        let (layout, options) = (Json::new(document.layout)?, Json::of_options(options)?);
        let scene = document.scene.map(|scene| Json::new(&scene.annotations())).transpose()?;
        let grid = document.scene.map(|scene| PlanformGrid::of(&scene.grid));
        let (layout, scene) = (layout.as_table(), scene.as_ref().map(Json::as_table));
        let crossing = PlanformDocument {
            size: size_of::<PlanformDocument>(),
            layout: &layout,
            grid: grid.as_ref().map_or(ptr::null(), ptr::from_ref),
            scene: scene.as_ref().map_or(ptr::null(), ptr::from_ref),
        };
        let Output { stem, extension, file: out, companions } = output;
        let (stem, extension) = (Terminated::new(stem), Terminated::new(extension));
        let receiver = Receiver(Mutex::new(Receiving { out, companions, fault: Fault::default() }));
        let output = PlanformOutput {
            size: size_of::<PlanformOutput>(),
            context: ptr::from_ref(&receiver).cast_mut().cast(),
            write,
            fail,
            stem: stem.as_string(),
            extension: extension.as_string(),
            companion: Some(companion),
        };
        let _locked = self.lock.as_ref().map(|lock| lock.lock().unwrap_or_else(PoisonError::into_inner));
        let Some(write) = self.table.write else { return Err(of_plugin("it has no function `write`")) };
        // SAFETY: the table is valid, and everything that is handed over lives until the call returns.
        let status = unsafe { write(self.address, &crossing, &options.as_table(), &output) };
        let fault = receiver.0.into_inner().unwrap_or_else(PoisonError::into_inner).fault;
        Ok(Trial { late_calls: fault.late_calls(), status, result: fault.end(status) })
    }
}

/// An output being written.
struct Receiving<'a> {
    out: &'a mut dyn Write,
    companions: &'a mut [Vec<u8>],
    fault: Fault,
}

/// The same, behind a lock: an exporter may call from several threads.
struct Receiver<'a>(Mutex<Receiving<'a>>);

/// Does something with the output of a call.
///
/// # Safety
///
/// `context` is that of an output whose call has not ended.
unsafe fn with(
    context: *mut c_void,
    work: impl FnOnce(&mut Receiving<'_>) -> PlanformStatus,
) -> PlanformStatus {
    // SAFETY: as the caller promises.
    let receiver = unsafe { &*context.cast::<Receiver<'_>>() };
    guard(|| work(&mut receiver.0.lock().unwrap_or_else(PoisonError::into_inner)))
        .unwrap_or(PLANFORM_PLUGIN_FAULT)
}

unsafe extern "C" fn write(context: *mut c_void, bytes: *const u8, length: usize) -> PlanformStatus {
    let take = |receiving: &mut Receiving<'_>, bytes: &[u8]| match receiving.out.write_all(bytes) {
        Ok(()) => PLANFORM_OK,
        Err(e) => receiving.fault.note(e.into()),
    };
    // SAFETY: the plugin hands back the context that it was given, during the call, and bytes of its own.
    unsafe { with_bytes(context, bytes, length, take) }
}

unsafe extern "C" fn companion(
    context: *mut c_void,
    number: usize,
    bytes: *const u8,
    length: usize,
) -> PlanformStatus {
    let take = |receiving: &mut Receiving<'_>, bytes: &[u8]| match receiving.companions.get_mut(number) {
        Some(file) => {
            file.extend_from_slice(bytes);
            PLANFORM_OK
        }
        None => receiving.fault.note(of_plugin("it writes a companion that is not in its list")),
    };
    // SAFETY: the plugin hands back the context that it was given, during the call, and bytes of its own.
    unsafe { with_bytes(context, bytes, length, take) }
}

/// Takes bytes for the output of a call, unless something went wrong before.
///
/// # Safety
///
/// `context` is that of an output whose call has not ended; `bytes` is NULL or points to `length` bytes that live until
/// this returns.
unsafe fn with_bytes(
    context: *mut c_void,
    bytes: *const u8,
    length: usize,
    take: impl FnOnce(&mut Receiving<'_>, &[u8]) -> PlanformStatus,
) -> PlanformStatus {
    let work = |receiving: &mut Receiving<'_>| {
        if receiving.fault.precedes_call() {
            return PLANFORM_PLUGIN_FAULT;
        }
        if length == 0 {
            return PLANFORM_OK;
        }
        if bytes.is_null() {
            return receiving.fault.note(of_plugin("it writes from a null pointer"));
        }
        // SAFETY: not NULL; the caller promises that the bytes live until this returns.
        take(receiving, unsafe { slice::from_raw_parts(bytes, length) })
    };
    // SAFETY: as the caller promises.
    unsafe { with(context, work) }
}

unsafe extern "C" fn fail(context: *mut c_void, problem: *const PlanformProblem) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and a problem of its own.
    unsafe { with(context, |receiving| receiving.fault.note_problem(problem)) }
}
