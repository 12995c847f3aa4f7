//! Looks on while a document is read and a layout is reconstructed: tells stages and steps, and paints what they found
//! into `--debug-dir`.

use super::Failure;
use super::output::{check_file, write_file};
use super::picture::{Painter, stage_png};
use super::progress::Progress;
use crate::reconstruct::{Drawing, Observer, Step};
use planform_sdk::{Grid, Picture, ReadWatcher};
use std::fs;
use std::path::{Path, PathBuf};

/// The longest name of a stage that is used, characters.
const LONGEST_NAME: usize = 40;

/// The folder of the pictures: first those of the adapter's stages, then those of the reconstruction's steps, numbered
/// from 1.
pub struct DebugFolder {
    path: PathBuf,
    force: bool,
    /// How many stages have a picture.
    stages: usize,
}

impl DebugFolder {
    /// Makes the folder if it is not there.
    pub fn prepare(path: &Path, force: bool) -> Result<Self, Failure> {
        fs::create_dir_all(path).map_err(|e| Failure::of_io(path, e))?;
        Ok(Self { path: path.into(), force, stages: 0 })
    }

    /// Fails when the picture of one of these steps would overwrite a file and must not.
    pub fn check(&self, steps: &[Step]) -> Result<(), Failure> {
        let mut files = (0..).zip(steps).map(|(i, step)| self.step_file(i, *step));
        files.try_for_each(|file| check_file(&file, self.force))
    }

    /// `01-clutter.png` for the first step of the reconstruction, if the adapter left no pictures.
    fn step_file(&self, index: usize, step: Step) -> PathBuf {
        self.file(self.stages + index + 1, step.name())
    }

    fn file(&self, number: usize, name: &str) -> PathBuf {
        self.path.join(format!("{number:02}-{name}.png"))
    }

    fn write_stage(&mut self, name: &str, picture: Picture<'_>) -> Result<(), Failure> {
        self.stages += 1;
        let path = self.file(self.stages, name);
        check_file(&path, self.force)?;
        let png = stage_png(picture).map_err(|e| Failure::over(&path, e))?;
        write_file(&path, &png, self.force)
    }
}

/// The watcher of one reading.
pub struct ReadWatch<'a> {
    progress: &'a mut Progress,
    folder: Option<&'a mut DebugFolder>,
    failure: Option<Failure>,
}

impl<'a> ReadWatch<'a> {
    /// Tells `progress` of the stages, and writes their pictures if there is a folder to do it in.
    pub fn new(progress: &'a mut Progress, folder: Option<&'a mut DebugFolder>) -> Self {
        Self { progress, folder, failure: None }
    }

    /// The first picture's failure, if any failed.
    pub fn finish(self) -> Result<(), Failure> {
        self.failure.map_or(Ok(()), Err)
    }
}

impl ReadWatcher for ReadWatch<'_> {
    fn wants_pictures(&self) -> bool {
        self.folder.is_some() && self.failure.is_none()
    }

    fn stage(&mut self, name: &str, picture: Option<Picture<'_>>) {
        let name = tidy(name);
        self.progress.stage(&name);
        if let (Some(folder), Some(picture), None) = (&mut self.folder, picture, &self.failure) {
            self.failure = folder.write_stage(&name, picture).err();
        }
    }
}

/// The name of a stage as it may stand in a file's name and on a terminal, whatever a plugin says.
fn tidy(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    let name: String = name.chars().take(LONGEST_NAME).map(plain).collect();
    let name = name.trim_matches('-');
    if name.is_empty() { "stage".into() } else { name.into() }
}

/// The observer of one reconstruction.
pub struct Watch<'a> {
    progress: &'a mut Progress,
    pictures: Option<(&'a DebugFolder, Painter)>,
    steps: &'static [Step],
    failure: Option<Failure>,
}

impl<'a> Watch<'a> {
    /// Tells `progress` of the steps, and paints them over the grid if there is a folder to do it in.
    pub fn new(
        progress: &'a mut Progress,
        folder: Option<&'a DebugFolder>,
        grid: &Grid,
        steps: &'static [Step],
    ) -> Self {
        let pictures = folder.and_then(|f| Some((f, Painter::new(grid)?)));
        Self { progress, pictures, steps, failure: None }
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
        let index = self.steps.iter().position(|s| *s == step).unwrap_or(0);
        let path = folder.step_file(index, step);
        let written = painter
            .png(&drawing)
            .map_err(|e| Failure::over(&path, e))
            .and_then(|png| write_file(&path, &png, folder.force));
        self.failure = self.failure.take().or(written.err());
    }
}

#[cfg(test)]
mod tests {
    use super::super::progress::Voice;
    use super::*;

    #[test]
    fn names_of_stages_are_made_fit_for_files() {
        for (name, expected) in [
            ("deskew", "deskew"),
            ("Two Words", "two-words"),
            ("../../etc/passwd", "etc-passwd"),
            ("a\u{1b}[31m\0\n", "a--31m"),
            ("äöü", "stage"),
            ("", "stage"),
        ] {
            assert_eq!(tidy(name), expected);
        }
        assert_eq!(tidy(&"x".repeat(1000)).len(), LONGEST_NAME);
    }

    /// What happens to a folder in which `names` are stages with a picture of one pixel.
    fn watched(path: &Path, names: &[&str], force: bool) -> Result<DebugFolder, Failure> {
        let mut folder = DebugFolder::prepare(path, force).unwrap();
        let mut progress = Progress::new(Voice::Quiet);
        let mut watch = ReadWatch::new(&mut progress, Some(&mut folder));
        assert!(watch.wants_pictures());
        names.iter().for_each(|name| watch.stage(name, Picture::new(1, 1, &[255, 0, 0])));
        watch.finish()?;
        Ok(folder)
    }

    #[test]
    fn stages_come_before_the_steps() {
        let folder = tempfile::tempdir().unwrap();
        let watched = watched(folder.path(), &["light", "deskew"], false).unwrap();
        let steps = crate::reconstruct::Params::default().method.steps();
        let name = |path: PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
        assert!(name(watched.step_file(0, steps[0])).starts_with("03-"));
        let mut files: Vec<_> =
            fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
        files.sort();
        assert_eq!(files, ["01-light.png", "02-deskew.png"]);
        let picture = image::open(folder.path().join("01-light.png")).unwrap().to_rgb8();
        assert_eq!(picture.get_pixel(0, 0).0, [255, 0, 0]);
    }

    #[test]
    fn nothing_is_overwritten_unasked() {
        let folder = tempfile::tempdir().unwrap();
        let kept = folder.path().join("02-deskew.png");
        fs::write(&kept, "mine").unwrap();
        assert!(watched(folder.path(), &["light", "deskew", "walls"], false).is_err());
        assert_eq!(fs::read(&kept).unwrap(), b"mine");
        assert!(!folder.path().join("03-walls.png").exists(), "no more after the first failure");
        watched(folder.path(), &["light", "deskew"], true).unwrap();
        assert!(fs::read(&kept).unwrap().starts_with(b"\x89PNG"));
    }
}
