//! A plugin that panics, for tests alone: at reading and at writing, and at reading a document of the word `stack` it
//! calls itself without end.

use planform_sdk::{
    Confidence, Document, InputAdapter, Options, PluginError, PluginInfo, Probe, Scene, Source,
};
use std::io::Write;

planform_sdk::export_plugin!(
    adapters: [Box::new(Panics(info()))],
    exporters: [planform_sdk::exporter(info(), write)],
);

fn info() -> PluginInfo {
    PluginInfo {
        name: "panics".into(),
        description: "Panics, for tests".into(),
        version: "1.0.0".into(),
        licence: "MIT".into(),
        extensions: vec!["panics".into()],
        media_types: vec![],
        options: vec![],
    }
}

struct Panics(PluginInfo);

impl InputAdapter for Panics {
    fn info(&self) -> &PluginInfo {
        &self.0
    }

    fn probe(&self, probe: &Probe<'_>) -> Confidence {
        Confidence::because(if probe.extension() == "panics" { 90 } else { 0 }, "its name")
    }

    fn read(&self, source: &Source, _: &Options) -> Result<Scene, PluginError> {
        if source.bytes.starts_with(b"stack") {
            deeper(source.bytes.len() as u64);
        }
        panic!("no plan has {} bytes", source.bytes.len())
    }
}

/// Goes on until the stack is used up; the sum keeps compilers from making a loop of it.
#[allow(unconditional_recursion)]
fn deeper(depth: u64) -> u64 {
    std::hint::black_box([depth; 64])[3] + deeper(depth + 1)
}

fn write(document: &Document<'_>, _: &Options, _: &mut dyn Write) -> Result<(), PluginError> {
    let beyond = document.layout.rooms.len();
    panic!("room {} is not there", document.layout.rooms[beyond].id)
}
