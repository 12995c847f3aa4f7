//! The trait of exporters, and what the host hands them.

use crate::{Layout, Options, PluginError, PluginInfo, Scene};
use std::io::Write;

/// Writes layouts in one format.
///
/// The same document and options give the same bytes, always.
pub trait Exporter: Send + Sync {
    /// Name, extensions, options.
    fn info(&self) -> &PluginInfo;

    /// Writes the document, without the companions that it may have. `out` is buffered by the host and thrown away if
    /// an error is returned.
    fn write(
        &self,
        document: &Document<'_>,
        options: &Options,
        out: &mut dyn Write,
    ) -> Result<(), PluginError>;

    /// The extensions of the files that lie beside a document of this format, lower case and without the dot: the
    /// picture of a map, for example. The companion `pgm` of `map.yaml` is `map.pgm`. Most formats have none.
    fn companions(&self) -> &[String] {
        &[]
    }

    /// Writes the document and its companions. An exporter without companions leaves this as it is.
    fn write_files(
        &self,
        document: &Document<'_>,
        options: &Options,
        output: Output<'_>,
    ) -> Result<(), PluginError> {
        self.write(document, options, output.file)
    }
}

/// Where a document and its companions are written to.
pub struct Output<'a> {
    /// The document's file name up to its extension, for what refers to its companions.
    pub stem: &'a str,
    /// The extension without its dot, as the user typed it: it may be none of the exporter's. Empty for what is no
    /// file.
    pub extension: &'a str,
    /// The document; as in [`Exporter::write`].
    pub file: &'a mut dyn Write,
    /// One for each of [`Exporter::companions`], in their order; empty at first.
    pub companions: &'a mut [Vec<u8>],
}

/// What an exporter writes: a layout and, where it exists, the scene that it was reconstructed from.
#[derive(Debug, Clone, Copy)]
pub struct Document<'a> {
    /// The layout.
    pub layout: &'a Layout,
    /// Its scene: the grid picture under a drawing, for example.
    pub scene: Option<&'a Scene>,
}

/// Writes a document with options, as [`Exporter::write`] does.
pub type WriteFn = fn(&Document<'_>, &Options, &mut dyn Write) -> Result<(), PluginError>;

/// An exporter that is no more than a function.
struct Function {
    info: PluginInfo,
    write: WriteFn,
}

impl Exporter for Function {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn write(
        &self,
        document: &Document<'_>,
        options: &Options,
        out: &mut dyn Write,
    ) -> Result<(), PluginError> {
        (self.write)(document, options, out)
    }
}

/// The exporter that writes with this function: what most formats need.
pub fn exporter(info: PluginInfo, write: WriteFn) -> Box<dyn Exporter> {
    Box::new(Function { info, write })
}
