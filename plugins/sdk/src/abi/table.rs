//! Structs of the other side, looked at only when they are as long as they must be.
#![allow(unsafe_code)]

use std::mem::{align_of, size_of};
use thiserror::Error;

/// Why a struct of the other side cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum TableError {
    /// It is not there.
    #[error("{0} is missing (a null pointer)")]
    Missing(&'static str),
    /// It lies where no such struct can lie.
    #[error("{0} is not aligned in memory")]
    Misaligned(&'static str),
    /// It ends before the fields of this version do.
    #[error("{what} is cut short: it says that it has {found} bytes where {needed} are needed")]
    Short {
        /// Which one.
        what: &'static str,
        /// Its size as it says.
        found: usize,
        /// The least size.
        needed: usize,
    },
}

/// A struct whose first field is its size, a `usize`.
///
/// # Safety
///
/// Implemented for `repr(C)` structs that begin with that field.
pub unsafe trait Table {
    /// What it is called in messages.
    const WHAT: &'static str;
}

/// A struct of the other side, if it is as long as it must be.
///
/// # Safety
///
/// `table` is NULL, or points to a `usize`; if that says at least `size_of::<T>()`, then it points to a `T`. Both live
/// and stay as they are for `'a`.
pub unsafe fn look<'a, T: Table>(table: *const T) -> Result<&'a T, TableError> {
    if table.is_null() {
        return Err(TableError::Missing(T::WHAT));
    }
    if !table.addr().is_multiple_of(align_of::<T>()) {
        return Err(TableError::Misaligned(T::WHAT));
    }
    // SAFETY: not NULL and aligned; the caller promises a usize.
    let found = unsafe { table.cast::<usize>().read() };
    let needed = size_of::<T>();
    if found < needed {
        return Err(TableError::Short { what: T::WHAT, found, needed });
    }
    // SAFETY: it is long enough, and so a T, as the caller promises.
    Ok(unsafe { &*table })
}

macro_rules! tables {
    ($($table:ident $what:literal),* $(,)?) => {
        // SAFETY: each is repr(C) and begins with `size: usize`.
        $(unsafe impl Table for super::$table { const WHAT: &'static str = $what; })*
    };
}

tables! {
    PlanformHost "the host's table",
    PlanformPlugin "the plugin's table",
    PlanformInfo "the information of an adapter or exporter",
    PlanformAdapter "the table of an input adapter",
    PlanformExporter "the table of an exporter",
    PlanformJson "a JSON document",
    PlanformProblem "the problem",
    PlanformProbe "the probe",
    PlanformSource "the source",
    PlanformGrid "the grid",
    PlanformText "the text",
    PlanformSymbol "the symbol",
    PlanformAnchor "the anchor",
    PlanformSceneSink "the scene's sink",
    PlanformDocument "the document",
    PlanformOutput "the output",
}
