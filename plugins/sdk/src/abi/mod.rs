//! The C ABI, version 1: how a plugin that was compiled elsewhere, in whatever language, talks with planform.
//!
//! A shared library exports one function, [`PlanformEntry`] under the name `planform_plugin`. It is given the host's
//! table and returns its own, a list of input adapters and exporters. `planform.h` is made from [`types`], so what is
//! said there holds for C too. The rules:
//!
//! * **Versions first.** Nothing but the sizes and version numbers at the head of a table is looked at before they are
//!   known to fit. The major version must be the same; a minor version only adds fields at the end of structs.
//! * **Structs say their size**, so that a reader never looks beyond what the writer knew.
//! * **Memory belongs to whoever made it.** What is handed over is valid until the call returns and is copied by who
//!   wants to keep it; tables are valid for ever, for libraries are never unloaded.
//! * **Panics and exceptions never cross.** A status does, and a message by a callback.
//!
//! [`plugin`] makes tables of a plugin's [`InputAdapter`](crate::InputAdapter)s and [`Exporter`](crate::Exporter)s,
//! `host` (a feature of this crate) makes these of tables again.

mod grid;
mod guard;
#[cfg(feature = "host")]
pub mod host;
pub mod plugin;
mod string;
mod table;
pub mod types;

pub use table::TableError;
pub use types::*;

use crate::{ErrorKind, PluginError};

/// The name of the one function that a plugin library exports.
pub const ENTRY_NAME: &str = "planform_plugin";

/// The kinds of error and the status that each crosses as.
const STATUSES: [(ErrorKind, PlanformStatus); 6] = [
    (ErrorKind::BadInput, PLANFORM_BAD_INPUT),
    (ErrorKind::Unsupported, PLANFORM_UNSUPPORTED),
    (ErrorKind::Limit, PLANFORM_LIMIT),
    (ErrorKind::BadOption, PLANFORM_BAD_OPTION),
    (ErrorKind::Io, PLANFORM_IO),
    (ErrorKind::Plugin, PLANFORM_PLUGIN_FAULT),
];

/// The status that an error crosses as.
fn status_of(error: &PluginError) -> PlanformStatus {
    STATUSES.iter().find(|(kind, _)| *kind == error.kind).map_or(PLANFORM_PLUGIN_FAULT, |(_, status)| *status)
}

#[cfg(feature = "host")]
/// The kind of error that crossed as this status. A status that nobody knows is the plugin's fault.
fn kind_of(status: PlanformStatus) -> ErrorKind {
    STATUSES.iter().find(|(_, s)| *s == status).map_or(ErrorKind::Plugin, |(kind, _)| *kind)
}
