//! An exporter as a table.
#![allow(unsafe_code)]

use super::{info, problem, received};
use crate::abi::guard::guard;
use crate::abi::table::look;
use crate::abi::{
    PLANFORM_OK, PLANFORM_PLUGIN_FAULT, PlanformDocument, PlanformExporter, PlanformJson, PlanformOutput,
    PlanformStatus,
};
use crate::{Document, ErrorKind, Exporter, Output, PluginError};
use std::io::{self, BufWriter, Write};

/// How much of an output crosses at a time: exporters write in small pieces.
const BUFFER: usize = 1 << 16;

/// The table, never freed.
pub fn table(exporter: Box<dyn Exporter>) -> *const PlanformExporter {
    let info = info::table(exporter.info());
    let companions = info::c_texts(exporter.companions());
    Box::leak(Box::new(PlanformExporter {
        size: size_of::<PlanformExporter>(),
        info,
        data: Box::into_raw(Box::new(exporter)).cast(),
        write: Some(write),
        companions,
    }))
}

unsafe extern "C" fn write(
    exporter: *const PlanformExporter,
    document: *const PlanformDocument,
    options: *const PlanformJson,
    output: *const PlanformOutput,
) -> PlanformStatus {
    // SAFETY: the host hands over the table that it was given, and the rest is its own.
    guard(|| unsafe { write_to(exporter, document, options, output) }).unwrap_or(PLANFORM_PLUGIN_FAULT)
}

/// # Safety
///
/// `exporter` is a table that [`table`] made, the others are NULL or of the host's.
unsafe fn write_to(
    exporter: *const PlanformExporter,
    document: *const PlanformDocument,
    options: *const PlanformJson,
    output: *const PlanformOutput,
) -> PlanformStatus {
    // SAFETY: the host hands over an output of its own.
    let Ok(output) = (unsafe { look(output) }) else { return PLANFORM_PLUGIN_FAULT };
    let mut sink = Sink { output: &output, refusal: None };
    let written = guard(|| {
        // SAFETY: `table` put a Box<dyn Exporter> there, which is never freed.
        let exporter = unsafe { (*(*exporter).data.cast::<Box<dyn Exporter>>()).as_ref() };
        // SAFETY: the host hands over a document and options of its own.
        unsafe { write_with(exporter, document, options, &mut sink) }
    });
    match (sink.refusal, written.unwrap_or_else(|panic| Err(problem::of_panic(panic)))) {
        (None, Ok(())) => PLANFORM_OK,
        // The host knows why it refused.
        (Some(status), _) => status,
        // SAFETY: the output is the host's, and its call has not ended.
        (None, Err(e)) => unsafe { problem::report(output.fail, output.context, &e) },
    }
}

/// # Safety
///
/// `document` and `options` are NULL or of the host's.
unsafe fn write_with(
    exporter: &dyn Exporter,
    document: *const PlanformDocument,
    options: *const PlanformJson,
    sink: &mut Sink<'_>,
) -> Result<(), PluginError> {
    // SAFETY: as the caller promises.
    let options = unsafe { received::options(options, &exporter.info().options) }?;
    // SAFETY: as the caller promises.
    let (layout, scene) = unsafe { received::document(document) }?;
    let document = Document { layout: &layout, scene: scene.as_ref() };
    // SAFETY: the host's texts, which live until the call returns.
    let (stem, extension) = unsafe { (sink.output.stem.to_text(), sink.output.extension.to_text()) };
    let mut companions = vec![vec![]; exporter.companions().len()];
    let mut out = BufWriter::with_capacity(BUFFER, &mut *sink);
    let output = Output { stem: &stem, extension: &extension, file: &mut out, companions: &mut companions };
    exporter.write_files(&document, &options, output)?;
    out.flush()?;
    drop(out);
    companions.iter().enumerate().try_for_each(|(number, bytes)| sink.companion(number, bytes))
}

/// The host's output as something to write to.
struct Sink<'a> {
    output: &'a PlanformOutput,
    /// The status that the host first refused with; nothing is handed to it after that.
    refusal: Option<PlanformStatus>,
}

impl Sink<'_> {
    /// Hands over a whole companion.
    fn companion(&mut self, number: usize, bytes: &[u8]) -> Result<(), PluginError> {
        let context = self.output.context;
        let take = self.output.companion.ok_or_else(|| {
            let message =
                "this planform takes no files beside a document (its plugin interface is older than 1.2)";
            PluginError::new(ErrorKind::Unsupported, message).advise("use a newer planform")
        })?;
        // SAFETY: the callback is called with its own context, and the bytes live until it returns.
        self.offer(|| unsafe { take(context, number, bytes.as_ptr(), bytes.len()) })?;
        Ok(())
    }

    /// Calls the host, unless it has refused before.
    fn offer(&mut self, call: impl FnOnce() -> PlanformStatus) -> io::Result<()> {
        if self.refusal.is_none() {
            let status = call();
            self.refusal = (status != PLANFORM_OK).then_some(status);
        }
        match self.refusal {
            None => Ok(()),
            Some(_) => Err(io::Error::other(PluginError::new(ErrorKind::Io, "the host takes no more"))),
        }
    }
}

impl Write for Sink<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let (take, context) = (self.output.write, self.output.context);
        // SAFETY: the callback is called with its own context, and the bytes live until it returns.
        self.offer(|| unsafe { take(context, bytes.as_ptr(), bytes.len()) })?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
