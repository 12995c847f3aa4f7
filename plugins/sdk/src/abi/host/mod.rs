//! The host's side: a library's tables as [`InputAdapter`](crate::InputAdapter)s and [`Exporter`](crate::Exporter)s.
#![allow(unsafe_code)]

mod adapter;
mod exporter;
mod fault;
mod info;
mod json;
mod scene;
mod value;

pub use adapter::AbiAdapter;
pub use exporter::AbiExporter;
pub use fault::Trial;
pub use json::exact;
pub use value::{Log, host_table, logged, note};

use super::table::{TableError, look};
use super::{PLANFORM_ABI_MAJOR, PlanformAdapter, PlanformEntry, PlanformExporter, PlanformPlugin};
use std::mem::offset_of;
use std::sync::{Arc, Mutex};
use thiserror::Error;

/// The most adapters or exporters in one library, extensions or media types of one of them: what is longer has no end.
const MAX_LIST: usize = 256;

/// Why a library cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum LoadError {
    /// A struct of the library's is unusable.
    #[error(transparent)]
    Table(#[from] TableError),
    /// The entry function returned NULL.
    #[error("it refuses to work with this planform")]
    Refused,
    /// The entry function returned NULL, and logged why.
    #[error("{0}")]
    RefusedBecause(String),
    /// It was made for another major version of the ABI.
    #[error(
        "it was made for version {found} of the plugin interface, and this planform has version {PLANFORM_ABI_MAJOR}; get the plugin for this version, or build it again"
    )]
    WrongMajor {
        /// The version it was made for.
        found: u32,
    },
    /// A list without an end.
    #[error("the list of its {0} has no end within {MAX_LIST} entries")]
    Endless(&'static str),
    /// It has neither adapters nor exporters.
    #[error("it holds no input adapter and no exporter")]
    Nothing,
    /// What an adapter or exporter says of itself is unusable.
    #[error("{0}")]
    Info(String),
    /// A function is missing.
    #[error("`{name}` has no function `{function}`")]
    NoFunction {
        /// The adapter or exporter.
        name: String,
        /// The field of its table.
        function: &'static str,
    },
}

/// The adapters and exporters of one library.
pub struct Plugin {
    /// Its input adapters.
    pub adapters: Vec<AbiAdapter>,
    /// Its exporters.
    pub exporters: Vec<AbiExporter>,
}

impl Plugin {
    /// Asks a library for its tables, and checks them.
    ///
    /// # Safety
    ///
    /// `entry` is the entry function of a library that keeps to the ABI and is never unloaded.
    pub unsafe fn ask(entry: PlanformEntry) -> Result<Self, LoadError> {
        // SAFETY: the host's table is valid for ever, and the tables returned are too, as the caller promises.
        let plugin = unsafe { Self::of_tables(entry(host_table())) };
        plugin.map_err(|e| match (e, logged().pop()) {
            (LoadError::Refused, Some((_, reason))) => LoadError::RefusedBecause(reason),
            (e, _) => e,
        })
    }

    /// Checks a library's tables.
    ///
    /// # Safety
    ///
    /// `plugin` is what the entry function of a library that keeps to the ABI returned; the library is never unloaded.
    pub unsafe fn of_tables(plugin: *const PlanformPlugin) -> Result<Self, LoadError> {
        // SAFETY: as the caller promises.
        let plugin = unsafe { checked_version(plugin) }?;
        // SAFETY: the version fits, so the lists are what they are called.
        let (adapters, exporters) =
            unsafe { (list(plugin.adapters, "input adapters")?, list(plugin.exporters, "exporters")?) };
        if adapters.is_empty() && exporters.is_empty() {
            return Err(LoadError::Nothing);
        }
        // SAFETY: as above; one lock for the whole library, whose parts may share what they work with.
        unsafe {
            let lock: &Arc<Mutex<()>> = &Arc::default();
            let adapters = adapters.into_iter().map(|a: *const PlanformAdapter| AbiAdapter::new(a, lock));
            let exporters = exporters.into_iter().map(|e: *const PlanformExporter| AbiExporter::new(e, lock));
            Ok(Self {
                adapters: adapters.collect::<Result<_, _>>()?,
                exporters: exporters.collect::<Result<_, _>>()?,
            })
        }
    }
}

/// The table, if it is of this major version: nothing but the version may be looked at before.
///
/// # Safety
///
/// As for [`Plugin::of_tables`].
unsafe fn checked_version(plugin: *const PlanformPlugin) -> Result<PlanformPlugin, LoadError> {
    if plugin.is_null() {
        return Err(LoadError::Refused);
    }
    let head = offset_of!(PlanformPlugin, abi_minor);
    // SAFETY: whatever its version, a table begins with its size.
    let size = unsafe { plugin.cast::<usize>().read_unaligned() };
    if size >= head {
        // SAFETY: the table says that it is long enough for the version that follows.
        let found =
            unsafe { plugin.byte_add(offset_of!(PlanformPlugin, abi_major)).cast::<u32>().read_unaligned() };
        if found != PLANFORM_ABI_MAJOR {
            return Err(LoadError::WrongMajor { found });
        }
    }
    // SAFETY: as the caller promises, for this version.
    Ok(unsafe { look(plugin) }?)
}

/// The entries of a list that NULL ends. A NULL list is empty.
///
/// # Safety
///
/// `list` is NULL, or points to pointers of which the last is NULL.
unsafe fn list<T>(list: *const *const T, what: &'static str) -> Result<Vec<*const T>, LoadError> {
    let mut entries = vec![];
    if list.is_null() {
        return Ok(entries);
    }
    for i in 0..=MAX_LIST {
        // SAFETY: no entry before this one was NULL, so there is one here.
        let entry = unsafe { list.add(i).read() };
        if entry.is_null() {
            return Ok(entries);
        }
        entries.push(entry);
    }
    Err(LoadError::Endless(what))
}
