//! The trait of exporters, and what the host hands them.

use crate::{Layout, Options, PluginError, PluginInfo, Scene};
use std::io::Write;

/// Writes layouts in one format.
///
/// The same document and options give the same bytes, always.
pub trait Exporter: Send + Sync {
    /// Name, extensions, options.
    fn info(&self) -> &PluginInfo;

    /// Writes the document. `out` is buffered by the host and thrown away if an error is returned.
    fn write(
        &self,
        document: &Document<'_>,
        options: &Options,
        out: &mut dyn Write,
    ) -> Result<(), PluginError>;
}

/// What an exporter writes: a layout and, where it exists, the scene that it was reconstructed from.
#[derive(Debug, Clone, Copy)]
pub struct Document<'a> {
    /// The layout.
    pub layout: &'a Layout,
    /// Its scene: the grid picture under a drawing, for example.
    pub scene: Option<&'a Scene>,
}
