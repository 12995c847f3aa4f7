//! Takes what an adapter finds in a document. What an adapter hands over is looked at before it is believed.
#![allow(unsafe_code)]

use super::fault::{Fault, Trial, of_plugin};
use crate::abi::guard::guard;
use crate::abi::table::{Table, look};
use crate::abi::{
    PLANFORM_DOOR, PLANFORM_OK, PLANFORM_PASSAGE, PLANFORM_PLUGIN_FAULT, PLANFORM_WANTS_PICTURES,
    PlanformAnchor, PlanformDoorLeaf, PlanformGrid, PlanformOpening, PlanformProblem, PlanformScale,
    PlanformSceneSink, PlanformStage, PlanformStatus, PlanformString, PlanformSymbol, PlanformText,
};
use crate::{
    Annotations, Cell, DoorLeaf, ErrorKind, GeoAnchor, Grid, OpeningKind, Picture, PluginError, Point, Pose,
    Provenance, ReadWatcher, Scale, Scene, Segment, StatedOpening, Symbol, Text,
};
use std::ffi::c_void;
use std::slice;
use std::sync::{Mutex, PoisonError};

/// The most texts, symbols and warnings, each, in one scene.
const MAX_ANNOTATIONS: usize = 1_000_000;

/// The most leaves of one door.
const MAX_LEAVES: usize = 100;

/// The most stages of one document: each may leave a file behind.
const MAX_STAGES: usize = 100;

/// What was taken so far.
pub struct Taken<'a> {
    grid: Option<Grid>,
    annotations: Annotations,
    fault: Fault,
    /// Whether every grid is refused, as an absurd one is.
    refuses: bool,
    /// Who looks on.
    watcher: &'a mut dyn ReadWatcher,
    /// How many stages there were.
    stages: usize,
}

/// What was taken, behind a lock: an adapter may call from several threads.
pub struct Receiver<'a> {
    taken: Mutex<Taken<'a>>,
    wants_pictures: bool,
}

impl<'a> Receiver<'a> {
    /// Nothing yet but where the document came from, and who looks on.
    pub fn new(provenance: Provenance, watcher: &'a mut dyn ReadWatcher) -> Self {
        let annotations = Annotations { provenance, ..Annotations::default() };
        let (grid, fault, refuses, stages) = (None, Fault::default(), false, 0);
        let wants_pictures = watcher.wants_pictures();
        let taken = Taken { grid, annotations, fault, refuses, watcher, stages };
        Self { taken: Mutex::new(taken), wants_pictures }
    }

    /// The same, refusing every grid as if it were absurdly large.
    pub fn refusing(self) -> Self {
        self.with(|taken| taken.refuses = true);
        self
    }

    /// The sink that puts everything here, to be used as long as this lives.
    pub fn sink(&self) -> PlanformSceneSink {
        PlanformSceneSink {
            size: size_of::<PlanformSceneSink>(),
            context: self.context(),
            grid,
            text,
            symbol,
            anchor,
            warning,
            provenance,
            fail,
            scale: Some(scale),
            flags: if self.wants_pictures { PLANFORM_WANTS_PICTURES } else { 0 },
            stage: Some(stage),
            openings: Some(openings),
        }
    }

    /// What the callbacks get this back from.
    pub fn context(&self) -> *mut c_void {
        std::ptr::from_ref(self).cast_mut().cast()
    }

    /// Does something with what was taken.
    pub fn with<T>(&self, work: impl FnOnce(&mut Taken<'a>) -> T) -> T {
        work(&mut self.taken.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// How the call ended: the scene, or what went wrong.
    pub fn end(self, status: PlanformStatus) -> Trial<Scene> {
        let taken = self.taken.into_inner().unwrap_or_else(PoisonError::into_inner);
        Trial { late_calls: taken.fault.late_calls(), status, result: taken.scene(status) }
    }
}

impl Taken<'_> {
    /// Remembers what the adapter was refused and may get over; the status to tell it.
    pub fn refuse(&mut self, error: PluginError) -> PlanformStatus {
        self.fault.refuse(error)
    }

    fn scene(self, status: PlanformStatus) -> Result<Scene, PluginError> {
        self.fault.end(status)?;
        let grid = self.grid.ok_or_else(|| of_plugin("it reads the document without handing over a grid"))?;
        Ok(Scene::new(grid, self.annotations))
    }

    fn take_stage(&mut self, name: &str, picture: Option<Picture<'_>>) -> Result<(), PluginError> {
        if self.stages == MAX_STAGES {
            return Err(of_plugin(&format!("its work has more than {MAX_STAGES} stages")));
        }
        self.stages += 1;
        self.watcher.stage(name, picture);
        Ok(())
    }

    fn take_grid(&mut self, grid: Grid) -> Result<(), PluginError> {
        if self.refuses {
            let error = crate::GridError::TooLarge { width: grid.width(), height: grid.height() };
            return Err(PluginError::new(ErrorKind::Limit, error.to_string()));
        }
        match self.grid.replace(grid) {
            None => Ok(()),
            Some(_) => Err(of_plugin("it hands over a second grid")),
        }
    }
}

/// # Safety
///
/// `context` is that of a [`Receiver`] that lives for `'a`.
unsafe fn receiver<'a>(context: *mut c_void) -> &'a Receiver<'a> {
    // SAFETY: as the caller promises.
    unsafe { &*context.cast::<Receiver<'_>>() }
}

/// Takes something into the scene, unless something went wrong before.
///
/// # Safety
///
/// `context` is that of a [`Receiver`] whose call has not ended.
unsafe fn take(
    context: *mut c_void,
    work: impl FnOnce(&mut Taken<'_>) -> Result<(), PluginError>,
) -> PlanformStatus {
    // SAFETY: as the caller promises.
    let receiver = unsafe { receiver(context) };
    let status = guard(|| {
        receiver.with(|taken| match taken.fault.precedes_call() {
            true => PLANFORM_PLUGIN_FAULT,
            false => work(taken).map_or_else(|e| taken.fault.note(e), |()| PLANFORM_OK),
        })
    });
    status.unwrap_or(PLANFORM_PLUGIN_FAULT)
}

/// A struct of the plugin's.
///
/// # Safety
///
/// As for [`look`].
unsafe fn looked<T: Table>(table: *const T) -> Result<T, PluginError> {
    // SAFETY: as the caller promises.
    unsafe { look(table) }.map_err(|e| of_plugin(&e.to_string()))
}

unsafe extern "C" fn grid(context: *mut c_void, grid: *const PlanformGrid) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and a grid of its own.
    unsafe { take(context, |taken| taken.take_grid(grid_of(&looked(grid)?)?)) }
}

/// # Safety
///
/// `cells` points to `cell_count` cells that stay as they are during this call.
unsafe fn grid_of(grid: &PlanformGrid) -> Result<Grid, PluginError> {
    let unusable = |e: &crate::GridError| PluginError::new(ErrorKind::Limit, e.to_string());
    let expected = Grid::check_size(grid.width, grid.height).map_err(|e| unusable(&e))?;
    if grid.cells.is_null() {
        return Err(of_plugin("its grid has no cells (a null pointer)"));
    }
    if grid.cell_count != expected {
        let found = grid.cell_count;
        return Err(of_plugin(&format!("its grid has {found} cells where width times height is {expected}")));
    }
    // SAFETY: not NULL, and as many as the caller promises.
    let values = unsafe { slice::from_raw_parts(grid.cells, grid.cell_count) };
    let cells: Option<Vec<Cell>> = values.iter().map(|v| Cell::of_ros(*v)).collect();
    let cells = cells.ok_or_else(|| of_plugin("a cell of its grid is neither -1 nor within 0 to 100"))?;
    let origin = Pose { x: grid.origin_x, y: grid.origin_y, yaw: grid.origin_yaw };
    Grid::new(grid.width, grid.height, grid.resolution, origin, cells).map_err(|e| unusable(&e))
}

/// The text, which has to be UTF-8.
///
/// # Safety
///
/// `text` is NULL or a text of the plugin's that stays as it is during this call.
unsafe fn text_of(text: PlanformString, what: &str) -> Result<String, PluginError> {
    // SAFETY: as the caller promises.
    let bytes = unsafe { text.bytes() };
    String::from_utf8(bytes.to_vec()).map_err(|_| of_plugin(&format!("{what} is not UTF-8")))
}

/// Numbers that have to be finite.
fn finite<const N: usize>(numbers: [f64; N], what: &str) -> Result<(), PluginError> {
    if numbers.iter().all(|n| n.is_finite()) {
        return Ok(());
    }
    Err(of_plugin(&format!("{what} has a number that is not finite")))
}

fn push<T>(list: &mut Vec<T>, item: T, what: &str) -> Result<(), PluginError> {
    if list.len() == MAX_ANNOTATIONS {
        let message = format!("has more than {MAX_ANNOTATIONS} {what}");
        return Err(PluginError::new(ErrorKind::Limit, message));
    }
    list.push(item);
    Ok(())
}

unsafe extern "C" fn text(context: *mut c_void, text: *const PlanformText) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and a text of its own.
    unsafe {
        take(context, |taken| {
            let PlanformText { size: _, content, x, y, yaw, width, height, confidence } = looked(text)?;
            finite([x, y, yaw, width, height, confidence], "a text")?;
            let content = text_of(content, "a text")?;
            let text = Text { content, pose: Pose { x, y, yaw }, width, height, confidence };
            push(&mut taken.annotations.texts, text, "texts")
        })
    }
}

unsafe extern "C" fn symbol(context: *mut c_void, symbol: *const PlanformSymbol) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and a symbol of its own.
    unsafe {
        take(context, |taken| {
            let symbol = looked(symbol)?;
            let PlanformSymbol { size: _, kind, x, y, yaw, width, height, score, .. } = symbol;
            finite([x, y, yaw, width, height, score], "a symbol")?;
            let kind = text_of(kind, "the kind of a symbol")?;
            let leaves = leaves_of(&symbol)?;
            let symbol = Symbol { kind, pose: Pose { x, y, yaw }, width, height, score, leaves };
            push(&mut taken.annotations.symbols, symbol, "symbols")
        })
    }
}

/// The leaves of a door's symbol.
///
/// # Safety
///
/// `leaves` is NULL or points to `leaf_count` leaves that stay as they are during this call.
unsafe fn leaves_of(symbol: &PlanformSymbol) -> Result<Vec<DoorLeaf>, PluginError> {
    if symbol.leaf_count > MAX_LEAVES {
        return Err(of_plugin(&format!("a symbol has more than {MAX_LEAVES} leaves")));
    }
    if symbol.leaf_count == 0 {
        return Ok(vec![]);
    }
    if symbol.leaves.is_null() {
        return Err(of_plugin("the leaves of a symbol are missing (a null pointer)"));
    }
    // SAFETY: not NULL, and as many as the caller promises.
    let leaves = unsafe { slice::from_raw_parts(symbol.leaves, symbol.leaf_count) };
    leaves.iter().map(leaf_of).collect()
}

fn leaf_of(leaf: &PlanformDoorLeaf) -> Result<DoorLeaf, PluginError> {
    let PlanformDoorLeaf { hinge_x, hinge_y, closed_x, closed_y, open_x, open_y } = *leaf;
    finite([hinge_x, hinge_y, closed_x, closed_y, open_x, open_y], "a leaf of a symbol")?;
    Ok(DoorLeaf {
        hinge: Point::new(hinge_x, hinge_y),
        closed: Point::new(closed_x, closed_y),
        open: Point::new(open_x, open_y),
    })
}

unsafe extern "C" fn scale(context: *mut c_void, scale: *const PlanformScale) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and a scale of its own.
    unsafe {
        take(context, |taken| {
            let PlanformScale { size: _, metres_per_pixel, source, confidence } = looked(scale)?;
            finite([metres_per_pixel, confidence], "the scale")?;
            let source = text_of(source, "the source of the scale")?;
            taken.annotations.scale = Some(Scale { metres_per_pixel, source, confidence });
            Ok(())
        })
    }
}

unsafe extern "C" fn openings(
    context: *mut c_void,
    openings: *const PlanformOpening,
    count: usize,
) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and openings of its own.
    unsafe {
        take(context, |taken| {
            if taken.annotations.openings.is_some() {
                return Err(of_plugin("it hands over its openings a second time"));
            }
            taken.annotations.openings = Some(openings_of(openings, count)?);
            Ok(())
        })
    }
}

/// The openings between rooms.
///
/// # Safety
///
/// `openings` is NULL or points to `count` openings that stay as they are during this call.
unsafe fn openings_of(
    openings: *const PlanformOpening,
    count: usize,
) -> Result<Vec<StatedOpening>, PluginError> {
    if count > MAX_ANNOTATIONS {
        let message = format!("has more than {MAX_ANNOTATIONS} openings");
        return Err(PluginError::new(ErrorKind::Limit, message));
    }
    if count == 0 {
        return Ok(vec![]);
    }
    if openings.is_null() {
        return Err(of_plugin("its openings are missing (a null pointer)"));
    }
    // SAFETY: not NULL, and as many as the caller promises.
    let openings = unsafe { slice::from_raw_parts(openings, count) };
    openings.iter().map(opening_of).collect()
}

fn opening_of(opening: &PlanformOpening) -> Result<StatedOpening, PluginError> {
    let PlanformOpening { from_x, from_y, to_x, to_y, depth, kind } = *opening;
    finite([from_x, from_y, to_x, to_y, depth], "an opening")?;
    let kind = match kind {
        PLANFORM_DOOR => OpeningKind::Door,
        PLANFORM_PASSAGE => OpeningKind::Passage,
        other => return Err(of_plugin(&format!("an opening is of the kind {other}, which there is not"))),
    };
    let segment = Segment::new(Point::new(from_x, from_y), Point::new(to_x, to_y));
    Ok(StatedOpening { kind, segment, depth: Some(depth).filter(|d| *d >= 0.0) })
}

unsafe extern "C" fn stage(context: *mut c_void, stage: *const PlanformStage) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and a stage of its own.
    unsafe {
        take(context, |taken| {
            let stage = looked(stage)?;
            let name = text_of(stage.name, "the name of a stage")?;
            taken.take_stage(&name, picture_of(&stage)?)
        })
    }
}

/// The picture of a stage, if it has one.
///
/// # Safety
///
/// `rgb` is NULL or points to `rgb_length` bytes that stay as they are for `'a`.
unsafe fn picture_of<'a>(stage: &PlanformStage) -> Result<Option<Picture<'a>>, PluginError> {
    if stage.rgb.is_null() {
        return Ok(None);
    }
    // SAFETY: not NULL, and as many as the caller promises.
    let rgb = unsafe { slice::from_raw_parts(stage.rgb, stage.rgb_length) };
    let wrong = || {
        let PlanformStage { width, height, rgb_length, .. } = stage;
        of_plugin(&format!("a stage's picture of {width} x {height} pixels has {rgb_length} bytes"))
    };
    Picture::new(stage.width, stage.height, rgb).map(Some).ok_or_else(wrong)
}

unsafe extern "C" fn anchor(context: *mut c_void, anchor: *const PlanformAnchor) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and an anchor of its own.
    unsafe {
        take(context, |taken| {
            let PlanformAnchor { size: _, latitude, longitude, bearing, x, y } = looked(anchor)?;
            finite([latitude, longitude, bearing, x, y], "the anchor")?;
            taken.annotations.anchor = Some(GeoAnchor { latitude, longitude, bearing, at: Point::new(x, y) });
            Ok(())
        })
    }
}

unsafe extern "C" fn warning(context: *mut c_void, warning: PlanformString) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and a text of its own.
    unsafe {
        take(context, |taken| {
            push(&mut taken.annotations.warnings, text_of(warning, "a warning")?, "warnings")
        })
    }
}

unsafe extern "C" fn provenance(
    context: *mut c_void,
    source: PlanformString,
    adapter: PlanformString,
) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and texts of its own.
    unsafe {
        take(context, |taken| {
            let source = text_of(source, "the document's name")?;
            let adapter = text_of(adapter, "the adapter's name")?;
            taken.annotations.provenance = Provenance { source, adapter };
            Ok(())
        })
    }
}

unsafe extern "C" fn fail(context: *mut c_void, problem: *const PlanformProblem) -> PlanformStatus {
    // SAFETY: the plugin hands back the context that it was given, and a problem of its own.
    guard(|| unsafe { receiver(context).with(|taken| taken.fault.note_problem(problem)) })
        .unwrap_or(PLANFORM_PLUGIN_FAULT)
}
