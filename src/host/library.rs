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
    let library = unsafe { Library::new(&path) }.map_err(|e| foreign(&path).unwrap_or_else(|| plain(&e)))?;
    // SAFETY: the symbol has this type in every library that exports it; a library that lies is a broken one.
    let entry = unsafe { library.get::<PlanformEntry>(ENTRY_NAME) };
    let entry =
        *entry.map_err(|_| format!("it has no function `{ENTRY_NAME}`; it is no plugin of planform"))?;
    // Tables and code are used until the program ends.
    std::mem::forget(library);
    // SAFETY: the entry function of a library that is never unloaded.
    unsafe { Plugin::ask(entry) }.map_err(|e| e.to_string())
}

/// Has what plugins in C printed so far leave their buffers: they may never come to do it themselves.
pub fn flush_output() {
    #[cfg(unix)]
    {
        use std::ffi::{c_int, c_void};
        unsafe extern "C" {
            fn fflush(stream: *mut c_void) -> c_int;
        }
        // SAFETY: the C library's own function; NULL means all streams that are written to.
        unsafe { fflush(std::ptr::null_mut()) };
    }
}

/// What kind of file it is, if it is none that this program could load: the system's own words for that are odd.
#[cfg(target_os = "linux")]
fn foreign(library: &Path) -> Option<String> {
    /// The magic number, class and byte order of an ELF file, and the machine it is for, at its place.
    const HEAD: usize = 20;
    let head = |path: &Path| {
        let mut bytes = [0; HEAD];
        std::io::Read::read_exact(&mut std::fs::File::open(path).ok()?, &mut bytes).ok()?;
        Some(bytes)
    };
    let own = head(&std::env::current_exe().ok()?)?;
    match head(library) {
        Some(bytes) if bytes[..4] == own[..4] && (bytes[4..6] != own[4..6] || bytes[18..] != own[18..]) => {
            Some("it was built for another kind of machine".into())
        }
        Some(bytes) if bytes[..4] == own[..4] => None,
        _ => Some("it is no shared library of this system".into()),
    }
}

#[cfg(not(target_os = "linux"))]
fn foreign(_: &Path) -> Option<String> {
    None
}

/// The system's words, without the path in front that the sentence names already.
fn plain(error: &libloading::Error) -> String {
    use std::error::Error;
    let words = error.source().map_or_else(|| error.to_string(), ToString::to_string);
    let words = words.split_once(": ").map_or(words.as_str(), |(_, rest)| rest);
    format!("it cannot be loaded: {words}")
}
