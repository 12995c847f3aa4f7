/*
 * Reads plans that are drawn with characters: '#' is a wall, '.' or a space is free floor, '?' is unknown, one line of
 * text for each row of the plan, the first one on top. planform.h tells what all the structs mean.
 */

#include "planform.h"

#include <stdio.h>
#include <stdlib.h>

/* The plugin's name, and the extension of its files. */
#define NAME "{{name}}"

/* planform takes no larger grids. */
#define MAX_SIDE 65536
#define MAX_CELLS ((size_t)1 << 27)

/* No cell: the character means nothing in a plan. */
#define STRANGER (-2)

static const PlanformHost *host;

/* What a character stands for: 100 occupied, 0 free, -1 unknown. */
static int cell(uint8_t byte) {
  switch (byte) {
  case '#': return 100;
  case '.':
  case ' ': return 0;
  case '?': return -1;
  default: return STRANGER;
  }
}

/* A row of the plan, without its line's end. */
struct row {
  const uint8_t *bytes;
  size_t length;
};

/* Takes the next row off the text, which must not be empty. */
static struct row next_row(const uint8_t **text, size_t *left) {
  const uint8_t *end = memchr(*text, '\n', *left);
  struct row row = {*text, end ? (size_t)(end - *text) : *left};
  size_t taken = row.length + (end ? 1 : 0);
  *text += taken;
  *left -= taken;
  if (row.length > 0 && row.bytes[row.length - 1] == '\r') { /* Lines end so on Windows. */
    row.length--;
  }
  return row;
}

static uint8_t lower(uint8_t byte) { return byte >= 'A' && byte <= 'Z' ? (uint8_t)(byte + 32) : byte; }

/* Paths need not be UTF-8, and there is none for standard input. */
static bool has_our_extension(PlanformString path) {
  size_t length = strlen("." NAME);
  if (path.length < length) {
    return false;
  }
  for (size_t i = 0; i < length; i++) {
    if (lower((uint8_t)path.data[path.length - length + i]) != (uint8_t)("." NAME)[i]) {
      return false;
    }
  }
  return true;
}

static bool is_drawn(const uint8_t *bytes, size_t length) {
  for (size_t i = 0; i < length; i++) {
    if (cell(bytes[i]) == STRANGER && bytes[i] != '\n' && bytes[i] != '\r') {
      return false;
    }
  }
  return length > 0 && memchr(bytes, '#', length);
}

/* Every adapter is asked, of every document, and the surest one reads it. So do not claim what may be another's. */
static int32_t probe(const PlanformAdapter *adapter, const PlanformProbe *asked) {
  bool named = has_our_extension(asked->path);
  bool drawn = is_drawn(asked->head, asked->head_length);
  (void)adapter;
  if (named && drawn) {
    asked->reason(asked->context, planform_string("a plan by its name and its characters"));
    return 90;
  }
  if (named) { /* Ours, though damaged: `read` can say in which line. */
    asked->reason(asked->context, planform_string("a plan by its name alone"));
    return 20;
  }
  if (drawn) {
    asked->reason(asked->context, planform_string("a plan by its characters"));
    return 40;
  }
  return 0;
}

/* Tells planform, and so the user, what is wrong. What it returns is to be returned by `read`. */
static PlanformStatus fail(const PlanformSceneSink *sink, PlanformStatus status, size_t line, const char *message,
                           const char *advice) {
  PlanformProblem problem = planform_problem(status, line, message, advice);
  return sink->fail(sink->context, &problem);
}

static PlanformStatus fail_stranger(const PlanformSceneSink *sink, size_t line, size_t column, uint8_t byte) {
  char message[96];
  const char *format = byte > 0x20 && byte < 0x7f ? "column %zu holds `%c`, which means nothing in a plan"
                                                  : "column %zu holds `\\x%02x`, which means nothing in a plan";
  snprintf(message, sizeof message, format, column, (unsigned)byte);
  return fail(sink, PLANFORM_BAD_INPUT, line, message, "draw with `#` (wall), `.` or a space (free) and `?` (unknown)");
}

/* Finds how many rows there are and how long the longest is, and checks every character. */
static PlanformStatus measure(const PlanformSource *source, const PlanformSceneSink *sink, size_t *width,
                              size_t *height) {
  const uint8_t *text = source->bytes;
  size_t left = source->length;
  *width = *height = 0;
  while (left > 0) {
    struct row row = next_row(&text, &left);
    ++*height;
    for (size_t i = 0; i < row.length; i++) {
      if (cell(row.bytes[i]) == STRANGER) {
        return fail_stranger(sink, *height, i + 1, row.bytes[i]);
      }
    }
    *width = row.length > *width ? row.length : *width;
  }
  return PLANFORM_OK;
}

/* Fills in the cells. A grid's rows go from the bottom up, those of a text from the top down. */
static void fill(int8_t *cells, size_t width, size_t height, const PlanformSource *source) {
  const uint8_t *text = source->bytes;
  size_t left = source->length;
  memset(cells, -1, width * height); /* Nothing is drawn to the right of a line's end. */
  for (size_t line = 0; line < height; line++) {
    struct row row = next_row(&text, &left);
    int8_t *to = cells + (height - 1 - line) * width;
    for (size_t i = 0; i < row.length; i++) {
      to[i] = (int8_t)cell(row.bytes[i]);
    }
  }
}

static PlanformStatus read_plan(const PlanformAdapter *adapter, const PlanformSource *source,
                                const PlanformJson *options, const PlanformSceneSink *sink) {
  size_t width, height;
  PlanformStatus status = measure(source, sink, &width, &height);
  (void)adapter;
  if (status != PLANFORM_OK) {
    return status;
  }
  if (width == 0) {
    return fail(sink, PLANFORM_BAD_INPUT, 0, "the plan is empty", NULL);
  }
  /* Before memory is taken: one long line among many short ones makes a huge grid of a small file. */
  if (width > MAX_SIDE || height > MAX_SIDE || width > MAX_CELLS / height) {
    return fail(sink, PLANFORM_LIMIT, 0, "the plan is too large", "cut it into parts");
  }
  int8_t *cells = malloc(width * height);
  if (!cells) {
    return fail(sink, PLANFORM_LIMIT, 0, "there is not enough memory for the plan", NULL);
  }
  fill(cells, width, height, source);

  /* The plan does not say where it lies, so its lower left corner is the origin of the map frame. */
  PlanformGrid grid = {.size = sizeof grid, .width = (uint32_t)width, .height = (uint32_t)height};
  grid.resolution = host->number(host->member(options->value, "resolution"), 0.1);
  grid.cells = cells;
  grid.cell_count = width * height;
  status = sink->grid(sink->context, &grid);
  free(cells); /* planform has copied them. */
  return status;
}

static const char *const extensions[] = {NAME, NULL};
static const char *const media_types[] = {"text/plain", NULL};

/* The bounds are such that every grid keeps to them: planform checks the user's value before `read_plan` sees it. */
static const char options_schema[] =
    "{\"type\": \"object\", \"properties\": {\"resolution\": {\"type\": \"number\", \"minimum\": 0.001,"
    " \"maximum\": 1000, \"default\": 0.1, \"description\": \"metres per character\"}}}";

static const PlanformInfo info = {
    .size = sizeof info,
    .name = NAME,
    .description = "Plans drawn with characters",
    .version = "0.1.0",
    .licence = "MIT",
    .extensions = extensions,
    .media_types = media_types,
    .options = options_schema,
    /* `host` is set once, before any other call, and nothing else is ever changed. */
    .flags = PLANFORM_THREAD_SAFE,
};

static const PlanformAdapter adapter = {.size = sizeof adapter, .info = &info, .probe = probe, .read = read_plan};
static const PlanformAdapter *const adapters[] = {&adapter, NULL};

static const PlanformPlugin plugin = {
    .size = sizeof plugin,
    .abi_major = PLANFORM_ABI_MAJOR,
    .abi_minor = PLANFORM_ABI_MINOR,
    .adapters = adapters,
};

/* What planform calls when it has loaded the library. */
const PlanformPlugin *planform_plugin(const PlanformHost *given) {
  if (given->abi_major != PLANFORM_ABI_MAJOR || given->size < sizeof *given) {
    return NULL; /* Made for another planform. */
  }
  host = given;
  return &plugin;
}
