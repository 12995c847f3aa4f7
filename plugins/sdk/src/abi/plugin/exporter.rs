//! An exporter as a table.
#![allow(unsafe_code)]

use super::{info, problem, received};
use crate::abi::guard::guard;
use crate::abi::table::look;
use crate::abi::{
    PLANFORM_OK, PLANFORM_PLUGIN_FAULT, PlanformDocument, PlanformExporter, PlanformJson, PlanformOutput,
    PlanformStatus,
};
use crate::{Document, ErrorKind, Exporter, PluginError};
use std::io::{self, BufWriter, Write};

/// How much of an output crosses at a time: exporters write in small pieces.
const BUFFER: usize = 1 << 16;

/// The table, never freed.
pub fn table(exporter: Box<dyn Exporter>) -> *const PlanformExporter {
    let info = info::table(exporter.info());
    Box::leak(Box::new(PlanformExporter {
        size: size_of::<PlanformExporter>(),
        info,
        data: Box::into_raw(Box::new(exporter)).cast(),
        write: Some(write),
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
    let mut out = BufWriter::with_capacity(BUFFER, sink);
    exporter.write(&Document { layout: &layout, scene: scene.as_ref() }, &options, &mut out)?;
    out.flush().map_err(PluginError::from)
}

/// The host's output as something to write to.
struct Sink<'a> {
    output: &'a PlanformOutput,
    /// The status that the host first refused with; nothing is handed to it after that.
    refusal: Option<PlanformStatus>,
}

impl Write for Sink<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.refusal.is_none() {
            // SAFETY: the callback is called with its own context, and the bytes live until it returns.
            let status = unsafe { (self.output.write)(self.output.context, bytes.as_ptr(), bytes.len()) };
            self.refusal = (status != PLANFORM_OK).then_some(status);
        }
        match self.refusal {
            None => Ok(bytes.len()),
            Some(_) => Err(io::Error::other(PluginError::new(ErrorKind::Io, "the host takes no more"))),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
