//! The adapter as the host sees it.

use crate::options::{self, NAME, Request};
use crate::picture::{self, PictureParams};
use crate::{log, mapping, paint, poses, probe, unpack};
use planform_sdk::{
    Confidence, ErrorKind, InputAdapter, Kept, Options, PluginError, PluginInfo, Probe, Provenance,
    ReadWatcher, Scene, Source,
};

/// The adapter `radish`.
///
/// ```
/// let adapter = planform_radish::adapter();
/// assert_eq!(adapter.info().name, "radish");
/// ```
pub fn adapter() -> Box<dyn InputAdapter> {
    Box::new(Radish { info: options::info() })
}

struct Radish {
    info: PluginInfo,
}

impl InputAdapter for Radish {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn probe(&self, probe: &Probe<'_>) -> Confidence {
        probe::probe(probe)
    }

    fn look(&self, source: &Source, kept: &mut Kept) -> Option<Confidence> {
        picture::look(source, kept)
    }

    fn read(&self, source: &Source, options: &Options) -> Result<Scene, PluginError> {
        self.read_watched(source, options, &mut ())
    }

    fn read_watched(
        &self,
        source: &Source,
        options: &Options,
        watcher: &mut dyn ReadWatcher,
    ) -> Result<Scene, PluginError> {
        if picture::is_picture(&source.bytes) {
            return self.read_picture(source, options);
        }
        let request = Request::of(options);
        if source.bytes.is_empty() {
            return Err(
                PluginError::new(ErrorKind::BadInput, "the file is empty").advise("give a CARMEN log")
            );
        }
        let log = log::read(unpack::text(&source.bytes), request.laser)?;
        watcher.stage("log", None);
        let chosen = poses::choose(&log, request.poses)?;
        let grid = mapping::map(&log.scans, &chosen.poses, &request.mapping)?;
        paint::scans(&log.scans, &chosen.poses, request.mapping.reach, &grid, watcher);
        paint::grid(&grid, watcher);
        let mut scene = Scene::of_grid(grid, Provenance { source: source.name(), adapter: NAME.into() });
        scene.warnings = log.warnings;
        scene.warnings.extend(chosen.note);
        Ok(scene)
    }
}

impl Radish {
    fn read_picture(&self, source: &Source, options: &Options) -> Result<Scene, PluginError> {
        let (grid, note) = picture::read(&source.bytes, &PictureParams::of(options))?;
        let mut scene = Scene::of_grid(grid, Provenance { source: source.name(), adapter: NAME.into() });
        scene.warnings.push(note);
        Ok(scene)
    }
}
