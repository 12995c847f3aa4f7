//! What the host hands over, as the model's types.
#![allow(unsafe_code)]

use super::problem::of_host;
use crate::abi::table::look;
use crate::abi::{PlanformDocument, PlanformGrid, PlanformJson, PlanformSource};
use crate::{
    Annotations, Cell, Grid, Layout, OptionSpec, OptionValue, Options, PluginError, Pose, Scene, Source,
};
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::slice;

/// Bytes of the other side, copied.
///
/// # Safety
///
/// `bytes` is NULL, or points to `length` bytes that stay as they are during the call.
pub unsafe fn copied(bytes: *const u8, length: usize) -> Vec<u8> {
    if bytes.is_null() || length == 0 {
        return vec![];
    }
    // SAFETY: as the caller promises.
    unsafe { slice::from_raw_parts(bytes, length) }.to_vec()
}

/// # Safety
///
/// `json` is NULL or a document of the host's.
unsafe fn parsed<T: DeserializeOwned>(json: *const PlanformJson) -> Result<T, PluginError> {
    // SAFETY: as the caller promises.
    let json = unsafe { look(json) }.map_err(of_host)?;
    // SAFETY: a text of the host's lives until the call that handed it over returns.
    serde_json::from_slice(unsafe { json.text.bytes() }).map_err(of_host)
}

/// The options of a call, checked against the specs.
///
/// # Safety
///
/// `json` is NULL or a document of the host's.
pub unsafe fn options(json: *const PlanformJson, specs: &[OptionSpec]) -> Result<Options, PluginError> {
    // SAFETY: as the caller promises.
    let values: BTreeMap<String, OptionValue> = unsafe { parsed(json) }?;
    Options::of_values(specs, values)
}

/// The document to read, copied.
///
/// # Safety
///
/// `source` is NULL or a source of the host's.
pub unsafe fn source(source: *const PlanformSource) -> Result<Source, PluginError> {
    // SAFETY: as the caller promises.
    let source = unsafe { look(source) }.map_err(of_host)?;
    // SAFETY: path and bytes of a source of the host's live until its call returns.
    let (path, bytes) = unsafe { (source.path.to_path(), copied(source.bytes, source.length)) };
    Ok(Source { path, bytes, byte_limit: source.byte_limit })
}

/// The layout and the scene to write, copied.
///
/// # Safety
///
/// `document` is NULL or a document of the host's.
pub unsafe fn document(document: *const PlanformDocument) -> Result<(Layout, Option<Scene>), PluginError> {
    // SAFETY: as the caller promises.
    let document = unsafe { look(document) }.map_err(of_host)?;
    // SAFETY: a document's layout is a JSON document of the host's.
    let layout = unsafe { parsed(document.layout) }?;
    if document.grid.is_null() {
        return Ok((layout, None));
    }
    // SAFETY: not NULL, so both are the host's.
    let (grid, annotations) = unsafe { (grid(document.grid)?, parsed::<Annotations>(document.scene)?) };
    Ok((layout, Some(Scene::new(grid, annotations))))
}

/// # Safety
///
/// `grid` is a grid of the host's.
unsafe fn grid(grid: *const PlanformGrid) -> Result<Grid, PluginError> {
    // SAFETY: as the caller promises.
    let grid = unsafe { look(grid) }.map_err(of_host)?;
    // SAFETY: a grid of the host's has as many cells as it says.
    let cells = unsafe { copied(grid.cells.cast(), grid.cell_count) };
    let cells = cells.into_iter().map(|v| Cell::of_ros(v.cast_signed())).collect::<Option<_>>();
    let cells = cells.ok_or_else(|| of_host("a cell that means nothing"))?;
    let origin = Pose { x: grid.origin_x, y: grid.origin_y, yaw: grid.origin_yaw };
    Grid::new(grid.width, grid.height, grid.resolution, origin, cells).map_err(of_host)
}
