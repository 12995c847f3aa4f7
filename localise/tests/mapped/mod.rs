//! The map of a layout as a map server reads it, for the tests and examples that need one.

use planform_sdk::{Document, Grid, Layout, Options, Output, Scene, Source};
use std::fs;

/// What the exporter `ros-map` writes with these options, read by the adapter `slam-grid`.
pub fn mapped(layout: &Layout, scene: &Scene, options: &[(&str, &str)]) -> Grid {
    let exporter = planform_ros_map::exporter();
    let options = Options::parse(&exporter.info().options, options.iter().copied()).unwrap();
    let (mut yaml, mut pictures) = (vec![], [vec![]]);
    let output = Output { stem: "map", extension: "yaml", file: &mut yaml, companions: &mut pictures };
    exporter.write_files(&Document { layout, scene: Some(scene) }, &options, output).unwrap();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("map.yaml"), yaml).unwrap();
    fs::write(folder.path().join("map.pgm"), &pictures[0]).unwrap();
    let source = Source::open(folder.path().join("map.yaml"), Source::BYTE_LIMIT).unwrap();
    let adapter = planform_slam_grid::adapter();
    adapter.read(&source, &Options::parse(&adapter.info().options, []).unwrap()).unwrap().grid
}
