//! Looks on while a layout is reconstructed: tells the steps, and paints what they found into `--debug-dir`.

use super::Failure;
use super::output::{check_file, write_file};
use super::picture::Painter;
use super::progress::Progress;
use crate::reconstruct::{Drawing, Observer, Step};
use planform_sdk::Grid;
use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the steps' pictures.
pub struct DebugFolder {
    path: PathBuf,
    steps: &'static [Step],
    force: bool,
}

impl DebugFolder {
    /// Makes the folder if it is not there. Fails when a picture would overwrite a file and must not.
    pub fn prepare(path: &Path, steps: &'static [Step], force: bool) -> Result<Self, Failure> {
        fs::create_dir_all(path).map_err(|e| Failure::of_io(path, e))?;
        let folder = Self { path: path.into(), steps, force };
        steps.iter().try_for_each(|step| check_file(&folder.file(*step), force))?;
        Ok(folder)
    }

    /// `01-clutter.png` for the first step.
    fn file(&self, step: Step) -> PathBuf {
        let number = self.steps.iter().position(|s| *s == step).unwrap_or(0) + 1;
        self.path.join(format!("{number:02}-{}.png", step.name()))
    }
}

/// The observer of one reconstruction.
pub struct Watch<'a> {
    progress: &'a mut Progress,
    pictures: Option<(&'a DebugFolder, Painter)>,
    failure: Option<Failure>,
}

impl<'a> Watch<'a> {
    /// Tells `progress` of the steps, and paints them over the grid if there is a folder to do it in.
    pub fn new(progress: &'a mut Progress, folder: Option<&'a DebugFolder>, grid: &Grid) -> Self {
        Self { progress, pictures: folder.and_then(|f| Some((f, Painter::new(grid)?))), failure: None }
    }

    /// The first picture's failure, if any failed.
    pub fn finish(self) -> Result<(), Failure> {
        self.failure.map_or(Ok(()), Err)
    }
}

impl Observer for Watch<'_> {
    fn step(&mut self, step: Step) {
        self.progress.step(step.name());
    }

    fn wants_drawings(&self) -> bool {
        self.pictures.is_some() && self.failure.is_none()
    }

    fn drawing(&mut self, step: Step, drawing: Drawing) {
        let Some((folder, painter)) = &self.pictures else { return };
        let path = folder.file(step);
        let written = painter
            .png(&drawing)
            .map_err(|e| Failure::over(&path, e))
            .and_then(|png| write_file(&path, &png, folder.force));
        self.failure = self.failure.take().or(written.err());
    }
}
