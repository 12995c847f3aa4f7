//! Structs of the other side, looked at only as far as they go.
#![allow(unsafe_code)]

use std::mem::{MaybeUninit, offset_of};
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
    /// It ends before the fields of version 1.0 do.
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

/// A struct that crosses, and that a minor version can make longer.
///
/// # Safety
///
/// Implemented for `repr(C)` structs whose first field is their size, a `usize`, and which are valid when all their
/// bytes from `LEAST` on are zero: later fields are numbers, pointers and optional functions.
pub unsafe trait Table: Copy {
    /// What it is called in messages.
    const WHAT: &'static str;
    /// How many bytes it had in version 1.0. No padding is among the last of them: a field that is added there later
    /// would be read from where an older writer wrote nothing.
    const LEAST: usize;
}

/// A copy of a struct of the other side. Fields that the other side does not know yet are zero.
///
/// # Safety
///
/// `table` is NULL, or points to a `usize`; if that says at least `T::LEAST`, then so many bytes of a `T` are there, or
/// of a longer one. They stay as they are during this call.
pub unsafe fn look<T: Table>(table: *const T) -> Result<T, TableError> {
    if table.is_null() {
        return Err(TableError::Missing(T::WHAT));
    }
    if !table.addr().is_multiple_of(align_of::<T>()) {
        return Err(TableError::Misaligned(T::WHAT));
    }
    // SAFETY: not NULL and aligned; the caller promises a usize.
    let found = unsafe { table.cast::<usize>().read() };
    if found < T::LEAST {
        return Err(TableError::Short { what: T::WHAT, found, needed: T::LEAST });
    }
    let mut copy = MaybeUninit::<T>::zeroed();
    let length = found.min(size_of::<T>());
    // SAFETY: the caller promises as many bytes as the size says, and the copy has room for those of a `T`; it is valid
    // because fields from `LEAST` on may be zero.
    unsafe {
        table.cast::<u8>().copy_to_nonoverlapping(copy.as_mut_ptr().cast(), length);
        Ok(copy.assume_init())
    }
}

/// Where a field ends.
const fn end_of<T, F>(offset: usize, _: fn(&T) -> &F) -> usize {
    offset + size_of::<F>()
}

/// Structs with their last fields in version 1.0, which stay named here when fields are added behind them.
macro_rules! tables {
    ($($table:ident . $last:ident $what:literal),* $(,)?) => {$(
        // SAFETY: it is repr(C), begins with `size: usize`, and has no field behind that of version 1.0.
        unsafe impl Table for super::$table {
            const WHAT: &'static str = $what;
            const LEAST: usize = {
                let least = end_of(offset_of!(Self, $last), |table: &Self| &table.$last);
                assert!(least.is_multiple_of(align_of::<Self>()), "it ends with padding");
                least
            };
        }
    )*};
}

tables! {
    PlanformHost.text "the host's table",
    PlanformPlugin.exporters "the plugin's table",
    PlanformInfo.flags "the information of an adapter or exporter",
    PlanformAdapter.read "the table of an input adapter",
    PlanformExporter.write "the table of an exporter",
    PlanformJson.value "a JSON document",
    PlanformProblem.advice "the problem",
    PlanformProbe.reason "the probe",
    PlanformSource.sibling "the source",
    PlanformGrid.cell_count "the grid",
    PlanformText.confidence "the text",
    PlanformSymbol.score "the symbol",
    PlanformAnchor.y "the anchor",
    PlanformScale.confidence "the scale",
    PlanformStage.rgb_length "the stage",
    PlanformSceneSink.fail "the scene's sink",
    PlanformDocument.scene "the document",
    PlanformOutput.fail "the output",
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ptr;

    /// A struct as it was, and as it may become.
    #[repr(C)]
    #[derive(Clone, Copy)]
    struct Old {
        size: usize,
        width: u64,
    }

    #[repr(C)]
    #[derive(Clone, Copy)]
    struct New {
        size: usize,
        width: u64,
        height: u32,
        more: Option<extern "C" fn() -> u32>,
    }

    // SAFETY: repr(C), begins with its size, and has no later field.
    unsafe impl Table for Old {
        const WHAT: &'static str = "it";
        const LEAST: usize = end_of(offset_of!(Self, width), |old: &Self| &old.width);
    }

    // SAFETY: repr(C), begins with its size, and its later fields may be zero.
    unsafe impl Table for New {
        const WHAT: &'static str = "it";
        const LEAST: usize = Old::LEAST;
    }

    extern "C" fn seven() -> u32 {
        7
    }

    #[test]
    fn old_and_new_understand_each_other() {
        let old = Old { size: size_of::<Old>(), width: 3 };
        // SAFETY: an old struct has as many bytes as it says.
        let seen = unsafe { look(ptr::from_ref(&old).cast::<New>()) }.unwrap();
        assert_eq!((seen.width, seen.more.is_none()), (3, true));
        let new = New { size: size_of::<New>(), width: 4, height: 5, more: Some(seven) };
        // SAFETY: a new struct has as many bytes as it says.
        let (seen, same) = unsafe { (look(ptr::from_ref(&new).cast::<Old>()), look(&new)) };
        assert_eq!(seen.unwrap().width, 4);
        assert_eq!(same.unwrap().more.map(|f| f()), Some(7));
    }

    #[test]
    fn what_is_not_there_is_not_looked_at() {
        let short = Old { size: Old::LEAST - 1, width: 3 };
        // SAFETY: NULL, a place that is never read, and a struct that says how short it is.
        let seen = unsafe {
            [look::<Old>(ptr::null()), look(ptr::without_provenance::<Old>(3)), look(&short)].map(Result::err)
        };
        let needed = Old::LEAST;
        let expected = [
            TableError::Missing("it"),
            TableError::Misaligned("it"),
            TableError::Short { what: "it", found: needed - 1, needed },
        ];
        assert_eq!(seen, expected.map(Some));
    }
}
