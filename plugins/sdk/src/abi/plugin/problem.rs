//! Errors on their way to the host.
#![allow(unsafe_code)]

use crate::abi::{
    PLANFORM_BYTE, PLANFORM_LINE, PLANFORM_NOWHERE, PlanformProblem, PlanformStatus, PlanformString,
    status_of,
};
use crate::{ErrorKind, Place, PluginError};
use std::ffi::c_void;

/// The host's callback that takes what went wrong.
pub type Fail = unsafe extern "C" fn(context: *mut c_void, problem: *const PlanformProblem) -> PlanformStatus;

/// Hands the error to the host; the status to return.
///
/// # Safety
///
/// `fail` and `context` are of one sink of the host's whose call has not ended.
pub unsafe fn report(fail: Fail, context: *mut c_void, error: &PluginError) -> PlanformStatus {
    let (place, position) = match error.place {
        None => (PLANFORM_NOWHERE, 0),
        Some(Place::Line(line)) => (PLANFORM_LINE, line as u64),
        Some(Place::Byte(byte)) => (PLANFORM_BYTE, byte),
    };
    let text = |text: &str| PlanformString::of(text.as_bytes());
    let problem = PlanformProblem {
        size: size_of::<PlanformProblem>(),
        status: status_of(error),
        place,
        position,
        message: text(&error.message),
        advice: error.advice.as_deref().map_or(PlanformString::NULL, text),
    };
    // SAFETY: as the caller promises; the problem lives until the call returns.
    unsafe { fail(context, &problem) };
    problem.status
}

/// The error of a panic, by its sentence.
pub fn of_panic(sentence: String) -> PluginError {
    PluginError::new(ErrorKind::Plugin, sentence).advise("tell its maker")
}

/// The error of a host that does not keep to the ABI.
pub fn of_host(error: impl std::fmt::Display) -> PluginError {
    PluginError::new(ErrorKind::Plugin, format!("planform handed over something unusable: {error}"))
}
