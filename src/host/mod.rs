//! The plugins of the program: which there are, which one a document or a file name belongs to, and the options of
//! one run.

mod claims;
mod registry;
mod settings;

pub use claims::Claim;
pub use registry::Registry;
pub use settings::{Setting, run_options};
