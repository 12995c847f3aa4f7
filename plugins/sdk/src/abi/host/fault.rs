//! Why a call failed, as the plugin told it or as the host saw it.
#![allow(unsafe_code)]

use crate::abi::table::look;
use crate::abi::{
    PLANFORM_BYTE, PLANFORM_LINE, PLANFORM_OK, PlanformProblem, PlanformStatus, kind_of, status_of,
};
use crate::{ErrorKind, Place, PluginError};

/// The first thing that went wrong in a call.
#[derive(Default)]
pub struct Fault {
    error: Option<PluginError>,
    /// What the plugin was refused and may get over: told only when it then fails without a word of its own.
    refusal: Option<PluginError>,
    /// How often the plugin called back after it was told that something went wrong.
    late_calls: usize,
}

impl Fault {
    /// Whether something went wrong before this call.
    pub fn precedes_call(&mut self) -> bool {
        self.late_calls += usize::from(self.error.is_some());
        self.error.is_some()
    }

    /// How often the plugin called back after it was told that something went wrong.
    pub fn late_calls(&self) -> usize {
        self.late_calls
    }

    /// Notes what went wrong, if nothing did before; the status to tell the plugin.
    pub fn note(&mut self, error: PluginError) -> PlanformStatus {
        let status = status_of(&error);
        self.error.get_or_insert(error);
        status
    }

    /// Remembers what the plugin was refused without failing for it; the status to tell the plugin.
    pub fn refuse(&mut self, error: PluginError) -> PlanformStatus {
        let status = status_of(&error);
        self.refusal = Some(error);
        status
    }

    /// Notes what the plugin says went wrong; its status.
    ///
    /// # Safety
    ///
    /// `problem` is NULL or a problem of a plugin that keeps to the ABI, whose texts live during this call.
    pub unsafe fn note_problem(&mut self, problem: *const PlanformProblem) -> PlanformStatus {
        // SAFETY: as the caller promises.
        self.note(unsafe { error_of(problem) }.unwrap_or_else(|e| of_plugin(&e.to_string())))
    }

    /// How the call ended, by what was noted and the status that the plugin returned.
    pub fn end(self, status: PlanformStatus) -> Result<(), PluginError> {
        match (self.error, status) {
            (Some(error), _) => Err(error),
            (None, PLANFORM_OK) => Ok(()),
            (None, status) => Err(self.refusal.unwrap_or_else(|| silent(status))),
        }
    }
}

fn silent(status: PlanformStatus) -> PluginError {
    of_plugin(&format!("it gave up with status {status} and did not say why (by `fail`)"))
}

/// How a plugin takes it that something goes wrong.
pub struct Trial<T> {
    /// How the call ended.
    pub result: Result<T, PluginError>,
    /// The status that the plugin returned.
    pub status: PlanformStatus,
    /// How often it called back after it was told that something went wrong.
    pub late_calls: usize,
}

/// A fault of the plugin's own.
pub fn of_plugin(what: &str) -> PluginError {
    PluginError::new(ErrorKind::Plugin, what).advise("tell its maker")
}

/// # Safety
///
/// As for [`Fault::note_problem`].
unsafe fn error_of(problem: *const PlanformProblem) -> Result<PluginError, crate::abi::TableError> {
    // SAFETY: as the caller promises.
    let problem = unsafe { look(problem) }?;
    // SAFETY: as the caller promises.
    let (message, advice) = unsafe { (problem.message.to_text(), problem.advice.to_text()) };
    let place = match problem.place {
        PLANFORM_LINE => Some(Place::Line(usize::try_from(problem.position).unwrap_or(usize::MAX))),
        PLANFORM_BYTE => Some(Place::Byte(problem.position)),
        _ => None,
    };
    if message.trim().is_empty() {
        return Ok(silent(problem.status));
    }
    let advice = Some(advice).filter(|a| !a.is_empty());
    Ok(PluginError { kind: kind_of(problem.status), message, place, advice })
}
