//! What an adapter or exporter says of itself, as a table.

use super::terminated;
use crate::abi::{PLANFORM_THREAD_SAFE, PlanformInfo};
use crate::{PluginInfo, schema};
use std::ffi::{CString, c_char};
use std::ptr;

/// The table, never freed.
pub fn table(info: &PluginInfo) -> *const PlanformInfo {
    let options = if info.options.is_empty() {
        ptr::null()
    } else {
        c_text(&schema::of_options(&info.options).to_string())
    };
    Box::leak(Box::new(PlanformInfo {
        size: size_of::<PlanformInfo>(),
        name: c_text(&info.name),
        description: c_text(&info.description),
        version: c_text(&info.version),
        licence: c_text(&info.licence),
        extensions: c_texts(&info.extensions),
        media_types: c_texts(&info.media_types),
        options,
        // The traits ask for Send and Sync.
        flags: PLANFORM_THREAD_SAFE,
    }))
}

/// A list of C strings that is ended by NULL, never freed.
pub fn c_texts(texts: &[String]) -> *const *const c_char {
    terminated(texts.iter().map(|t| c_text(t)))
}

/// A C string, never freed. Zero bytes, which it cannot hold, are left out.
fn c_text(text: &str) -> *const c_char {
    let bytes: Vec<u8> = text.bytes().filter(|b| *b != 0).collect();
    CString::new(bytes).unwrap_or_default().into_raw()
}
