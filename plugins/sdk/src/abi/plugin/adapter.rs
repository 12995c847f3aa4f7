//! An input adapter as a table.
#![allow(unsafe_code)]

use super::{info, problem, received};
use crate::abi::guard::guard;
use crate::abi::table::look;
use crate::abi::{
    PLANFORM_OK, PLANFORM_PLUGIN_FAULT, PlanformAdapter, PlanformAnchor, PlanformGrid, PlanformJson,
    PlanformProbe, PlanformSceneSink, PlanformSource, PlanformStatus, PlanformString, PlanformSymbol,
    PlanformText,
};
use crate::{Confidence, GeoAnchor, InputAdapter, Probe, Scene, Symbol, Text};

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
    let scene = guard(|| {
        // SAFETY: the host hands over the table that it was given, and a source and options of its own.
        unsafe {
            let adapter = adapter_of(adapter);
            let options = received::options(options, &adapter.info().options)?;
            adapter.read(&received::source(source)?, &options)
        }
    });
    match scene.unwrap_or_else(|panic| Err(problem::of_panic(panic))) {
        // SAFETY: the sink is the host's, and its call has not ended.
        Ok(scene) => unsafe { hand_over(&scene, &sink) },
        // SAFETY: as above.
        Err(e) => unsafe { problem::report(sink.fail, sink.context, &e) },
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
            .and_then(|()| all(&scene.symbols, |s| (sink.symbol)(context, &symbol(s))))
            .and_then(|()| all(&scene.anchor, |a| (sink.anchor)(context, &anchor(a))))
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

fn symbol(symbol: &Symbol) -> PlanformSymbol {
    PlanformSymbol {
        size: size_of::<PlanformSymbol>(),
        kind: PlanformString::of(symbol.kind.as_bytes()),
        x: symbol.pose.x,
        y: symbol.pose.y,
        yaw: symbol.pose.yaw,
        width: symbol.width,
        height: symbol.height,
        score: symbol.score,
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
