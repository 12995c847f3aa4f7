//! Writes layouts as maps for robots: a YAML file and a PGM picture, as the map savers of ROS write them and its map
//! servers read them.
//!
//! The map shows what stays where it is: walls at their thickness are occupied, rooms and open doors are free, and all
//! else is unknown. So a robot that localises on it is not misled by the furniture of the day when a map was made.
//!
//! # Frame
//!
//! The cells are those of the grid that the layout was found in: the same origin and yaw, and unless the option
//! `resolution` says otherwise the same cells, so that the two maps overlay each other. A layout without its grid is
//! drawn with a margin around it, unturned, in cells of 5 cm.
//!
//! # Files
//!
//! `map.yaml` has the picture `map.pgm` beside it, top row first, in greys of `map_saver`: 254 free, 0 occupied, 205
//! unknown. The keys are those of `nav2_map_server`, and one more, `planform`, which map servers pass over: it states all
//! openings between rooms, so that who reads the map again need not guess where one room ends. `free_thresh` is 0.196 as in ROS 1: with the 0.25 that `map_saver`
//! of nav2 writes by default, map servers take the grey 205, whose occupancy is 0.19608, for free.

mod canvas;
mod drawing;
mod files;
mod frame;
mod openings;

use planform_sdk::{
    Bounds, Document, Exporter, OptionKind, OptionSpec, Options, Output, PluginError, PluginInfo,
};
use std::io::Write;

/// The extension of the picture.
const PICTURE: &str = "pgm";

/// The exporter `ros-map`.
pub fn exporter() -> Box<dyn Exporter> {
    Box::new(RosMap { info: info(), companions: [PICTURE.into()] })
}

#[cfg(feature = "plugin")]
planform_sdk::export_plugin!(adapters: [], exporters: [exporter()]);

struct RosMap {
    info: PluginInfo,
    companions: [String; 1],
}

fn info() -> PluginInfo {
    PluginInfo {
        name: "ros-map".into(),
        description: "ROS map: walls and free rooms for robots, a YAML file with its PGM picture".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: vec!["yaml".into(), "yml".into()],
        media_types: vec!["application/yaml".into()],
        options: vec![OptionSpec::new(
            "resolution",
            "metres per cell; by default that of the grid that the layout was found in, or 0.05 without one",
            OptionKind::Number(Bounds::above(0.0)),
            None,
        )],
    }
}

impl Exporter for RosMap {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn write(
        &self,
        document: &Document<'_>,
        options: &Options,
        out: &mut dyn Write,
    ) -> Result<(), PluginError> {
        self.write_files(
            document,
            options,
            Output { stem: "map", extension: "yaml", file: out, companions: &mut [] },
        )
    }

    fn companions(&self) -> &[String] {
        &self.companions
    }

    fn write_files(
        &self,
        document: &Document<'_>,
        options: &Options,
        output: Output<'_>,
    ) -> Result<(), PluginError> {
        let frame = frame::Frame::of(document, options.number("resolution"))?;
        let picture = format!("{}.{PICTURE}", output.stem);
        let drawing = drawing::draw(document.layout, &frame)?;
        files::write_yaml(&frame, &picture, &openings::stated(&drawing), output.file)?;
        if let Some(picture) = output.companions.first_mut() {
            files::write_pgm(&drawing.canvas, picture)?;
        }
        Ok(())
    }
}
