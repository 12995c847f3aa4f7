//! What an adapter or exporter says of itself, checked.
#![allow(unsafe_code)]

use super::{LoadError, list};
use crate::abi::PlanformInfo;
use crate::abi::string::c_bytes;
use crate::abi::table::look;
use crate::{PluginInfo, schema};
use std::ffi::c_char;

/// The information, copied, and the flags.
///
/// # Safety
///
/// `info` is NULL or a table of a library that keeps to the ABI.
pub unsafe fn read(info: *const PlanformInfo) -> Result<(PluginInfo, u64), LoadError> {
    // SAFETY: as the caller promises.
    let table = unsafe { look(info) }?;
    // SAFETY: its texts are C strings or NULL, its lists end with NULL.
    let info = unsafe {
        let name = text(table.name, "name", "an adapter or exporter")?;
        check_name(&name)?;
        PluginInfo {
            description: text(table.description, "description", &name)?,
            version: text(table.version, "version", &name)?,
            licence: text(table.licence, "licence", &name)?,
            extensions: texts(table.extensions, "extensions", &name)?,
            media_types: texts(table.media_types, "media types", &name)?,
            options: options(table.options, &name)?,
            name,
        }
    };
    check_extensions(&info)?;
    Ok((info, table.flags))
}

fn check_name(name: &str) -> Result<(), LoadError> {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if !name.is_empty() && name.len() <= 64 && name.chars().all(plain) && !name.starts_with('-') {
        return Ok(());
    }
    let shown: String = name.chars().take(64).collect();
    Err(LoadError::Info(format!(
        "`{}` is no name: names are 1 to 64 lower-case letters, digits and hyphens",
        shown.escape_debug()
    )))
}

fn check_extensions(info: &PluginInfo) -> Result<(), LoadError> {
    all_plain(&info.extensions, "extension", &info.name)
}

fn all_plain(extensions: &[String], what: &str, of: &str) -> Result<(), LoadError> {
    let bad = |e: &&String| {
        e.is_empty() || e.starts_with('.') || **e != e.to_lowercase() || e.contains(['/', '\\'])
    };
    extensions.iter().find(bad).map_or(Ok(()), |bad| {
        let shown = bad.escape_debug();
        Err(LoadError::Info(format!(
            "`{of}` has the {what} `{shown}`: write it in lower case, without the dot"
        )))
    })
}

/// The extensions of the companions of an exporter's documents, each once.
///
/// # Safety
///
/// `list` is NULL, or points to C strings of which the last is NULL.
pub unsafe fn companions(list: *const *const c_char, of: &str) -> Result<Vec<String>, LoadError> {
    // SAFETY: as the caller promises.
    let companions = unsafe { texts(list, "companions", of) }?;
    all_plain(&companions, "companion", of)?;
    match companions.iter().enumerate().find(|(i, c)| companions[..*i].contains(c)) {
        Some((_, twice)) => Err(LoadError::Info(format!("`{of}` has the companion `{twice}` twice"))),
        None => Ok(companions),
    }
}

/// # Safety
///
/// `text` is NULL or a C string.
unsafe fn text(text: *const c_char, what: &str, of: &str) -> Result<String, LoadError> {
    // SAFETY: as the caller promises.
    let bytes = unsafe { c_bytes(text) };
    let bytes = bytes.ok_or_else(|| LoadError::Info(format!("the {what} of {of} is missing")))?;
    String::from_utf8(bytes.to_vec()).map_err(|_| LoadError::Info(format!("the {what} of {of} is not UTF-8")))
}

/// # Safety
///
/// `texts` is NULL, or points to C strings of which the last is NULL.
unsafe fn texts(texts: *const *const c_char, what: &'static str, of: &str) -> Result<Vec<String>, LoadError> {
    // SAFETY: as the caller promises.
    unsafe { list(texts, what)?.into_iter().map(|t| text(t, what, of)).collect() }
}

/// # Safety
///
/// `schema` is NULL or a C string.
unsafe fn options(schema: *const c_char, of: &str) -> Result<Vec<crate::OptionSpec>, LoadError> {
    if schema.is_null() {
        return Ok(vec![]);
    }
    // SAFETY: as the caller promises.
    let schema = unsafe { text(schema, "schema of the options", of) }?;
    schema::read_options(&schema).map_err(|e| LoadError::Info(format!("`{of}`: {e}")))
}
