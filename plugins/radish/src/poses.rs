//! Chooses the poses that scans are drawn from.

use crate::log::{Log, Pose, PoseKind};
use crate::matching::{MatchingParams, corrected};
use crate::options::Poses;
use planform_sdk::{ErrorKind, PluginError};

/// One pose for each scan, and where they come from.
pub struct Chosen {
    /// In the order of the scans.
    pub poses: Vec<Pose>,
    /// A sentence for the user's eyes, unless they are those of a corrected log, as anybody would expect.
    pub note: Option<String>,
}

/// The poses that are asked for.
///
/// # Errors
/// When the log does not have what they are made of.
pub fn choose(log: &Log, asked: Poses) -> Result<Chosen, PluginError> {
    Ok(match (asked, log.poses) {
        (Poses::Auto | Poses::Log, PoseKind::Corrected) => Chosen { poses: stated(log), note: None },
        (Poses::Log, PoseKind::Odometry) | (Poses::Odometry, _) => {
            let note = "the poses are odometry alone, and walls may be bent or double";
            Chosen { poses: odometry(log)?, note: Some(note.into()) }
        }
        (Poses::Auto | Poses::Matched, _) => matched(log),
    })
}

fn stated(log: &Log) -> Vec<Pose> {
    log.scans.iter().map(|s| s.pose).collect()
}

/// The poses by odometry: those that the log states if it has no others.
fn odometry(log: &Log) -> Result<Vec<Pose>, PluginError> {
    match log.poses {
        PoseKind::Odometry => Ok(stated(log)),
        PoseKind::Corrected => log.scans.iter().map(|s| s.odometry).collect::<Option<_>>().ok_or_else(|| {
            PluginError::new(ErrorKind::BadOption, "the log has corrected poses only, and no odometry")
                .advise("leave out the option `poses`, or give `log`")
        }),
    }
}

/// The poses by matching scans, beginning with odometry where the log has it.
fn matched(log: &Log) -> Chosen {
    let found = corrected(&log.scans, &MatchingParams::default(), &mut |_| {});
    let begun = match log.poses {
        PoseKind::Corrected if log.scans.iter().any(|s| s.odometry.is_none()) => "the log's own",
        _ if found.odometry => "odometry",
        _ => "nothing, as the log has no odometry, so that long corridors may be too long or too short",
    };
    let note = format!(
        "the poses were found by matching {} of {} scans and closing {} loops, beginning with {begun}",
        found.matched,
        log.scans.len(),
        found.loops
    );
    Chosen { poses: found.poses, note: Some(note) }
}
