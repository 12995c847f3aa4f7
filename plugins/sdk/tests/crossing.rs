//! What crosses the C ABI comes out as it went in, both ways, and what breaks its rules is refused with a sentence.
//!
//! Both sides are in this program, so that Miri can watch them.
#![allow(unsafe_code)]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod misbehaved;
mod models;

use models::{annotations, grid, layout};
use planform_sdk::abi::host::Plugin;
use planform_sdk::abi::plugin::Tables;
use planform_sdk::{
    Boundary, Cell, Confidence, Document, ErrorKind, Exporter, Grid, InputAdapter, Layout, OptionSpec,
    Options, Output, Picture, Place, PluginError, PluginInfo, Pose, Probe, Provenance, ReadWatcher, Scene,
    Segment, Source, Wall,
};
use proptest::prelude::*;
use std::io::Write;
use std::path::Path;
use std::sync::{Arc, Mutex};

fn info(name: &str) -> PluginInfo {
    PluginInfo {
        name: name.into(),
        description: "Ein Prüfling".into(),
        version: "1.2.3".into(),
        licence: "MIT".into(),
        extensions: vec!["abc".into(), "d".into()],
        media_types: vec!["text/x-abc".into()],
        options: vec![Boundary::option(), OptionSpec::flag("frame", "Whether there is one", true)],
    }
}

type ReadScene = dyn Fn(&Source) -> Result<Scene, PluginError> + Send + Sync;

/// An adapter that reads a scene which it has already, or fails.
struct Reader {
    info: PluginInfo,
    scene: Box<ReadScene>,
}

impl InputAdapter for Reader {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn probe(&self, probe: &Probe<'_>) -> Confidence {
        assert!(!probe.head.starts_with(b"panic"), "told to");
        Confidence::because(probe.head.len().min(100) as u8, format!("by {}", probe.path.display()))
    }

    fn read(&self, source: &Source, _: &Options) -> Result<Scene, PluginError> {
        (self.scene)(source)
    }

    fn read_watched(
        &self,
        source: &Source,
        options: &Options,
        watcher: &mut dyn ReadWatcher,
    ) -> Result<Scene, PluginError> {
        let rgb = [1, 2, 3, 4, 5, 6];
        for (number, byte) in source.bytes.iter().enumerate() {
            let wanted = watcher.wants_pictures() && byte.is_ascii_uppercase();
            let picture = wanted.then(|| Picture::new(1, 2, &rgb).unwrap());
            watcher.stage(&format!("stage-{number}"), picture);
        }
        self.read(source, options)
    }
}

/// The name of a stage, and the sides and bytes of its picture.
type Seen = (String, Option<(u32, u32, Vec<u8>)>);

/// Keeps what it is told.
#[derive(Default)]
struct Witness {
    wants_pictures: bool,
    seen: Vec<Seen>,
}

impl ReadWatcher for Witness {
    fn wants_pictures(&self) -> bool {
        self.wants_pictures
    }

    fn stage(&mut self, name: &str, picture: Option<Picture<'_>>) {
        let picture = picture.map(|p| (p.width(), p.height(), p.rgb().to_vec()));
        self.seen.push((name.into(), picture));
    }
}

type Handed = (Layout, Option<Scene>, Options);

/// An exporter that keeps what it is handed.
struct Keeper {
    info: PluginInfo,
    kept: Arc<Mutex<Option<Handed>>>,
}

impl Exporter for Keeper {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn write(
        &self,
        document: &Document<'_>,
        options: &Options,
        out: &mut dyn Write,
    ) -> Result<(), PluginError> {
        let (layout, scene) = (document.layout.clone(), document.scene.cloned());
        *self.kept.lock().unwrap() = Some((layout, scene, options.clone()));
        (0..300).try_for_each(|i| writeln!(out, "line {i}"))?;
        Ok(())
    }
}

/// These plugins, once across the ABI.
fn crossed(adapters: Vec<Box<dyn InputAdapter>>, exporters: Vec<Box<dyn Exporter>>) -> Plugin {
    let tables = Box::leak(Box::new(Tables::new(adapters, exporters)));
    // SAFETY: the tables keep to the ABI and are never freed.
    unsafe { Plugin::of_tables(tables.as_ptr()) }.unwrap()
}

fn reader(scene: impl Fn(&Source) -> Result<Scene, PluginError> + Send + Sync + 'static) -> Plugin {
    crossed(vec![Box::new(Reader { info: info("reader"), scene: Box::new(scene) })], vec![])
}

fn document(bytes: &[u8]) -> Source {
    Source { path: "folder/plan.abc".into(), bytes: bytes.to_vec(), byte_limit: 1000 }
}

fn options(given: &[(&str, &str)]) -> Options {
    Options::parse(&info("").options, given.iter().copied()).unwrap()
}

fn read(plugin: &Plugin, bytes: &[u8]) -> Result<Scene, PluginError> {
    plugin.adapters[0].read(&document(bytes), &options(&[]))
}

/// Miri is a thousand times slower.
fn config() -> ProptestConfig {
    let cases = if cfg!(miri) { 2 } else { 256 };
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_scene_keeps_every_field_on_its_way_from_a_plugin(grid in grid(), annotations in annotations()) {
        let scene = Scene::new(grid, annotations);
        let plugin = reader({ let scene = scene.clone(); move |_| Ok(scene.clone()) });
        prop_assert_eq!(read(&plugin, b"x").unwrap(), scene);
    }

    #[test]
    fn a_layout_and_a_scene_keep_every_field_on_their_way_to_a_plugin(
        layout in layout(), grid in grid(), annotations in annotations(), with_scene: bool, frame: bool,
    ) {
        let kept = Arc::default();
        let keeper = Keeper { info: info("keeper"), kept: Arc::clone(&kept) };
        let plugin = crossed(vec![], vec![Box::new(keeper)]);
        let scene = with_scene.then(|| Scene::new(grid, annotations));
        let options = options(&[("boundary", "centre"), ("frame", &frame.to_string())]);
        let mut out = vec![];
        let document = Document { layout: &layout, scene: scene.as_ref() };
        plugin.exporters[0].write(&document, &options, &mut out).unwrap();
        prop_assert_eq!(kept.lock().unwrap().take().unwrap(), (layout, scene, options));
        prop_assert_eq!(out, (0..300).map(|i| format!("line {i}\n")).collect::<String>().into_bytes());
    }
}

#[test]
fn a_plugin_says_of_itself_what_it_did_before() {
    let plugin = reader(|_| unreachable!());
    assert_eq!(plugin.adapters[0].info(), &info("reader"));
    assert!(plugin.adapters[0].is_thread_safe());
}

#[test]
fn stages_cross_with_their_pictures_if_these_are_wanted() {
    let grid = || Grid::new(1, 1, 0.1, Pose::default(), vec![Cell::FREE]).unwrap();
    let plugin = reader(move |_| Ok(Scene::of_grid(grid(), Provenance::default())));
    let watched = |wants_pictures, bytes: &[u8]| {
        let mut witness = Witness { wants_pictures, seen: vec![] };
        let scene = plugin.adapters[0].read_watched(&document(bytes), &options(&[]), &mut witness);
        (scene, witness.seen)
    };
    let picture = Some((1, 2, vec![1, 2, 3, 4, 5, 6]));
    let (scene, seen) = watched(true, b"Ab");
    assert_eq!(seen, [("stage-0".to_owned(), picture), ("stage-1".into(), None)]);
    assert_eq!(scene.unwrap(), read(&plugin, b"Ab").unwrap());
    let bare = |seen: Vec<Seen>| seen.into_iter().map(|(_, p)| p.is_none()).collect::<Vec<_>>();
    assert_eq!(bare(watched(false, b"Ab").1), [true, true]);
    let (scene, seen) = watched(true, &[b'x'; 101]);
    assert_eq!(seen.len(), 100);
    assert!(scene.unwrap_err().message.contains("more than 100 stages"));
}

#[test]
fn a_document_arrives_whole() {
    let plugin = reader(|source| {
        assert_eq!((source.path.as_path(), source.byte_limit), (Path::new("folder/plan.abc"), 1000));
        Err(PluginError::new(ErrorKind::BadInput, String::from_utf8_lossy(&source.bytes)))
    });
    assert_eq!(read(&plugin, "Grüße\0 und mehr".as_bytes()).unwrap_err().message, "Grüße\0 und mehr");
}

#[test]
fn probes_cross() {
    let plugin = reader(|_| unreachable!());
    let probe = |head: &[u8]| plugin.adapters[0].probe(&Probe { path: Path::new("a b.abc"), head });
    assert_eq!(probe(b"1234567"), Confidence::because(7, "by a b.abc"));
    assert_eq!(probe(b"").percent, 0);
    assert_eq!(probe(b"panic now"), Confidence::no());
    let probe = Probe { path: Path::new("a b.abc"), head: b"panic" };
    let e = plugin.adapters[0].confidence(&probe).unwrap_err();
    assert!(e.message.starts_with("it has a bug at ") && e.message.ends_with(": told to"), "{e}");
}

#[test]
fn errors_keep_kind_place_and_advice() {
    let error = |kind, place: Option<Place>| PluginError {
        kind,
        message: "no „Höhe“".into(),
        place,
        advice: Some("add it".into()),
    };
    for kind in [
        ErrorKind::BadInput,
        ErrorKind::Unsupported,
        ErrorKind::Limit,
        ErrorKind::BadOption,
        ErrorKind::Io,
        ErrorKind::Plugin,
    ] {
        for place in [None, Some(Place::Line(3)), Some(Place::Byte(0))] {
            let e = read(&reader(move |_| Err(error(kind, place))), b"").unwrap_err();
            assert_eq!((e.kind, e.to_string()), (kind, error(kind, place).to_string()));
        }
    }
    let e = read(&reader(|_| Err(PluginError::new(ErrorKind::Io, "gone"))), b"").unwrap_err();
    assert_eq!((e.place, e.advice), (None, None));
}

#[test]
fn a_panic_is_an_error_that_says_where() {
    let e = read(&reader(|_| panic!("no wall is as thick as {}", 7)), b"").unwrap_err();
    assert_eq!(e.kind, ErrorKind::Plugin);
    assert!(e.message.contains("no wall is as thick as 7"), "{e}");
}

/// An exporter whose documents have two companions.
struct Pair {
    info: PluginInfo,
    companions: [String; 2],
}

impl Exporter for Pair {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn write(&self, _: &Document<'_>, _: &Options, _: &mut dyn Write) -> Result<(), PluginError> {
        Err(PluginError::new(ErrorKind::Unsupported, "it needs a name"))
    }

    fn companions(&self) -> &[String] {
        &self.companions
    }

    fn write_files(&self, _: &Document<'_>, _: &Options, output: Output<'_>) -> Result<(), PluginError> {
        write!(output.file, "{} {}", output.stem, output.extension)?;
        output.companions[1].extend(b"\0second");
        Ok(())
    }
}

#[test]
fn companions_cross_with_the_name_of_their_document() {
    let companions = ["pgm", "tar.gz"].map(String::from);
    let plugin = crossed(vec![], vec![Box::new(Pair { info: info("pair"), companions: companions.clone() })]);
    assert_eq!(plugin.exporters[0].companions(), companions);
    let (layout, mut file, mut beside) = (Layout::default(), vec![], vec![vec![]; 2]);
    let document = Document { layout: &layout, scene: None };
    let output = Output { stem: "Straße 1", extension: "Yaml", file: &mut file, companions: &mut beside };
    plugin.exporters[0].write_files(&document, &options(&[]), output).unwrap();
    assert_eq!((file.as_slice(), beside), ("Straße 1 Yaml".as_bytes(), vec![vec![], b"\0second".to_vec()]));
}

#[test]
fn a_layout_that_json_cannot_hold_is_not_the_plugins_fault() {
    let plugin = crossed(vec![], vec![Box::new(Keeper { info: info("keeper"), kept: Arc::default() })]);
    let wall = Wall { line: Segment::default(), thickness: f64::NAN, weight: 1.0, rooms: [None; 2] };
    let layout = Layout { walls: vec![wall], ..Layout::default() };
    let document = Document { layout: &layout, scene: None };
    let e = plugin.exporters[0].write(&document, &options(&[]), &mut vec![]).unwrap_err();
    assert_eq!(
        (e.kind, e.message.as_str()),
        (ErrorKind::BadInput, "the layout has a number that is not finite")
    );
}

#[test]
fn a_full_disk_ends_the_writing() {
    struct Full(usize);
    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            self.0 += 1;
            Err(std::io::ErrorKind::StorageFull.into())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let plugin = crossed(vec![], vec![Box::new(Keeper { info: info("keeper"), kept: Arc::default() })]);
    let (layout, mut full) = (Layout::default(), Full(0));
    let document = Document { layout: &layout, scene: None };
    let e = plugin.exporters[0].write(&document, &options(&[]), &mut full).unwrap_err();
    assert_eq!((e.kind, e.to_string()), (ErrorKind::Io, "the disk is full".into()));
    assert_eq!(full.0, 1);
}
