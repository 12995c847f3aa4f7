/*
 * planform.h - the interface between planform and its plugins, version 1.
 *
 * A plugin is a shared library that exports one function, planform_plugin. It is given the host's table and returns
 * its own, a list of input adapters (they read documents) and exporters (they write layouts).
 *
 *  - Every struct begins with its size: set it to sizeof, and zero the rest that you do not use.
 *  - What is handed to a function or callback is valid until it returns; copy what you keep. Tables and the texts in
 *    them are valid for ever: libraries are never unloaded.
 *  - Lengths are metres in the map frame, x to the right, y up. Angles are radians, counter-clockwise.
 *  - A C++ exception must not leave your functions.
 */

#ifndef PLANFORM_H
#define PLANFORM_H

/* Made by cbindgen from plugins/sdk/src/abi/types.rs: change it there. */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

// The version of this interface. Another major version is another interface; a higher minor version has more fields
// at the end of some structs.
#define PLANFORM_ABI_MAJOR 1

// See PLANFORM_ABI_MAJOR.
#define PLANFORM_ABI_MINOR 3

// It did what it was asked.
#define PLANFORM_OK 0

// The document is damaged or is not what its format promises.
#define PLANFORM_BAD_INPUT 1

// The document is sound, but uses something that the plugin does not handle.
#define PLANFORM_UNSUPPORTED 2

// The document is larger than a limit allows.
#define PLANFORM_LIMIT 3

// An option has a value that cannot be used.
#define PLANFORM_BAD_OPTION 4

// The operating system refused to read or write.
#define PLANFORM_IO 5

// The plugin has a bug.
#define PLANFORM_PLUGIN_FAULT 6

// The flag of a plugin whose functions may be called from several threads at the same time.
#define PLANFORM_THREAD_SAFE 1

// The flag of a sink that makes use of the stages' pictures. Since version 1.1.
#define PLANFORM_WANTS_PICTURES 1

// What a PlanformOpening is: of a door's width. Since version 1.3.
#define PLANFORM_DOOR 0

// What a PlanformOpening is: wider than a door. Since version 1.3.
#define PLANFORM_PASSAGE 1

// What PlanformProblem.position counts: nothing, the problem has no place.
#define PLANFORM_NOWHERE 0

// What PlanformProblem.position counts: lines, from 1.
#define PLANFORM_LINE 1

// What PlanformProblem.position counts: bytes, from 0.
#define PLANFORM_BYTE 2

// How important a log message is: something that the user should know.
#define PLANFORM_LOG_WARNING 1

// How important a log message is: of interest to who looks for it.
#define PLANFORM_LOG_INFO 2

// What a PlanformValue is: there is none, or it is null.
#define PLANFORM_NOTHING 0

// What a PlanformValue is: true or false.
#define PLANFORM_FLAG 1

// What a PlanformValue is: a number.
#define PLANFORM_NUMBER 2

// What a PlanformValue is: a text.
#define PLANFORM_TEXT 3

// What a PlanformValue is: an array.
#define PLANFORM_ARRAY 4

// What a PlanformValue is: an object.
#define PLANFORM_OBJECT 5

// A value of a JSON document that planform has read: read it with the functions of PlanformHost, which all take NULL
// for a value that is not there.
typedef struct PlanformValue PlanformValue;

// Text in UTF-8. What planform hands to a plugin is followed by a zero byte, so that it can be used as a C string
// too; what a plugin hands over need not be. NULL is the empty text.
typedef struct PlanformString {
  // Its first byte.
  const char *data;
  // How many bytes it has, without the zero byte.
  size_t length;
} PlanformString;

// What planform offers to a plugin. Valid for ever.
typedef struct PlanformHost {
  // sizeof(PlanformHost), as planform was compiled.
  size_t size;
  // PLANFORM_ABI_MAJOR, as planform was compiled.
  uint32_t abi_major;
  // PLANFORM_ABI_MINOR, as planform was compiled.
  uint32_t abi_minor;
  // planform's own version.
  struct PlanformString version;
  // Tells the user something: PLANFORM_LOG_WARNING or PLANFORM_LOG_INFO, and one sentence.
  void (*log)(uint32_t level, struct PlanformString message);
  // What a value is: PLANFORM_NOTHING, PLANFORM_FLAG and so on.
  uint32_t (*kind)(const struct PlanformValue *value);
  // The member of an object by its name, a C string; NULL if there is none.
  const struct PlanformValue *(*member)(const struct PlanformValue *value, const char *name);
  // The element of an array, from 0; NULL if there is none.
  const struct PlanformValue *(*element)(const struct PlanformValue *value, size_t index);
  // How many elements an array has; 0 for everything else.
  size_t (*length)(const struct PlanformValue *value);
  // The number, or `otherwise` for everything that is not a number.
  double (*number)(const struct PlanformValue *value, double otherwise);
  // True or false, or `otherwise` for everything that is neither.
  bool (*flag)(const struct PlanformValue *value, bool otherwise);
  // The text, or a NULL text for everything that is not a text. Valid as long as the value.
  struct PlanformString (*text)(const struct PlanformValue *value);
} PlanformHost;

// What an adapter or exporter says of itself. Valid for ever; no text may be NULL unless it says so.
typedef struct PlanformInfo {
  // sizeof(PlanformInfo).
  size_t size;
  // Short name as the user types it: lower-case letters, digits and hyphens.
  const char *name;
  // One line for people.
  const char *description;
  // Version of the plugin.
  const char *version;
  // Licence as an SPDX expression.
  const char *licence;
  // File name extensions without the dot, lower case, the preferred one first; NULL ends the list. The list itself
  // may be NULL.
  const char *const *extensions;
  // Media types, the preferred one first; NULL ends the list. The list itself may be NULL.
  const char *const *media_types;
  // The options as a JSON Schema of an object, see `planform plugins schema options`; NULL for none.
  const char *options;
  // PLANFORM_THREAD_SAFE, or 0.
  uint64_t flags;
} PlanformInfo;

// What an adapter may look at to recognise a document. Valid until the call returns.
typedef struct PlanformProbe {
  // sizeof(PlanformProbe), as planform was compiled.
  size_t size;
  // To be handed to the callbacks.
  void *context;
  // The document's path as the system has it, in whatever encoding; empty for standard input.
  struct PlanformString path;
  // The first bytes: 4096 of them or the whole document, whichever is less.
  const uint8_t *head;
  // How many bytes `head` has.
  size_t head_length;
  // Takes what the adapter judged by, for the user's eyes: "a PNG by its first bytes".
  void (*reason)(void *context, struct PlanformString reason);
} PlanformProbe;

// How a call ended: PLANFORM_OK or what went wrong.
typedef int32_t PlanformStatus;

// Takes a file's bytes, which are valid during the call. `receiver` is what planform was given for it.
typedef void (*PlanformTake)(void *receiver, const uint8_t *bytes, size_t length);

// A document to be read. Valid until the call returns.
typedef struct PlanformSource {
  // sizeof(PlanformSource), as planform was compiled.
  size_t size;
  // To be handed to the callbacks.
  void *context;
  // The document's path as the system has it, in whatever encoding; empty for standard input.
  struct PlanformString path;
  // The whole document.
  const uint8_t *bytes;
  // How many bytes it has.
  size_t length;
  // The most bytes that a file that the document refers to may have.
  uint64_t byte_limit;
  // Reads a file that the document refers to, relative to the document's folder, and hands it to `take`. What went
  // wrong is remembered, so that the adapter can just return the status.
  PlanformStatus (*sibling)(void *context, struct PlanformString reference, PlanformTake take, void *receiver);
} PlanformSource;

// A JSON document, both as it is written and as values to be walked through. Valid until the call returns.
typedef struct PlanformJson {
  // sizeof(PlanformJson), as planform was compiled.
  size_t size;
  // The document in UTF-8.
  struct PlanformString text;
  // The same, read.
  const struct PlanformValue *value;
} PlanformJson;

// An occupancy grid, as ROS's nav_msgs/OccupancyGrid.
typedef struct PlanformGrid {
  // sizeof(PlanformGrid).
  size_t size;
  // Columns.
  uint32_t width;
  // Rows.
  uint32_t height;
  // Metres per cell.
  double resolution;
  // Where the outer corner of the lower left cell lies in the map frame: to the right, metres.
  double origin_x;
  // The same: up, metres.
  double origin_y;
  // By how much the grid is turned about that corner, radians counter-clockwise.
  double origin_yaw;
  // The cells row by row, the bottom row first, each from left to right: 0 (free) to 100 (occupied), -1 unknown.
  const int8_t *cells;
  // How many there are: width times height.
  size_t cell_count;
} PlanformGrid;

// A text that a document shows.
typedef struct PlanformText {
  // sizeof(PlanformText).
  size_t size;
  // What it says.
  struct PlanformString content;
  // The middle of its box in the map frame, metres to the right.
  double x;
  // The same, metres up.
  double y;
  // The reading direction, radians counter-clockwise from the x axis.
  double yaw;
  // Length along the reading direction, metres.
  double width;
  // Height of the box, metres.
  double height;
  // From 0 (a guess) to 1 (certain).
  double confidence;
} PlanformText;

// A leaf of a door as a plan draws it, in the map frame. No version changes it: it stands in arrays.
typedef struct PlanformDoorLeaf {
  // The point that it turns about: metres to the right.
  double hinge_x;
  // The same, metres up.
  double hinge_y;
  // Where its free end lies when it is closed: metres to the right.
  double closed_x;
  // The same, metres up.
  double closed_y;
  // Where its free end lies when it is as far open as drawn: metres to the right.
  double open_x;
  // The same, metres up.
  double open_y;
} PlanformDoorLeaf;

// A symbol that a document shows, such as a fire extinguisher or a door.
typedef struct PlanformSymbol {
  // sizeof(PlanformSymbol).
  size_t size;
  // What it means.
  struct PlanformString kind;
  // Its middle in the map frame, metres to the right.
  double x;
  // The same, metres up.
  double y;
  // Its direction, radians counter-clockwise from the x axis.
  double yaw;
  // Length along its direction, metres.
  double width;
  // Extent across its direction, metres.
  double height;
  // From 0 (a guess) to 1 (certain).
  double score;
  // The leaves of a door that swings, as drawn; may be NULL. Since version 1.1.
  const struct PlanformDoorLeaf *leaves;
  // How many there are. Since version 1.1.
  size_t leaf_count;
} PlanformSymbol;

// Where the map frame lies on the Earth.
typedef struct PlanformAnchor {
  // sizeof(PlanformAnchor).
  size_t size;
  // WGS 84 latitude of the point (x, y), degrees north.
  double latitude;
  // WGS 84 longitude of the point (x, y), degrees east.
  double longitude;
  // Direction of the map's y axis, degrees clockwise from true north.
  double bearing;
  // The point of the map frame that lies there, metres to the right.
  double x;
  // The same, metres up.
  double y;
} PlanformAnchor;

// What went wrong in a call.
typedef struct PlanformProblem {
  // sizeof(PlanformProblem).
  size_t size;
  // Who or what is at fault.
  PlanformStatus status;
  // What `position` counts: PLANFORM_NOWHERE, PLANFORM_LINE or PLANFORM_BYTE.
  uint32_t place;
  // Where in the document the fault lies.
  uint64_t position;
  // What was wrong, a sentence without its full stop. planform puts the document's name in front.
  struct PlanformString message;
  // What the user can do; NULL for no advice.
  struct PlanformString advice;
} PlanformProblem;

// How large a document shows the building. Since version 1.1.
typedef struct PlanformScale {
  // sizeof(PlanformScale).
  size_t size;
  // Length in the building of a pixel of the document, metres.
  double metres_per_pixel;
  // What it was found by, for the user's eyes: "written scale 1:100".
  struct PlanformString source;
  // From 0 (a guess) to 1 (certain).
  double confidence;
} PlanformScale;

// A stage of an adapter's work that is done, for who looks on. Since version 1.1.
typedef struct PlanformStage {
  // sizeof(PlanformStage).
  size_t size;
  // What it is called, in lower-case letters, digits and hyphens: "deskew".
  struct PlanformString name;
  // Columns of its picture.
  uint32_t width;
  // Rows of its picture.
  uint32_t height;
  // The picture: red, green and blue of each pixel, row by row from the top, each from left to right. NULL for none,
  // as when PLANFORM_WANTS_PICTURES is not set.
  const uint8_t *rgb;
  // How many bytes there are: three times width times height.
  size_t rgb_length;
} PlanformStage;

// An opening between two rooms that a document states, metres in the map frame. Since version 1.3.
typedef struct PlanformOpening {
  // One end, in the middle of the wall.
  double from_x;
  // The same, up.
  double from_y;
  // The other end.
  double to_x;
  // The same, up.
  double to_y;
  // Thickness of the wall, metres; 0 where the rooms' floors meet, less where it is not stated.
  double depth;
  // PLANFORM_DOOR or PLANFORM_PASSAGE.
  uint32_t kind;
} PlanformOpening;

// Takes what an adapter finds in a document. Valid until the call returns. A callback copies what it is given; one
// that does not return PLANFORM_OK has refused it, and the adapter should give up and return that status.
typedef struct PlanformSceneSink {
  // sizeof(PlanformSceneSink), as planform was compiled.
  size_t size;
  // To be handed to the callbacks.
  void *context;
  // Takes the grid. Every scene has exactly one.
  PlanformStatus (*grid)(void *context, const struct PlanformGrid *grid);
  // Takes one text; to be called for each.
  PlanformStatus (*text)(void *context, const struct PlanformText *text);
  // Takes one symbol; to be called for each.
  PlanformStatus (*symbol)(void *context, const struct PlanformSymbol *symbol);
  // Takes the place on the Earth, if the document tells it.
  PlanformStatus (*anchor)(void *context, const struct PlanformAnchor *anchor);
  // Takes a sentence that the user should read; to be called for each.
  PlanformStatus (*warning)(void *context, struct PlanformString warning);
  // Takes the document's name and the adapter's, if they are others than planform knows already.
  PlanformStatus (*provenance)(void *context, struct PlanformString source, struct PlanformString adapter);
  // Takes what went wrong and returns its status, for the adapter to return.
  PlanformStatus (*fail)(void *context, const struct PlanformProblem *problem);
  // Takes the scale of a document whose cells were not measured, such as a plan. Since version 1.1: only there if
  // `size` says so.
  PlanformStatus (*scale)(void *context, const struct PlanformScale *scale);
  // PLANFORM_WANTS_PICTURES, or 0. Since version 1.1.
  uint64_t flags;
  // Takes a stage of the work when it is done; to be called for each, or never. Since version 1.1: only there if
  // `size` says so.
  PlanformStatus (*stage)(void *context, const struct PlanformStage *stage);
  // Takes all openings between rooms, if the document states them; to be called once, or never. With a count of 0
  // there are none. Since version 1.3: only there if `size` says so.
  PlanformStatus (*openings)(void *context, const struct PlanformOpening *openings, size_t count);
} PlanformSceneSink;

// Reads one family of document formats. Valid for ever.
typedef struct PlanformAdapter {
  // sizeof(PlanformAdapter).
  size_t size;
  // Name, extensions, options.
  const struct PlanformInfo *info;
  // The plugin's own; planform does not look at it.
  void *data;
  // How sure the adapter is that the document is its own, 0 (surely not) to 100. Must be quick and must accept any
  // bytes. A negative number says that it failed, and `reason` then takes why.
  int32_t (*probe)(const struct PlanformAdapter *adapter, const struct PlanformProbe *probe);
  // Reads the document into the sink. `options` are values that fit the schema, defaults filled in.
  PlanformStatus (*read)(const struct PlanformAdapter *adapter,
                         const struct PlanformSource *source,
                         const struct PlanformJson *options,
                         const struct PlanformSceneSink *sink);
} PlanformAdapter;

// What an exporter writes. Valid until the call returns.
typedef struct PlanformDocument {
  // sizeof(PlanformDocument), as planform was compiled.
  size_t size;
  // The layout, see `planform plugins schema layout`.
  const struct PlanformJson *layout;
  // The grid that it was reconstructed from, or NULL.
  const struct PlanformGrid *grid;
  // What else the scene holds, see `planform plugins schema scene`; NULL when `grid` is.
  const struct PlanformJson *scene;
} PlanformDocument;

// Takes an output. Valid until the call returns.
typedef struct PlanformOutput {
  // sizeof(PlanformOutput), as planform was compiled.
  size_t size;
  // To be handed to the callbacks.
  void *context;
  // Takes the next bytes of the file. When it does not return PLANFORM_OK, the exporter should give up and return
  // that status.
  PlanformStatus (*write)(void *context, const uint8_t *bytes, size_t length);
  // Takes what went wrong and returns its status, for the exporter to return.
  PlanformStatus (*fail)(void *context, const struct PlanformProblem *problem);
  // The file's name up to its extension, for what refers to its companions. Since version 1.2: only there if `size`
  // says so.
  struct PlanformString stem;
  // Its extension without the dot, as the user typed it; empty for what is no file. Since version 1.2: only there if
  // `size` says so.
  struct PlanformString extension;
  // Takes the next bytes of a companion, by its place in PlanformExporter.companions from 0; otherwise as `write`.
  // Since version 1.2: only there if `size` says so.
  PlanformStatus (*companion)(void *context, size_t number, const uint8_t *bytes, size_t length);
} PlanformOutput;

// Writes layouts in one format. Valid for ever.
typedef struct PlanformExporter {
  // sizeof(PlanformExporter).
  size_t size;
  // Name, extensions, options.
  const struct PlanformInfo *info;
  // The plugin's own; planform does not look at it.
  void *data;
  // Writes the document to the output. `options` are values that fit the schema, defaults filled in. The same
  // document and options must give the same bytes, always.
  PlanformStatus (*write)(const struct PlanformExporter *exporter,
                          const struct PlanformDocument *document,
                          const struct PlanformJson *options,
                          const struct PlanformOutput *output);
  // The extensions of the files that lie beside a document of this format, without the dot, lower case: the
  // companion "pgm" of map.yaml is map.pgm. NULL ends the list. The list itself may be NULL, and most are. Since
  // version 1.2.
  const char *const *companions;
} PlanformExporter;

// What a plugin library offers. Valid for ever.
typedef struct PlanformPlugin {
  // sizeof(PlanformPlugin).
  size_t size;
  // PLANFORM_ABI_MAJOR, as the plugin was compiled.
  uint32_t abi_major;
  // PLANFORM_ABI_MINOR, as the plugin was compiled.
  uint32_t abi_minor;
  // Its input adapters; NULL ends the list. The list itself may be NULL.
  const struct PlanformAdapter *const *adapters;
  // Its exporters; NULL ends the list. The list itself may be NULL.
  const struct PlanformExporter *const *exporters;
} PlanformPlugin;

// The one function that a plugin library exports, under the name `planform_plugin`. Called once, before anything
// else; NULL says that the plugin does not work with this host.
typedef const struct PlanformPlugin *(*PlanformEntry)(const struct PlanformHost *host);

/* Exported by every plugin; called once, before anything else. */
#ifdef __cplusplus
extern "C"
#endif
#ifdef _WIN32
__declspec(dllexport)
#else
__attribute__((visibility("default")))
#endif
const PlanformPlugin *planform_plugin(const PlanformHost *host);

/* A C string as a PlanformString. NULL is the empty text. */
static inline PlanformString planform_string(const char *text) {
  PlanformString string;
  string.data = text;
  string.length = text ? strlen(text) : 0;
  return string;
}

/* The problem to hand to `fail`. `line` counts from 1, 0 for no line; `advice` may be NULL. */
static inline PlanformProblem planform_problem(PlanformStatus status, uint64_t line, const char *message,
                                               const char *advice) {
  PlanformProblem problem;
  problem.size = sizeof problem;
  problem.status = status;
  problem.place = line ? PLANFORM_LINE : PLANFORM_NOWHERE;
  problem.position = line;
  problem.message = planform_string(message);
  problem.advice = planform_string(advice);
  return problem;
}

#endif /* PLANFORM_H */
