//! Every built-in plugin does the same when it comes from outside: compiled as a library of its own and loaded through
//! the C ABI, into this process and into one of its own.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod choices;
mod documents;
mod drawings;
mod library;

use choices::{Choice, choices};
use library::Ways;
use planform_sdk::{Document, Exporter, InputAdapter, OptionSpec, Output, PluginInfo, Probe, Source};

/// What a plugin says of itself. The order of the options does not cross.
fn said(info: &PluginInfo) -> PluginInfo {
    let mut options: Vec<OptionSpec> = info.options.clone();
    options.sort_by(|a, b| a.name.cmp(&b.name));
    PluginInfo { options, ..info.clone() }
}

/// What an adapter answers, to the last digit: how sure it is, and the scene or the error.
fn answer(adapter: &dyn InputAdapter, source: &Source, choice: &Choice) -> String {
    let head = &source.bytes[..source.bytes.len().min(4096)];
    let confidence = adapter.probe(&Probe { path: &source.path, head });
    format!("{confidence:?} {:?}", adapter.read(source, &choice.of(adapter.info())))
}

#[test]
fn slam_grid() {
    let built_in = planform_slam_grid::adapter();
    let ways = Ways::of("planform-slam-grid");
    let folder = documents::folder();
    let documents = documents::all(&folder);
    let (mut read, mut refused) = (0, 0);
    for (way, (adapters, exporters)) in ways.all() {
        assert_eq!((adapters.len(), exporters.len()), (1, 0), "{way}");
        assert_eq!(said(adapters[0].info()), said(built_in.info()), "{way}");
        for source in &documents {
            for choice in choices(built_in.info(), &["0.02"], &["none", "205", "128", "grey"]) {
                let expected = answer(built_in.as_ref(), source, &choice);
                let found = answer(adapters[0].as_ref(), source, &choice);
                assert!(found == expected, "{way}, {:?}, {choice:?}\n{found}\n{expected}", source.path);
                let count = if found.contains(" Ok(") { &mut read } else { &mut refused };
                *count += 1;
            }
        }
    }
    // Else they might agree in that nothing can be read, or that everything can.
    assert!(read > 100 && refused > 100, "{read} read, {refused} refused");
}

#[test]
fn radish() {
    let built_in = planform_radish::adapter();
    let ways = Ways::of("planform-radish");
    let poses = built_in.info().options.iter().filter(|o| o.name == "poses").cloned().collect();
    let chosen = choices(&PluginInfo { options: poses, ..built_in.info().clone() }, &[], &[]);
    for (way, (adapters, exporters)) in ways.all() {
        assert_eq!((adapters.len(), exporters.len()), (1, 0), "{way}");
        assert_eq!(said(adapters[0].info()), said(built_in.info()), "{way}");
        let mut read = 0;
        for source in &documents::logs() {
            for choice in &chosen {
                let expected = answer(built_in.as_ref(), source, choice);
                assert!(answer(adapters[0].as_ref(), source, choice) == expected, "{way}, {choice:?}");
                read += usize::from(expected.contains(" Ok("));
            }
        }
        assert!(read > 20, "{read} read");
    }
}

/// Writes every drawing with every choice of options, and compares.
fn exporter(package: &str, built_in: &dyn Exporter, numbers: &[&str], texts: &[&str]) {
    let ways = Ways::of(package);
    let written = |exporter: &dyn Exporter, document: &Document<'_>, choice: &Choice| {
        let (mut bytes, mut companions) = (vec![], vec![vec![]; exporter.companions().len()]);
        let output =
            Output { stem: "plan \"1\"", extension: "dot", file: &mut bytes, companions: &mut companions };
        let result = exporter.write_files(document, &choice.of(exporter.info()), output);
        result.map(|()| (bytes, companions)).map_err(|e| format!("{e:?}"))
    };
    let (drawings, mut successes) = (drawings::all(), 0);
    for (way, (adapters, exporters)) in ways.all() {
        assert_eq!((adapters.len(), exporters.len()), (0, 1), "{way}");
        assert_eq!(said(exporters[0].info()), said(built_in.info()), "{way}");
        for drawing in &drawings {
            for choice in choices(built_in.info(), numbers, texts) {
                let expected = written(built_in, &drawing.document(), &choice);
                let found = written(exporters[0].as_ref(), &drawing.document(), &choice);
                assert!(found == expected, "{way}, {}, {choice:?}", drawing.name);
                successes += usize::from(found.is_ok());
            }
        }
    }
    assert!(successes >= 2 * (drawings.len() - 1), "{successes} written");
}

#[test]
fn svg() {
    exporter("planform-svg", planform_svg::exporter().as_ref(), &["1", "33.3", "1000000", "1e-300"], &[]);
}

#[test]
fn dxf() {
    exporter("planform-dxf", planform_dxf::exporter().as_ref(), &[], &[]);
}

#[test]
fn geojson() {
    let anchors = ["47.3769,8.5417,12.5", "-17,180,300", "91,0,0", "north"];
    exporter("planform-geojson", planform_geojson::exporter().as_ref(), &[], &anchors);
}

#[test]
fn ros_map() {
    exporter("planform-ros-map", planform_ros_map::exporter().as_ref(), &["0.1", "1e-300"], &[]);
}

#[test]
fn graph() {
    exporter("planform-graph", planform_graph::exporter().as_ref(), &[], &[]);
}

#[test]
fn json() {
    exporter("planform-json", planform_json::exporter().as_ref(), &[], &[]);
}
