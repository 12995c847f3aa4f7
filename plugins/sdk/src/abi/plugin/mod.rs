//! The plugin's side: tables of what was written as [`InputAdapter`]s and [`Exporter`]s.
//!
//! A library needs one line of it, [`export_plugin!`](crate::export_plugin).
#![allow(unsafe_code)]

mod adapter;
mod exporter;
mod info;
mod problem;
mod received;

#[cfg(feature = "host")]
pub(super) use problem::of_host;

use super::{
    PLANFORM_ABI_MAJOR, PLANFORM_ABI_MINOR, PLANFORM_LOG_WARNING, PlanformHost, PlanformPlugin,
    PlanformString, guard, table::look,
};
use crate::{Exporter, InputAdapter};
use std::ptr;
use std::sync::OnceLock;

/// The tables of a plugin, made once and valid for ever.
pub struct Tables(PlanformPlugin);

// SAFETY: the tables are never written after they were made, and what they point to is Send and Sync.
unsafe impl Send for Tables {}
// SAFETY: as above.
unsafe impl Sync for Tables {}

impl Tables {
    /// The tables of these adapters and exporters. They are never freed, as plugins are never unloaded.
    pub fn new(adapters: Vec<Box<dyn InputAdapter>>, exporters: Vec<Box<dyn Exporter>>) -> Self {
        Self(PlanformPlugin {
            size: size_of::<PlanformPlugin>(),
            abi_major: PLANFORM_ABI_MAJOR,
            abi_minor: PLANFORM_ABI_MINOR,
            adapters: terminated(adapters.into_iter().map(adapter::table)),
            exporters: terminated(exporters.into_iter().map(exporter::table)),
        })
    }

    /// The table to hand to the host.
    pub fn as_ptr(&self) -> *const PlanformPlugin {
        &self.0
    }
}

/// A list that is ended by NULL and never freed.
fn terminated<T>(tables: impl Iterator<Item = *const T>) -> *const *const T {
    let list: Vec<_> = tables.chain([ptr::null()]).collect();
    Box::leak(list.into_boxed_slice()).as_ptr()
}

/// What a library's entry function does: checks the host, then makes the tables on the first call.
///
/// # Safety
///
/// `host` is NULL or what planform hands to [`PlanformEntry`](super::PlanformEntry).
pub unsafe fn entry(
    host: *const PlanformHost,
    tables: &'static OnceLock<Tables>,
    make: impl FnOnce() -> Tables,
) -> *const PlanformPlugin {
    guard::note_panics();
    // SAFETY: as the caller promises.
    let Ok(host) = (unsafe { look(host) }) else { return ptr::null() };
    if host.abi_major != PLANFORM_ABI_MAJOR {
        return ptr::null();
    }
    guard::guard(|| tables.get_or_init(make).as_ptr()).unwrap_or_else(|panic| {
        // SAFETY: the host's own function, and the text lives until it returns.
        unsafe { (host.log)(PLANFORM_LOG_WARNING, PlanformString::of(panic.as_bytes())) };
        ptr::null()
    })
}

/// Exports a library of plugins: the one line that a crate of crate-type `cdylib` needs.
///
/// ```
/// # use planform_sdk::{Document, Exporter, Options, PluginError, PluginInfo};
/// # fn write(_: &Document<'_>, _: &Options, _: &mut dyn std::io::Write) -> Result<(), PluginError> { Ok(()) }
/// # fn my_exporter() -> Box<dyn Exporter> {
/// #     let text = String::new;
/// #     let info = PluginInfo { name: text(), description: text(), version: text(), licence: text(),
/// #         extensions: vec![], media_types: vec![], options: vec![] };
/// #     planform_sdk::exporter(info, write)
/// # }
/// planform_sdk::export_plugin!(adapters: [], exporters: [my_exporter()]);
/// # fn main() {}
/// ```
#[macro_export]
macro_rules! export_plugin {
    (adapters: [$($adapter:expr),* $(,)?], exporters: [$($exporter:expr),* $(,)?] $(,)?) => {
        /// The entry of planform's C ABI.
        ///
        /// # Safety
        ///
        /// Called by planform with its table.
        #[allow(unsafe_code)]
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn planform_plugin(
            host: *const $crate::abi::PlanformHost,
        ) -> *const $crate::abi::PlanformPlugin {
            static TABLES: ::std::sync::OnceLock<$crate::abi::plugin::Tables> = ::std::sync::OnceLock::new();
            let make = || {
                $crate::abi::plugin::Tables::new(
                    ::std::vec![$($adapter),*],
                    ::std::vec![$($exporter),*],
                )
            };
            // SAFETY: planform calls this with its table.
            unsafe { $crate::abi::plugin::entry(host, &TABLES, make) }
        }
    };
}
