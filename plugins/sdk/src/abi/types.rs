//! What crosses, as C sees it.

use std::ffi::{c_char, c_void};

/// The version of this interface. Another major version is another interface; a higher minor version has more fields
/// at the end of some structs.
pub const PLANFORM_ABI_MAJOR: u32 = 1;
/// See PLANFORM_ABI_MAJOR.
pub const PLANFORM_ABI_MINOR: u32 = 3;

/// How a call ended: PLANFORM_OK or what went wrong.
pub type PlanformStatus = i32;
/// It did what it was asked.
pub const PLANFORM_OK: i32 = 0;
/// The document is damaged or is not what its format promises.
pub const PLANFORM_BAD_INPUT: i32 = 1;
/// The document is sound, but uses something that the plugin does not handle.
pub const PLANFORM_UNSUPPORTED: i32 = 2;
/// The document is larger than a limit allows.
pub const PLANFORM_LIMIT: i32 = 3;
/// An option has a value that cannot be used.
pub const PLANFORM_BAD_OPTION: i32 = 4;
/// The operating system refused to read or write.
pub const PLANFORM_IO: i32 = 5;
/// The plugin has a bug.
pub const PLANFORM_PLUGIN_FAULT: i32 = 6;

/// The flag of a plugin whose functions may be called from several threads at the same time.
pub const PLANFORM_THREAD_SAFE: u64 = 1;

/// The flag of a sink that makes use of the stages' pictures. Since version 1.1.
pub const PLANFORM_WANTS_PICTURES: u64 = 1;

/// What a PlanformOpening is: of a door's width. Since version 1.3.
pub const PLANFORM_DOOR: u32 = 0;
/// What a PlanformOpening is: wider than a door. Since version 1.3.
pub const PLANFORM_PASSAGE: u32 = 1;

/// What PlanformProblem.position counts: nothing, the problem has no place.
pub const PLANFORM_NOWHERE: u32 = 0;
/// What PlanformProblem.position counts: lines, from 1.
pub const PLANFORM_LINE: u32 = 1;
/// What PlanformProblem.position counts: bytes, from 0.
pub const PLANFORM_BYTE: u32 = 2;

/// How important a log message is: something that the user should know.
pub const PLANFORM_LOG_WARNING: u32 = 1;
/// How important a log message is: of interest to who looks for it.
pub const PLANFORM_LOG_INFO: u32 = 2;

/// What a PlanformValue is: there is none, or it is null.
pub const PLANFORM_NOTHING: u32 = 0;
/// What a PlanformValue is: true or false.
pub const PLANFORM_FLAG: u32 = 1;
/// What a PlanformValue is: a number.
pub const PLANFORM_NUMBER: u32 = 2;
/// What a PlanformValue is: a text.
pub const PLANFORM_TEXT: u32 = 3;
/// What a PlanformValue is: an array.
pub const PLANFORM_ARRAY: u32 = 4;
/// What a PlanformValue is: an object.
pub const PLANFORM_OBJECT: u32 = 5;

/// Text in UTF-8. What planform hands to a plugin is followed by a zero byte, so that it can be used as a C string
/// too; what a plugin hands over need not be. NULL is the empty text.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct PlanformString {
    /// Its first byte.
    pub data: *const c_char,
    /// How many bytes it has, without the zero byte.
    pub length: usize,
}

/// A value of a JSON document that planform has read: read it with the functions of PlanformHost, which all take NULL
/// for a value that is not there.
pub struct PlanformValue(());

/// What planform offers to a plugin. Valid for ever.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformHost {
    /// sizeof(PlanformHost), as planform was compiled.
    pub size: usize,
    /// PLANFORM_ABI_MAJOR, as planform was compiled.
    pub abi_major: u32,
    /// PLANFORM_ABI_MINOR, as planform was compiled.
    pub abi_minor: u32,
    /// planform's own version.
    pub version: PlanformString,
    /// Tells the user something: PLANFORM_LOG_WARNING or PLANFORM_LOG_INFO, and one sentence.
    pub log: unsafe extern "C" fn(level: u32, message: PlanformString),
    /// What a value is: PLANFORM_NOTHING, PLANFORM_FLAG and so on.
    pub kind: unsafe extern "C" fn(value: *const PlanformValue) -> u32,
    /// The member of an object by its name, a C string; NULL if there is none.
    pub member:
        unsafe extern "C" fn(value: *const PlanformValue, name: *const c_char) -> *const PlanformValue,
    /// The element of an array, from 0; NULL if there is none.
    pub element: unsafe extern "C" fn(value: *const PlanformValue, index: usize) -> *const PlanformValue,
    /// How many elements an array has; 0 for everything else.
    pub length: unsafe extern "C" fn(value: *const PlanformValue) -> usize,
    /// The number, or `otherwise` for everything that is not a number.
    pub number: unsafe extern "C" fn(value: *const PlanformValue, otherwise: f64) -> f64,
    /// True or false, or `otherwise` for everything that is neither.
    pub flag: unsafe extern "C" fn(value: *const PlanformValue, otherwise: bool) -> bool,
    /// The text, or a NULL text for everything that is not a text. Valid as long as the value.
    pub text: unsafe extern "C" fn(value: *const PlanformValue) -> PlanformString,
}

/// What an adapter or exporter says of itself. Valid for ever; no text may be NULL unless it says so.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformInfo {
    /// sizeof(PlanformInfo).
    pub size: usize,
    /// Short name as the user types it: lower-case letters, digits and hyphens.
    pub name: *const c_char,
    /// One line for people.
    pub description: *const c_char,
    /// Version of the plugin.
    pub version: *const c_char,
    /// Licence as an SPDX expression.
    pub licence: *const c_char,
    /// File name extensions without the dot, lower case, the preferred one first; NULL ends the list. The list itself
    /// may be NULL.
    pub extensions: *const *const c_char,
    /// Media types, the preferred one first; NULL ends the list. The list itself may be NULL.
    pub media_types: *const *const c_char,
    /// The options as a JSON Schema of an object, see `planform plugins schema options`; NULL for none.
    pub options: *const c_char,
    /// PLANFORM_THREAD_SAFE, or 0.
    pub flags: u64,
}

/// A JSON document, both as it is written and as values to be walked through. Valid until the call returns.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformJson {
    /// sizeof(PlanformJson), as planform was compiled.
    pub size: usize,
    /// The document in UTF-8.
    pub text: PlanformString,
    /// The same, read.
    pub value: *const PlanformValue,
}

/// What went wrong in a call.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformProblem {
    /// sizeof(PlanformProblem).
    pub size: usize,
    /// Who or what is at fault.
    pub status: PlanformStatus,
    /// What `position` counts: PLANFORM_NOWHERE, PLANFORM_LINE or PLANFORM_BYTE.
    pub place: u32,
    /// Where in the document the fault lies.
    pub position: u64,
    /// What was wrong, a sentence without its full stop. planform puts the document's name in front.
    pub message: PlanformString,
    /// What the user can do; NULL for no advice.
    pub advice: PlanformString,
}

/// What an adapter may look at to recognise a document. Valid until the call returns.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformProbe {
    /// sizeof(PlanformProbe), as planform was compiled.
    pub size: usize,
    /// To be handed to the callbacks.
    pub context: *mut c_void,
    /// The document's path as the system has it, in whatever encoding; empty for standard input.
    pub path: PlanformString,
    /// The first bytes: 4096 of them or the whole document, whichever is less.
    pub head: *const u8,
    /// How many bytes `head` has.
    pub head_length: usize,
    /// Takes what the adapter judged by, for the user's eyes: "a PNG by its first bytes".
    pub reason: unsafe extern "C" fn(context: *mut c_void, reason: PlanformString),
}

/// Takes a file's bytes, which are valid during the call. `receiver` is what planform was given for it.
pub type PlanformTake = unsafe extern "C" fn(receiver: *mut c_void, bytes: *const u8, length: usize);

/// A document to be read. Valid until the call returns.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformSource {
    /// sizeof(PlanformSource), as planform was compiled.
    pub size: usize,
    /// To be handed to the callbacks.
    pub context: *mut c_void,
    /// The document's path as the system has it, in whatever encoding; empty for standard input.
    pub path: PlanformString,
    /// The whole document.
    pub bytes: *const u8,
    /// How many bytes it has.
    pub length: usize,
    /// The most bytes that a file that the document refers to may have.
    pub byte_limit: u64,
    /// Reads a file that the document refers to, relative to the document's folder, and hands it to `take`. What went
    /// wrong is remembered, so that the adapter can just return the status.
    pub sibling: unsafe extern "C" fn(
        context: *mut c_void,
        reference: PlanformString,
        take: PlanformTake,
        receiver: *mut c_void,
    ) -> PlanformStatus,
}

/// An occupancy grid, as ROS's nav_msgs/OccupancyGrid.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformGrid {
    /// sizeof(PlanformGrid).
    pub size: usize,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f64,
    /// Where the outer corner of the lower left cell lies in the map frame: to the right, metres.
    pub origin_x: f64,
    /// The same: up, metres.
    pub origin_y: f64,
    /// By how much the grid is turned about that corner, radians counter-clockwise.
    pub origin_yaw: f64,
    /// The cells row by row, the bottom row first, each from left to right: 0 (free) to 100 (occupied), -1 unknown.
    pub cells: *const i8,
    /// How many there are: width times height.
    pub cell_count: usize,
}

/// A text that a document shows.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformText {
    /// sizeof(PlanformText).
    pub size: usize,
    /// What it says.
    pub content: PlanformString,
    /// The middle of its box in the map frame, metres to the right.
    pub x: f64,
    /// The same, metres up.
    pub y: f64,
    /// The reading direction, radians counter-clockwise from the x axis.
    pub yaw: f64,
    /// Length along the reading direction, metres.
    pub width: f64,
    /// Height of the box, metres.
    pub height: f64,
    /// From 0 (a guess) to 1 (certain).
    pub confidence: f64,
}

/// A leaf of a door as a plan draws it, in the map frame. No version changes it: it stands in arrays.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformDoorLeaf {
    /// The point that it turns about: metres to the right.
    pub hinge_x: f64,
    /// The same, metres up.
    pub hinge_y: f64,
    /// Where its free end lies when it is closed: metres to the right.
    pub closed_x: f64,
    /// The same, metres up.
    pub closed_y: f64,
    /// Where its free end lies when it is as far open as drawn: metres to the right.
    pub open_x: f64,
    /// The same, metres up.
    pub open_y: f64,
}

/// A symbol that a document shows, such as a fire extinguisher or a door.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformSymbol {
    /// sizeof(PlanformSymbol).
    pub size: usize,
    /// What it means.
    pub kind: PlanformString,
    /// Its middle in the map frame, metres to the right.
    pub x: f64,
    /// The same, metres up.
    pub y: f64,
    /// Its direction, radians counter-clockwise from the x axis.
    pub yaw: f64,
    /// Length along its direction, metres.
    pub width: f64,
    /// Extent across its direction, metres.
    pub height: f64,
    /// From 0 (a guess) to 1 (certain).
    pub score: f64,
    /// The leaves of a door that swings, as drawn; may be NULL. Since version 1.1.
    pub leaves: *const PlanformDoorLeaf,
    /// How many there are. Since version 1.1.
    pub leaf_count: usize,
}

/// Where the map frame lies on the Earth.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformAnchor {
    /// sizeof(PlanformAnchor).
    pub size: usize,
    /// WGS 84 latitude of the point (x, y), degrees north.
    pub latitude: f64,
    /// WGS 84 longitude of the point (x, y), degrees east.
    pub longitude: f64,
    /// Direction of the map's y axis, degrees clockwise from true north.
    pub bearing: f64,
    /// The point of the map frame that lies there, metres to the right.
    pub x: f64,
    /// The same, metres up.
    pub y: f64,
}

/// How large a document shows the building. Since version 1.1.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformScale {
    /// sizeof(PlanformScale).
    pub size: usize,
    /// Length in the building of a pixel of the document, metres.
    pub metres_per_pixel: f64,
    /// What it was found by, for the user's eyes: "written scale 1:100".
    pub source: PlanformString,
    /// From 0 (a guess) to 1 (certain).
    pub confidence: f64,
}

/// An opening between two rooms that a document states, metres in the map frame. Since version 1.3.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformOpening {
    /// One end, in the middle of the wall.
    pub from_x: f64,
    /// The same, up.
    pub from_y: f64,
    /// The other end.
    pub to_x: f64,
    /// The same, up.
    pub to_y: f64,
    /// Thickness of the wall, metres; 0 where the rooms' floors meet, less where it is not stated.
    pub depth: f64,
    /// PLANFORM_DOOR or PLANFORM_PASSAGE.
    pub kind: u32,
}

/// A stage of an adapter's work that is done, for who looks on. Since version 1.1.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformStage {
    /// sizeof(PlanformStage).
    pub size: usize,
    /// What it is called, in lower-case letters, digits and hyphens: "deskew".
    pub name: PlanformString,
    /// Columns of its picture.
    pub width: u32,
    /// Rows of its picture.
    pub height: u32,
    /// The picture: red, green and blue of each pixel, row by row from the top, each from left to right. NULL for none,
    /// as when PLANFORM_WANTS_PICTURES is not set.
    pub rgb: *const u8,
    /// How many bytes there are: three times width times height.
    pub rgb_length: usize,
}

/// Takes what an adapter finds in a document. Valid until the call returns. A callback copies what it is given; one
/// that does not return PLANFORM_OK has refused it, and the adapter should give up and return that status.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformSceneSink {
    /// sizeof(PlanformSceneSink), as planform was compiled.
    pub size: usize,
    /// To be handed to the callbacks.
    pub context: *mut c_void,
    /// Takes the grid. Every scene has exactly one.
    pub grid: unsafe extern "C" fn(context: *mut c_void, grid: *const PlanformGrid) -> PlanformStatus,
    /// Takes one text; to be called for each.
    pub text: unsafe extern "C" fn(context: *mut c_void, text: *const PlanformText) -> PlanformStatus,
    /// Takes one symbol; to be called for each.
    pub symbol: unsafe extern "C" fn(context: *mut c_void, symbol: *const PlanformSymbol) -> PlanformStatus,
    /// Takes the place on the Earth, if the document tells it.
    pub anchor: unsafe extern "C" fn(context: *mut c_void, anchor: *const PlanformAnchor) -> PlanformStatus,
    /// Takes a sentence that the user should read; to be called for each.
    pub warning: unsafe extern "C" fn(context: *mut c_void, warning: PlanformString) -> PlanformStatus,
    /// Takes the document's name and the adapter's, if they are others than planform knows already.
    pub provenance: unsafe extern "C" fn(
        context: *mut c_void,
        source: PlanformString,
        adapter: PlanformString,
    ) -> PlanformStatus,
    /// Takes what went wrong and returns its status, for the adapter to return.
    pub fail: unsafe extern "C" fn(context: *mut c_void, problem: *const PlanformProblem) -> PlanformStatus,
    /// Takes the scale of a document whose cells were not measured, such as a plan. Since version 1.1: only there if
    /// `size` says so.
    pub scale:
        Option<unsafe extern "C" fn(context: *mut c_void, scale: *const PlanformScale) -> PlanformStatus>,
    /// PLANFORM_WANTS_PICTURES, or 0. Since version 1.1.
    pub flags: u64,
    /// Takes a stage of the work when it is done; to be called for each, or never. Since version 1.1: only there if
    /// `size` says so.
    pub stage:
        Option<unsafe extern "C" fn(context: *mut c_void, stage: *const PlanformStage) -> PlanformStatus>,
    /// Takes all openings between rooms, if the document states them; to be called once, or never. With a count of 0
    /// there are none. Since version 1.3: only there if `size` says so.
    pub openings: Option<
        unsafe extern "C" fn(
            context: *mut c_void,
            openings: *const PlanformOpening,
            count: usize,
        ) -> PlanformStatus,
    >,
}

/// What an exporter writes. Valid until the call returns.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformDocument {
    /// sizeof(PlanformDocument), as planform was compiled.
    pub size: usize,
    /// The layout, see `planform plugins schema layout`.
    pub layout: *const PlanformJson,
    /// The grid that it was reconstructed from, or NULL.
    pub grid: *const PlanformGrid,
    /// What else the scene holds, see `planform plugins schema scene`; NULL when `grid` is.
    pub scene: *const PlanformJson,
}

/// Takes an output. Valid until the call returns.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformOutput {
    /// sizeof(PlanformOutput), as planform was compiled.
    pub size: usize,
    /// To be handed to the callbacks.
    pub context: *mut c_void,
    /// Takes the next bytes of the file. When it does not return PLANFORM_OK, the exporter should give up and return
    /// that status.
    pub write: unsafe extern "C" fn(context: *mut c_void, bytes: *const u8, length: usize) -> PlanformStatus,
    /// Takes what went wrong and returns its status, for the exporter to return.
    pub fail: unsafe extern "C" fn(context: *mut c_void, problem: *const PlanformProblem) -> PlanformStatus,
    /// The file's name up to its extension, for what refers to its companions. Since version 1.2: only there if `size`
    /// says so.
    pub stem: PlanformString,
    /// Its extension without the dot, as the user typed it; empty for what is no file. Since version 1.2: only there if
    /// `size` says so.
    pub extension: PlanformString,
    /// Takes the next bytes of a companion, by its place in PlanformExporter.companions from 0; otherwise as `write`.
    /// Since version 1.2: only there if `size` says so.
    pub companion: Option<
        unsafe extern "C" fn(
            context: *mut c_void,
            number: usize,
            bytes: *const u8,
            length: usize,
        ) -> PlanformStatus,
    >,
}

/// Reads one family of document formats. Valid for ever.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformAdapter {
    /// sizeof(PlanformAdapter).
    pub size: usize,
    /// Name, extensions, options.
    pub info: *const PlanformInfo,
    /// The plugin's own; planform does not look at it.
    pub data: *mut c_void,
    /// How sure the adapter is that the document is its own, 0 (surely not) to 100. Must be quick and must accept any
    /// bytes. A negative number says that it failed, and `reason` then takes why.
    pub probe:
        Option<unsafe extern "C" fn(adapter: *const PlanformAdapter, probe: *const PlanformProbe) -> i32>,
    /// Reads the document into the sink. `options` are values that fit the schema, defaults filled in.
    pub read: Option<
        unsafe extern "C" fn(
            adapter: *const PlanformAdapter,
            source: *const PlanformSource,
            options: *const PlanformJson,
            sink: *const PlanformSceneSink,
        ) -> PlanformStatus,
    >,
}

/// Writes layouts in one format. Valid for ever.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformExporter {
    /// sizeof(PlanformExporter).
    pub size: usize,
    /// Name, extensions, options.
    pub info: *const PlanformInfo,
    /// The plugin's own; planform does not look at it.
    pub data: *mut c_void,
    /// Writes the document to the output. `options` are values that fit the schema, defaults filled in. The same
    /// document and options must give the same bytes, always.
    pub write: Option<
        unsafe extern "C" fn(
            exporter: *const PlanformExporter,
            document: *const PlanformDocument,
            options: *const PlanformJson,
            output: *const PlanformOutput,
        ) -> PlanformStatus,
    >,
    /// The extensions of the files that lie beside a document of this format, without the dot, lower case: the
    /// companion "pgm" of map.yaml is map.pgm. NULL ends the list. The list itself may be NULL, and most are. Since
    /// version 1.2.
    pub companions: *const *const c_char,
}

/// What a plugin library offers. Valid for ever.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct PlanformPlugin {
    /// sizeof(PlanformPlugin).
    pub size: usize,
    /// PLANFORM_ABI_MAJOR, as the plugin was compiled.
    pub abi_major: u32,
    /// PLANFORM_ABI_MINOR, as the plugin was compiled.
    pub abi_minor: u32,
    /// Its input adapters; NULL ends the list. The list itself may be NULL.
    pub adapters: *const *const PlanformAdapter,
    /// Its exporters; NULL ends the list. The list itself may be NULL.
    pub exporters: *const *const PlanformExporter,
}

/// The one function that a plugin library exports, under the name `planform_plugin`. Called once, before anything
/// else; NULL says that the plugin does not work with this host.
pub type PlanformEntry = unsafe extern "C" fn(host: *const PlanformHost) -> *const PlanformPlugin;
