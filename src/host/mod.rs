//! The plugins of the program: which there are, which one a document or a file name belongs to, and the options of
//! one run. Those from outside are found, checked and loaded here, in a process of their own unless told otherwise.

mod claims;
pub mod conformance;
pub mod isolated;
mod library;
mod outside;
mod registry;
mod search;
mod settings;
mod trust;

pub use claims::{Choice, Claim};
pub use outside::{Contents, Loaded, Message, OutsideSettings, Outsider, Refusal, load, messages};
pub use registry::{Origin, Registry};
pub use search::PATH_VARIABLE;
pub use settings::{Setting, run_options};
