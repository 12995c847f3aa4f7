//! Tables and calls that break the rules, each by one thing.

use planform_sdk::abi::host::{LoadError, Plugin};
use planform_sdk::abi::*;
use planform_sdk::{
    Document, ErrorKind, Exporter, InputAdapter, Layout, Options, PluginError, Scene, Source,
};
use std::ffi::{CStr, c_char, c_void};
use std::ptr;

fn info(name: &'static CStr) -> PlanformInfo {
    PlanformInfo {
        size: size_of::<PlanformInfo>(),
        name: name.as_ptr(),
        description: c"A test".as_ptr(),
        version: c"1".as_ptr(),
        licence: c"MIT".as_ptr(),
        extensions: ptr::null(),
        media_types: ptr::null(),
        options: ptr::null(),
        flags: 0,
    }
}

fn leak<T>(value: T) -> *const T {
    Box::leak(Box::new(value))
}

fn list<T>(entries: Vec<*const T>) -> *const *const T {
    entries.leak().as_ptr()
}

type Read = unsafe extern "C" fn(
    *const PlanformAdapter,
    *const PlanformSource,
    *const PlanformJson,
    *const PlanformSceneSink,
) -> PlanformStatus;

type WriteOut = unsafe extern "C" fn(
    *const PlanformExporter,
    *const PlanformDocument,
    *const PlanformJson,
    *const PlanformOutput,
) -> PlanformStatus;

unsafe extern "C" fn probe(_: *const PlanformAdapter, _: *const PlanformProbe) -> i32 {
    300
}

fn adapter(info: PlanformInfo, read: Read) -> PlanformAdapter {
    PlanformAdapter {
        size: size_of::<PlanformAdapter>(),
        info: leak(info),
        data: ptr::null_mut(),
        probe: Some(probe),
        read: Some(read),
    }
}

fn ended<T>(mut entries: Vec<*const T>) -> *const *const T {
    entries.push(ptr::null());
    list(entries)
}

fn plugin(adapters: Vec<*const PlanformAdapter>, exporters: Vec<*const PlanformExporter>) -> PlanformPlugin {
    PlanformPlugin {
        size: size_of::<PlanformPlugin>(),
        abi_major: PLANFORM_ABI_MAJOR,
        abi_minor: PLANFORM_ABI_MINOR,
        adapters: ended(adapters),
        exporters: ended(exporters),
    }
}

fn load(plugin: PlanformPlugin) -> Result<Plugin, LoadError> {
    // SAFETY: the tables are never freed; what they get wrong is what the host has to see.
    unsafe { Plugin::of_tables(leak(plugin)) }
}

fn refusal(plugin: PlanformPlugin) -> String {
    load(plugin).err().unwrap().to_string()
}

unsafe extern "C" fn read_nothing(
    _: *const PlanformAdapter,
    _: *const PlanformSource,
    _: *const PlanformJson,
    _: *const PlanformSceneSink,
) -> PlanformStatus {
    PLANFORM_OK
}

fn good() -> PlanformPlugin {
    plugin(vec![leak(adapter(info(c"good"), read_nothing))], vec![])
}

fn with_info(change: impl FnOnce(&mut PlanformInfo)) -> PlanformPlugin {
    let mut changed = info(c"good");
    change(&mut changed);
    plugin(vec![leak(adapter(changed, read_nothing))], vec![])
}

#[test]
fn tables_that_do_not_fit_are_refused() {
    assert!(load(good()).is_ok());
    let newer = PlanformPlugin { abi_minor: 99, size: 4096, ..good() };
    // SAFETY: of the bytes that it claims, only those of this version are looked at.
    assert!(unsafe { Plugin::of_tables(leak(newer)) }.is_ok());
    // SAFETY: NULL is what a plugin returns that refuses the host.
    let null = unsafe { Plugin::of_tables(ptr::null()) }.err().unwrap();
    assert_eq!(null.to_string(), "it refuses to work with this planform");
    for (plugin, words) in [
        (PlanformPlugin { abi_major: 2, ..good() }, "version 2 of the plugin interface"),
        (PlanformPlugin { abi_major: 0, ..good() }, "version 0 of the plugin interface"),
        (
            PlanformPlugin { size: 16, ..good() },
            "cut short: it says that it has 16 bytes where 32 are needed",
        ),
        (PlanformPlugin { size: 0, ..good() }, "cut short"),
        (
            PlanformPlugin { adapters: ptr::null(), exporters: ptr::null(), ..good() },
            "no input adapter and no",
        ),
        (PlanformPlugin { adapters: list(vec![ptr::dangling(); 300]), ..good() }, "no end within 256"),
        (with_info(|i| i.size = 8), "the information of an adapter or exporter is cut short"),
        (with_info(|i| i.name = ptr::null()), "the name of an adapter or exporter is missing"),
        (with_info(|i| i.licence = ptr::null()), "the licence of good is missing"),
        (with_info(|i| i.name = c"Not A Name".as_ptr()), "`Not A Name` is no name"),
        (with_info(|i| i.name = c"".as_ptr()), "`` is no name"),
        (with_info(|i| i.description = c"\xff\xfe".as_ptr()), "the description of good is not UTF-8"),
        (with_info(|i| i.extensions = ended(vec![c".Map".as_ptr()])), "without the dot"),
        (with_info(|i| i.extensions = list(vec![c"a".as_ptr(); 300])), "no end within 256"),
        (with_info(|i| i.options = c"{".as_ptr()), "`good`: the schema of its options cannot be read"),
    ] {
        let sentence = refusal(plugin);
        assert!(sentence.contains(words), "{words}: {sentence}");
    }
    let without = PlanformAdapter { read: None, ..adapter(info(c"good"), read_nothing) };
    assert_eq!(refusal(plugin(vec![leak(without)], vec![])), "`good` has no function `read`");
    let short = PlanformAdapter { size: 24, ..adapter(info(c"good"), read_nothing) };
    assert!(refusal(plugin(vec![leak(short)], vec![])).contains("an input adapter is cut short"));
}

fn grid(cells: &[i8], width: u32, height: u32) -> PlanformGrid {
    PlanformGrid {
        size: size_of::<PlanformGrid>(),
        width,
        height,
        resolution: 0.1,
        origin_x: 0.0,
        origin_y: 0.0,
        origin_yaw: 0.0,
        cells: cells.as_ptr(),
        cell_count: cells.len(),
    }
}

fn run(read: Read) -> Result<Scene, PluginError> {
    let plugin = load(plugin(vec![leak(adapter(info(c"good"), read))], vec![])).unwrap();
    let source = Source { path: "a".into(), bytes: vec![1], byte_limit: 10 };
    plugin.adapters[0].read(&source, &Options::default())
}

/// Hands a grid of these cells to the sink.
///
/// # Safety
///
/// `sink` is the host's.
unsafe fn hand_over(sink: *const PlanformSceneSink, grid: &PlanformGrid) -> PlanformStatus {
    // SAFETY: as the caller promises.
    unsafe { ((*sink).grid)((*sink).context, grid) }
}

const LEAF: PlanformDoorLeaf =
    PlanformDoorLeaf { hinge_x: 0.0, hinge_y: 0.0, closed_x: 1.0, closed_y: 0.0, open_x: 0.0, open_y: 1.0 };

/// A door that says that it has these leaves.
fn door(leaves: *const PlanformDoorLeaf, leaf_count: usize) -> PlanformSymbol {
    PlanformSymbol {
        size: size_of::<PlanformSymbol>(),
        kind: PlanformString { data: c"door".as_ptr(), length: 4 },
        x: 0.0,
        y: 0.0,
        yaw: 0.0,
        width: 1.0,
        height: 1.0,
        score: 1.0,
        leaves,
        leaf_count,
    }
}

static PIXELS: [u8; 6] = [0; 6];

/// A stage with a picture of two pixels that says that it has so many bytes.
fn stage(rgb_length: usize) -> PlanformStage {
    PlanformStage {
        size: size_of::<PlanformStage>(),
        name: PlanformString { data: c"a".as_ptr(), length: 1 },
        width: 2,
        height: 1,
        rgb: PIXELS.as_ptr(),
        rgb_length,
    }
}

macro_rules! reads {
    ($($name:ident |$source:ident, $sink:ident| $body:block)*) => {
        $(#[allow(unused_unsafe)]
        unsafe extern "C" fn $name(
            _: *const PlanformAdapter,
            $source: *const PlanformSource,
            _: *const PlanformJson,
            $sink: *const PlanformSceneSink,
        ) -> PlanformStatus {
            // SAFETY: the host's source and sink, during their call.
            unsafe { $body }
        })*
    };
}

unsafe extern "C" fn keep(receiver: *mut c_void, bytes: *const u8, length: usize) {
    // SAFETY: the receiver is a length, and the bytes are the host's.
    unsafe { *receiver.cast::<usize>() = std::slice::from_raw_parts(bytes, length).len() };
}

reads! {
    two_grids |_source, sink| {
        hand_over(sink, &grid(&[0, 1], 2, 1));
        hand_over(sink, &grid(&[0, 1], 2, 1))
    }
    absurd_grid |_source, sink| {
        assert_eq!(hand_over(sink, &grid(&[0], 60_000, 60_000)), PLANFORM_LIMIT);
        // A plugin that calls on after it was refused, and says that all is well.
        assert_eq!(hand_over(sink, &grid(&[0], 1, 1)), PLANFORM_PLUGIN_FAULT);
        PLANFORM_OK
    }
    few_cells |_source, sink| { hand_over(sink, &grid(&[0, 1], 3, 1)) }
    odd_cell |_source, sink| { hand_over(sink, &grid(&[0, 101], 2, 1)) }
    no_cells |_source, sink| {
        hand_over(sink, &PlanformGrid { cells: ptr::null(), ..grid(&[0], 1, 1) })
    }
    null_grid |_source, sink| { ((*sink).grid)((*sink).context, ptr::null()) }
    short_grid |_source, sink| { hand_over(sink, &PlanformGrid { size: 8, ..grid(&[0], 1, 1) }) }
    no_resolution |_source, sink| {
        hand_over(sink, &PlanformGrid { resolution: f64::NAN, ..grid(&[0], 1, 1) })
    }
    silent |_source, _sink| { PLANFORM_UNSUPPORTED }
    unknown_status |_source, _sink| { 4711 }
    null_problem |_source, sink| { ((*sink).fail)((*sink).context, ptr::null()) }
    not_utf8 |_source, sink| {
        ((*sink).warning)((*sink).context, PlanformString { data: c"\xff".as_ptr(), length: 1 })
    }
    not_finite |_source, sink| {
        let anchor = PlanformAnchor {
            size: size_of::<PlanformAnchor>(), latitude: f64::NAN, longitude: 0.0, bearing: 0.0, x: 0.0, y: 0.0,
        };
        ((*sink).anchor)((*sink).context, &anchor)
    }
    no_leaves |_source, sink| { ((*sink).symbol)((*sink).context, &door(ptr::null(), 1)) }
    many_leaves |_source, sink| { ((*sink).symbol)((*sink).context, &door(&LEAF, usize::MAX)) }
    endless_leaf |_source, sink| {
        let leaf = PlanformDoorLeaf { open_y: f64::INFINITY, ..LEAF };
        ((*sink).symbol)((*sink).context, &door(&leaf, 1))
    }
    absurd_openings |_source, sink| {
        let opening = PlanformOpening { from_x: 0.0, from_y: 0.0, to_x: 1.0, to_y: 1.0, depth: 0.1, kind: 7 };
        ((*sink).openings.unwrap())((*sink).context, &opening, 1)
    }
    missing_openings |_source, sink| {
        ((*sink).openings.unwrap())((*sink).context, ptr::null(), 1)
    }
    openings_twice |_source, sink| {
        let status = ((*sink).openings.unwrap())((*sink).context, ptr::null(), 0);
        assert_eq!(status, PLANFORM_OK);
        ((*sink).openings.unwrap())((*sink).context, ptr::null(), 0)
    }
    absurd_scale |_source, sink| {
        let (source, size) = (PlanformString::NULL, size_of::<PlanformScale>());
        let scale = PlanformScale { size, metres_per_pixel: f64::NAN, source, confidence: 1.0 };
        ((*sink).scale.unwrap())((*sink).context, &scale)
    }
    short_picture |_source, sink| { ((*sink).stage.unwrap())((*sink).context, &stage(5)) }
    shows_a_stage |_source, sink| {
        assert_eq!((*sink).flags, 0);
        assert_eq!(((*sink).stage.unwrap())((*sink).context, &stage(6)), PLANFORM_OK);
        // A symbol as version 1.0 had it: what lies behind it is not looked at.
        let old = PlanformSymbol { size: std::mem::offset_of!(PlanformSymbol, leaves), ..door(ptr::null(), 7) };
        assert_eq!(((*sink).symbol)((*sink).context, &old), PLANFORM_OK);
        hand_over(sink, &grid(&[0], 1, 1))
    }
    sibling_gone |source, _sink| {
        let name = PlanformString { data: c"no-such-file".as_ptr(), length: 12 };
        let mut length = 0usize;
        ((*source).sibling)((*source).context, name, keep, ptr::from_mut(&mut length).cast())
    }
    gets_over_it |source, sink| {
        let name = PlanformString { data: c"no-such-file".as_ptr(), length: 12 };
        let mut length = 0usize;
        let status = ((*source).sibling)((*source).context, name, keep, ptr::from_mut(&mut length).cast());
        assert_eq!(status, PLANFORM_IO);
        hand_over(sink, &grid(&[0], 1, 1))
    }
}

#[test]
fn calls_that_break_the_rules_are_refused() {
    for (read, kind, words) in [
        (read_nothing as Read, ErrorKind::Plugin, "without handing over a grid"),
        (two_grids, ErrorKind::Plugin, "a second grid"),
        (absurd_grid, ErrorKind::Limit, "60000 x 60000"),
        (few_cells, ErrorKind::Plugin, "2 cells where width times height is 3"),
        (odd_cell, ErrorKind::Plugin, "neither -1 nor within 0 to 100"),
        (no_cells, ErrorKind::Plugin, "no cells (a null pointer)"),
        (null_grid, ErrorKind::Plugin, "the grid is missing (a null pointer)"),
        (short_grid, ErrorKind::Plugin, "the grid is cut short"),
        (no_resolution, ErrorKind::Limit, "resolution"),
        (silent, ErrorKind::Plugin, "status 2 and did not say why"),
        (unknown_status, ErrorKind::Plugin, "status 4711"),
        (null_problem, ErrorKind::Plugin, "the problem is missing"),
        (not_utf8, ErrorKind::Plugin, "a warning is not UTF-8"),
        (not_finite, ErrorKind::Plugin, "not finite"),
        (no_leaves, ErrorKind::Plugin, "the leaves of a symbol are missing"),
        (many_leaves, ErrorKind::Plugin, "more than 100 leaves"),
        (endless_leaf, ErrorKind::Plugin, "a leaf of a symbol has a number that is not finite"),
        (absurd_openings, ErrorKind::Plugin, "an opening is of the kind 7, which there is not"),
        (missing_openings, ErrorKind::Plugin, "its openings are missing (a null pointer)"),
        (openings_twice, ErrorKind::Plugin, "it hands over its openings a second time"),
        (absurd_scale, ErrorKind::Plugin, "the scale has a number that is not finite"),
        (short_picture, ErrorKind::Plugin, "2 x 1 pixels has 5 bytes"),
        (sibling_gone, ErrorKind::Io, "no-such-file"),
    ] {
        let e = run(read).unwrap_err();
        assert_eq!(e.kind, kind, "{e}");
        assert!(e.message.contains(words), "{words}: {e}");
    }
    assert_eq!(run(gets_over_it).unwrap().grid.cells().len(), 1);
    assert!(run(shows_a_stage).unwrap().symbols[0].leaves.is_empty());
}

#[test]
fn a_probe_without_sense_is_no_claim() {
    let plugin = load(good()).unwrap();
    let probe = planform_sdk::Probe { path: std::path::Path::new("x"), head: b"x" };
    assert_eq!(plugin.adapters[0].probe(&probe).percent, 0);
    assert!(plugin.adapters[0].confidence(&probe).unwrap_err().message.contains("300"));
    assert!(!plugin.adapters[0].is_thread_safe());
}

macro_rules! writes {
    ($($name:ident |$document:ident, $out:ident| $body:block)*) => {
        $(unsafe extern "C" fn $name(
            _: *const PlanformExporter,
            $document: *const PlanformDocument,
            _: *const PlanformJson,
            $out: *const PlanformOutput,
        ) -> PlanformStatus {
            // SAFETY: the host's document and output, during their call.
            unsafe { $body }
        })*
    };
}

writes! {
    writes_null |_document, out| { ((*out).write)((*out).context, ptr::null(), 5) }
    writes_nothing |_document, out| { ((*out).write)((*out).context, ptr::null(), 0) }
    fails |_document, out| {
        let text = |text: &'static [u8]| PlanformString { data: text.as_ptr().cast::<c_char>(), length: text.len() };
        let problem = PlanformProblem {
            size: size_of::<PlanformProblem>(), status: PLANFORM_LIMIT, place: PLANFORM_NOWHERE, position: 0,
            message: text(b"too many rooms"), advice: PlanformString::NULL,
        };
        ((*out).fail)((*out).context, &problem);
        // It says that it failed, and then that it did not: the first word counts.
        PLANFORM_OK
    }
    has_no_scene |document, out| {
        if (*document).grid.is_null() && (*document).scene.is_null() { PLANFORM_OK } else { ((*out).fail)((*out).context, ptr::null()) }
    }
}

#[test]
fn exporters_that_break_the_rules_are_refused() {
    let write = |write: WriteOut| {
        let exporter = PlanformExporter {
            size: size_of::<PlanformExporter>(),
            info: leak(info(c"bad")),
            data: ptr::null_mut(),
            write: Some(write),
            companions: std::ptr::null(),
        };
        let plugin = load(plugin(vec![], vec![leak(exporter)])).unwrap();
        let layout = Layout::default();
        plugin.exporters[0].write(
            &Document { layout: &layout, scene: None },
            &Options::default(),
            &mut vec![],
        )
    };
    assert!(write(writes_null).unwrap_err().message.contains("from a null pointer"));
    assert_eq!(write(fails).unwrap_err().to_string(), "too many rooms");
    write(writes_nothing).unwrap();
    write(has_no_scene).unwrap();
}
