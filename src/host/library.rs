//! Loads a library of plugins into this process.
#![allow(unsafe_code)]

use super::trust;
use libloading::Library;
use planform_sdk::abi::host::Plugin;
use planform_sdk::abi::{ENTRY_NAME, PlanformEntry};
use std::path::Path;

/// Loads the library and reads its tables. Fails with what is wrong with it, as a sentence that goes on after the
/// library's name.
///
/// From here on the library's code runs in this process, and can do to it whatever it likes.
pub fn load(path: &Path) -> Result<Plugin, String> {
    let path = trust::check(path)?;
    // SAFETY: whatever the library does when it is loaded is its own; the user chose it, and nobody else can have
    // written it, as just checked. Processes that must survive it leave this to another one.
    let library = unsafe { Library::new(&path) }.map_err(|e| plain(&e))?;
    // SAFETY: the symbol has this type in every library that exports it; a library that lies is a broken one.
    let entry = unsafe { library.get::<PlanformEntry>(ENTRY_NAME) };
    let entry =
        *entry.map_err(|_| format!("it has no function `{ENTRY_NAME}`; it is no plugin of planform"))?;
    // Tables and code are used until the program ends.
    std::mem::forget(library);
    // SAFETY: the entry function of a library that is never unloaded.
    unsafe { Plugin::ask(entry) }.map_err(|e| e.to_string())
}

/// The system's words, without the path in front that the sentence names already.
fn plain(error: &libloading::Error) -> String {
    use std::error::Error;
    let words = error.source().map_or_else(|| error.to_string(), ToString::to_string);
    let words = words.split_once(": ").map_or(words.as_str(), |(_, rest)| rest);
    format!("it cannot be loaded: {words}")
}
