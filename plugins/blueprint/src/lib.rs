//! Input adapter for drawings of buildings: blueprints and evacuation plans, as pictures, PDF, SVG and DXF.
//!
//! A document becomes a [`Page`](page::Page) (`inputs`), the page a [`Sheet`](sheet::Sheet) of paper and ink
//! (`prepare`), of which words (`words`) and symbols (`symbols`) are read and taken off; what stays is searched for
//! walls (`walls`), and with the scale (`scale`) becomes the scene.

mod adapter;
mod claim;
mod doorways;
pub mod found;
pub mod inputs;
pub mod mask;
pub mod options;
mod overlay;
pub mod page;
mod paint;
pub mod pipeline;
pub mod prepare;
pub mod recognise;
mod rows;
pub mod scale;
pub mod scene;
pub mod sheet;
pub mod stages;
pub mod symbols;
pub mod walls;
pub mod words;

pub use adapter::adapter;

#[cfg(feature = "plugin")]
planform_sdk::export_plugin!(adapters: [adapter()], exporters: []);
