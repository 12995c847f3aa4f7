//! Writes layouts as DXF drawings for CAD programs.
//!
//! # Versions
//!
//! `version` is `R12`, `R2000` (the default), `R2013` or `R2018`. R2000 is the oldest version that says in which
//! unit it is drawn and that knows light polylines; CAD programs of the last 25 years read it, while many of them
//! stop somewhere before R2018. R12 is for the simplest readers: it carries no unit, so that the reader must be told
//! that one drawing unit is a metre.
//!
//! # Layers
//!
//! | layer | what lies there | entity |
//! | --- | --- | --- |
//! | `A-WALL` | the walls: both faces and the ends, openings cut out, corners mitred | closed polyline |
//! | `A-WALL-CNTR` | the walls' centre lines, openings not cut out | line |
//! | `A-DOOR` | doors and passages, from jamb to jamb; leaves of doors, open, and their swing | line, arc |
//! | `A-GLAZ` | windows: two thin lines in the wall, closed at their ends, and the jambs | closed polyline, line |
//! | `A-FLOR-STRS` | stairs: the outline, and a line for each step | closed polyline, line |
//! | `A-FLOR-EVTR` | lifts | block |
//! | `A-FLOR-PFIX` | toilets, sinks | block |
//! | `A-AREA` | the rooms: one outer ring and a ring for each hole | closed polyline |
//! | `A-AREA-IDEN` | the rooms' names (`Room 3` if a room has none) and areas | text |
//! | `A-AREA-PRTL` | frontiers: where a partial room meets the unexplored | line |
//! | `A-ANNO-TEXT` | the document's texts, but for those that a room's name is made of, and the names of symbols that there is no drawing of | text |
//! | `A-ANNO-SYMB` | the signs of evacuation plans | block |
//!
//! Leaf and swing of a door are those that the document shows; a layout of a robot's map knows none. A door to the outside,
//! which parts no two rooms, is cut out of its wall as well. Blocks are called after the kinds of symbols, such as
//! `FIRE-EXTINGUISHER`; each is drawn in a box of side 1 and stretched to the symbol's size. Representative lines are not
//! drawn.
//!
//! Closed polylines are `LWPOLYLINE`; in R12 `POLYLINE`. Coordinates are metres in the map frame, x right, y up.
//!
//! # Extended data
//!
//! Every entity carries extended data (XDATA) of the application `PLANFORM`: keys and values in turn. A key is a text
//! (group 1000), a value a text (1000), a whole number (1071) or a number (1040).
//!
//! | key | on | value |
//! | --- | --- | --- |
//! | `kind` | everything | `room`, `label`, `wall`, `door`, `passage`, `frontier`, `text`, `symbol`; of a symbol's parts `leaf`, `swing`, `jamb`, `step` |
//! | `room` | rooms, labels, frontiers | the room's number |
//! | `ring` | rooms | `outer` or `hole` |
//! | `state` | rooms | `complete` or `partial` |
//! | `area` | rooms | net area of the whole room in square metres: outer ring less holes |
//! | `leads` | frontiers | `room` (to the rest of the room) or `space` (to new space) |
//! | `area` | frontiers | estimate of the area behind it in square metres; 0 is none |
//! | `name` | rooms with a name | the name |
//! | `wall` | walls | the wall's number, from 1: the pieces between openings share it |
//! | `thickness` | walls | metres |
//! | `weight` | walls | how sure the wall is, 0 to 1 |
//! | `left`, `right` | walls | the room on that side, seen from start to end; absent outside |
//! | `from`, `to` | doors, passages | the rooms joined |
//! | `width`, `height` | doors, passages, texts, symbols | metres |
//! | `symbol` | symbols and their parts | the symbol's number, from 1 |
//! | `content` | texts, symbols | what it says |
//! | `confidence` | texts, symbols | 0 to 1 |
//!
//! A room's net area by measurement is that of its `outer` ring less those of its `hole` rings.
//!
//! # Text
//!
//! Versions before R2007 know code pages only: characters beyond ASCII are written as `\U+hhhh`, those beyond the
//! Basic Multilingual Plane as two of these (UTF-16). Later versions are UTF-8. A control character becomes a space;
//! a line break in a name begins a new line of the label. So that `%%d` stays what it is and does not become a
//! degree sign, a zero-width non-joiner (U+200C) parts neighbouring percent signs in drawn texts; extended data hold
//! them as they are. Texts too long for the format end in `...`.

mod annotations;
mod blocks;
mod check;
mod drawing;
mod entity;
mod exporter;
mod file;
mod header;
mod joints;
mod layer;
mod objects;
mod openings;
mod pairs;
mod pole;
mod rooms;
mod symbols;
mod tables;
mod text;
mod version;
mod walls;

pub use exporter::exporter;

#[cfg(feature = "plugin")]
planform_sdk::export_plugin!(adapters: [], exporters: [exporter()]);
