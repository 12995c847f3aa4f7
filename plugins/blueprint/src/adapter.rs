//! The adapter as the host sees it.

use crate::options::{self, Request};
use crate::stages::{Stages, Unwatched};
use crate::{claim, inputs, pipeline, scene};
use image::RgbImage;
use planform_sdk::{
    Confidence, InputAdapter, Kept, Options, Picture, PluginError, PluginInfo, Probe, ReadWatcher, Scene,
    Source,
};

/// The adapter `blueprint`.
///
/// ```
/// let adapter = planform_blueprint::adapter();
/// assert_eq!(adapter.info().name, "blueprint");
/// ```
pub fn adapter() -> Box<dyn InputAdapter> {
    Box::new(Blueprint { info: options::info() })
}

struct Blueprint {
    info: PluginInfo,
}

impl InputAdapter for Blueprint {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn probe(&self, probe: &Probe<'_>) -> Confidence {
        claim::probe(probe)
    }

    fn look(&self, source: &Source, kept: &mut Kept) -> Option<Confidence> {
        claim::look(source, kept)
    }

    fn read(&self, source: &Source, options: &Options) -> Result<Scene, PluginError> {
        read(source, options, &mut Unwatched)
    }

    fn read_watched(
        &self,
        source: &Source,
        options: &Options,
        watcher: &mut dyn ReadWatcher,
    ) -> Result<Scene, PluginError> {
        read(source, options, &mut Watched(watcher))
    }
}

fn read(source: &Source, options: &Options, stages: &mut dyn Stages) -> Result<Scene, PluginError> {
    let request = Request::of(options)?;
    let page = inputs::page(source, &request.page_request())?;
    let frame = scene::PageFrame { height: f64::from(page.picture.height()), origin: page.origin };
    let reading = pipeline::read(&page, &request, stages)?;
    scene::scene(&reading, frame, source.name())
}

/// Hands the steps' pictures to the host.
struct Watched<'a>(&'a mut dyn ReadWatcher);

impl Stages for Watched<'_> {
    fn stage(&mut self, name: &str, picture: &mut dyn FnMut() -> RgbImage) {
        let painted = self.0.wants_pictures().then(picture);
        let shown = painted.as_ref().and_then(|p| Picture::new(p.width(), p.height(), p.as_raw()));
        self.0.stage(name, shown);
    }
}
