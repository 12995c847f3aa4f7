//! Pictures of the steps, for whoever wants to see them.

use image::RgbImage;

/// Is told of every step's result. Pictures are made only when they are wanted.
pub trait Stages {
    /// A step, named in lower case with dashes, has this result.
    fn stage(&mut self, name: &str, picture: &mut dyn FnMut() -> RgbImage);
}

/// Nobody looks on.
pub struct Unwatched;

impl Stages for Unwatched {
    fn stage(&mut self, _: &str, _: &mut dyn FnMut() -> RgbImage) {}
}
