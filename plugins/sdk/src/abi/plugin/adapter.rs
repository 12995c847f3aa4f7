//! An input adapter as a table.
#![allow(unsafe_code)]

use super::{info, problem, received};
use crate::abi::guard::guard;
use crate::abi::table::look;
use crate::abi::{
    PLANFORM_DOOR, PLANFORM_OK, PLANFORM_PASSAGE, PLANFORM_PLUGIN_FAULT, PLANFORM_WANTS_PICTURES,
    PlanformAdapter, PlanformAnchor, PlanformDoorLeaf, PlanformGrid, PlanformJson, PlanformOpening,
    PlanformProbe, PlanformScale, PlanformSceneSink, PlanformSource, PlanformStage, PlanformStatus,
    PlanformString, PlanformSymbol, PlanformText,
};
use crate::{
    Confidence, DoorLeaf, GeoAnchor, InputAdapter, OpeningKind, Picture, Probe, ReadWatcher, Scale, Scene,
    StatedOpening, Symbol, Text,
};

/// The table, never freed.
pub fn table(adapter: Box<dyn InputAdapter>) -> *const PlanformAdapter {
    let info = info::table(adapter.info());
    Box::leak(Box::new(PlanformAdapter {
        size: size_of::<PlanformAdapter>(),
        info,
        data: Box::into_raw(Box::new(adapter)).cast(),
        probe: Some(probe),
        read: Some(read),
    }))
}

/// # Safety
///
/// `adapter` is a table that [`table`] made.
unsafe fn adapter_of<'a>(adapter: *const PlanformAdapter) -> &'a dyn InputAdapter {
    // SAFETY: `table` put a Box<dyn InputAdapter> there, which is never freed.
    unsafe { (*(*adapter).data.cast::<Box<dyn InputAdapter>>()).as_ref() }
}

unsafe extern "C" fn probe(adapter: *const PlanformAdapter, probe: *const PlanformProbe) -> i32 {
    // SAFETY: the host hands over the table that it was given, and a probe of its own.
    guard(|| unsafe { probe_with(adapter_of(adapter), probe) }).unwrap_or_else(|panic| {
        // SAFETY: as above.
        if let Ok(probe) = unsafe { look(probe) } {
            // SAFETY: the callback is called with its own context, and the text lives until it returns.
            unsafe { (probe.reason)(probe.context, PlanformString::of(panic.as_bytes())) };
        }
        -PLANFORM_PLUGIN_FAULT
    })
}

/// # Safety
///
/// `probe` is NULL or a probe of the host's.
unsafe fn probe_with(adapter: &dyn InputAdapter, probe: *const PlanformProbe) -> i32 {
    // SAFETY: as the caller promises.
    let Ok(probe) = (unsafe { look(probe) }) else { return 0 };
    // SAFETY: path and head of a probe of the host's live until its call returns.
    let (path, head) = unsafe { (probe.path.to_path(), received::copied(probe.head, probe.head_length)) };
    let Confidence { percent, reason } = adapter.probe(&Probe { path: &path, head: &head });
    if !reason.is_empty() {
        // SAFETY: the callback is called with its own context, and the reason lives until it returns.
        unsafe { (probe.reason)(probe.context, PlanformString::of(reason.as_bytes())) };
    }
    i32::from(percent)
}

unsafe extern "C" fn read(
    adapter: *const PlanformAdapter,
    source: *const PlanformSource,
    options: *const PlanformJson,
    sink: *const PlanformSceneSink,
) -> PlanformStatus {
    // SAFETY: the host hands over the table that it was given, and the rest is its own.
    guard(|| unsafe { read_into(adapter, source, options, sink) }).unwrap_or(PLANFORM_PLUGIN_FAULT)
}

/// # Safety
///
/// `adapter` is a table that [`table`] made, the others are NULL or of the host's.
unsafe fn read_into(
    adapter: *const PlanformAdapter,
    source: *const PlanformSource,
    options: *const PlanformJson,
    sink: *const PlanformSceneSink,
) -> PlanformStatus {
    // SAFETY: the host hands over a sink of its own.
    let Ok(sink) = (unsafe { look(sink) }) else { return PLANFORM_PLUGIN_FAULT };
    let mut stages = Stages { sink: &sink, refusal: None };
    let scene = guard(|| {
        // SAFETY: the host hands over the table that it was given, and a source and options of its own.
        unsafe {
            let adapter = adapter_of(adapter);
            let options = received::options(options, &adapter.info().options)?;
            adapter.read_watched(&received::source(source)?, &options, &mut stages)
        }
    });
    if let Some(status) = stages.refusal {
        return status;
    }
    match scene.unwrap_or_else(|panic| Err(problem::of_panic(panic))) {
        // SAFETY: the sink is the host's, and its call has not ended.
        Ok(scene) => unsafe { hand_over(&scene, &sink) },
        // SAFETY: as above.
        Err(e) => unsafe { problem::report(sink.fail, sink.context, &e) },
    }
}

/// Hands stages to the sink, up to the first refusal.
struct Stages<'a> {
    sink: &'a PlanformSceneSink,
    refusal: Option<PlanformStatus>,
}

// SAFETY: the callbacks of a sink may be called from every thread, during the call that it was made for.
unsafe impl Send for Stages<'_> {}

impl ReadWatcher for Stages<'_> {
    fn wants_pictures(&self) -> bool {
        self.sink.flags & PLANFORM_WANTS_PICTURES != 0
    }

    fn stage(&mut self, name: &str, picture: Option<Picture<'_>>) {
        let (Some(take), None) = (self.sink.stage, self.refusal) else { return };
        let stage = PlanformStage {
            size: size_of::<PlanformStage>(),
            name: PlanformString::of(name.as_bytes()),
            width: picture.map_or(0, |p| p.width()),
            height: picture.map_or(0, |p| p.height()),
            rgb: picture.map_or(std::ptr::null(), |p| p.rgb().as_ptr()),
            rgb_length: picture.map_or(0, |p| p.rgb().len()),
        };
        // SAFETY: the callback is called with its own context, and what it is handed lives until it returns.
        self.refusal = accepted(unsafe { take(self.sink.context, &stage) }).err();
    }
}

/// Hands the scene to the sink, up to the first refusal.
///
/// # Safety
///
/// `sink` is of the host's, and its call has not ended.
unsafe fn hand_over(scene: &Scene, sink: &PlanformSceneSink) -> PlanformStatus {
    let context = sink.context;
    let text = |text: &str| PlanformString::of(text.as_bytes());
    // SAFETY: every callback is called with its own context, and what it is handed lives until it returns.
    let handed = unsafe {
        accepted((sink.grid)(context, &PlanformGrid::of(&scene.grid)))
            .and_then(|()| all(&scene.texts, |t| (sink.text)(context, &self::text(t))))
            .and_then(|()| all(&scene.symbols, |s| hand_over_symbol(s, sink)))
            .and_then(|()| all(&scene.openings, |o| hand_over_openings(o, sink)))
            .and_then(|()| all(&scene.anchor, |a| (sink.anchor)(context, &anchor(a))))
            .and_then(|()| all(&scene.scale, |s| hand_over_scale(s, sink)))
            .and_then(|()| all(&scene.warnings, |w| (sink.warning)(context, text(w))))
            .and_then(|()| {
                let provenance = &scene.provenance;
                let status = (sink.provenance)(context, text(&provenance.source), text(&provenance.adapter));
                accepted(status)
            })
    };
    handed.err().unwrap_or(PLANFORM_OK)
}

fn accepted(status: PlanformStatus) -> Result<(), PlanformStatus> {
    if status == PLANFORM_OK { Ok(()) } else { Err(status) }
}

/// Hands over each of these, up to the first refusal.
fn all<'a, T: 'a>(
    items: impl IntoIterator<Item = &'a T>,
    hand_over: impl Fn(&T) -> PlanformStatus,
) -> Result<(), PlanformStatus> {
    items.into_iter().try_for_each(|item| accepted(hand_over(item)))
}

fn text(text: &Text) -> PlanformText {
    PlanformText {
        size: size_of::<PlanformText>(),
        content: PlanformString::of(text.content.as_bytes()),
        x: text.pose.x,
        y: text.pose.y,
        yaw: text.pose.yaw,
        width: text.width,
        height: text.height,
        confidence: text.confidence,
    }
}

/// # Safety
///
/// As for [`hand_over`].
unsafe fn hand_over_symbol(symbol: &Symbol, sink: &PlanformSceneSink) -> PlanformStatus {
    let leaves: Vec<_> = symbol.leaves.iter().map(leaf).collect();
    let symbol = PlanformSymbol {
        size: size_of::<PlanformSymbol>(),
        kind: PlanformString::of(symbol.kind.as_bytes()),
        x: symbol.pose.x,
        y: symbol.pose.y,
        yaw: symbol.pose.yaw,
        width: symbol.width,
        height: symbol.height,
        score: symbol.score,
        leaves: leaves.as_ptr(),
        leaf_count: leaves.len(),
    };
    // SAFETY: the callback is called with its own context, and what it is handed lives until it returns.
    unsafe { (sink.symbol)(sink.context, &symbol) }
}

fn leaf(DoorLeaf { hinge, closed, open }: &DoorLeaf) -> PlanformDoorLeaf {
    PlanformDoorLeaf {
        hinge_x: hinge.x,
        hinge_y: hinge.y,
        closed_x: closed.x,
        closed_y: closed.y,
        open_x: open.x,
        open_y: open.y,
    }
}

/// Hands over the scale, which a host of version 1.0 has no room for.
///
/// # Safety
///
/// As for [`hand_over`].
unsafe fn hand_over_scale(scale: &Scale, sink: &PlanformSceneSink) -> PlanformStatus {
    let Some(take) = sink.scale else { return PLANFORM_OK };
    let scale = PlanformScale {
        size: size_of::<PlanformScale>(),
        metres_per_pixel: scale.metres_per_pixel,
        source: PlanformString::of(scale.source.as_bytes()),
        confidence: scale.confidence,
    };
    // SAFETY: the callback is called with its own context, and what it is handed lives until it returns.
    unsafe { take(sink.context, &scale) }
}

/// Hands over the openings, which a host of before version 1.3 has no room for.
///
/// # Safety
///
/// As for [`hand_over`].
unsafe fn hand_over_openings(openings: &[StatedOpening], sink: &PlanformSceneSink) -> PlanformStatus {
    let Some(take) = sink.openings else { return PLANFORM_OK };
    let openings: Vec<_> = openings.iter().map(opening).collect();
    // SAFETY: the callback is called with its own context, and what it is handed lives until it returns.
    unsafe { take(sink.context, openings.as_ptr(), openings.len()) }
}

fn opening(StatedOpening { kind, segment, depth }: &StatedOpening) -> PlanformOpening {
    PlanformOpening {
        from_x: segment.a.x,
        from_y: segment.a.y,
        to_x: segment.b.x,
        to_y: segment.b.y,
        depth: depth.unwrap_or(-1.0),
        kind: match kind {
            OpeningKind::Door => PLANFORM_DOOR,
            OpeningKind::Passage => PLANFORM_PASSAGE,
        },
    }
}

fn anchor(anchor: &GeoAnchor) -> PlanformAnchor {
    PlanformAnchor {
        size: size_of::<PlanformAnchor>(),
        latitude: anchor.latitude,
        longitude: anchor.longitude,
        bearing: anchor.bearing,
        x: anchor.at.x,
        y: anchor.at.y,
    }
}
