/*
 * Writes a table of the rooms in CSV (RFC 4180): number, name, area, centre, and how many doors lead out. planform.h
 * tells what all the structs mean, and planform's docs/plugins.md what a layout holds.
 */

#include "planform.h"

#include <math.h>
#include <stdio.h>

/* The plugin's name, and the extension of its files. */
#define NAME "{{name}}"

/* planform's functions to walk through a layout. All of them take NULL for what is not there. */
static const PlanformHost *host;

/* The file being written. After a failed write nothing more is written, so that it need be asked for only once. */
struct file {
  const PlanformOutput *output;
  PlanformStatus status;
  char separator;
};

static void put(struct file *file, const char *bytes, size_t length) {
  if (file->status == PLANFORM_OK && length > 0) {
    file->status = file->output->write(file->output->context, (const uint8_t *)bytes, length);
  }
}

static void put_separator(struct file *file) { put(file, &file->separator, 1); }

static void put_number(struct file *file, double value, int decimals) {
  char text[400]; /* The longest double has 309 digits before its point. */
  int length = snprintf(text, sizeof text, "%.*f", decimals, value);
  put(file, text, (size_t)length);
}

/* To a hundredth, without "-0.00". */
static void put_hundredths(struct file *file, double value) {
  put_number(file, round(value * 100) / 100 + 0.0, 2);
}

/* Quotes a text if it has to be, its own quotes doubled. Texts may hold any byte, zero too. */
static void put_text(struct file *file, PlanformString text) {
  bool quoted = false;
  for (size_t i = 0; i < text.length; i++) {
    char c = text.data[i];
    quoted = quoted || c == '"' || c == '\n' || c == '\r' || c == file->separator;
  }
  if (!quoted) {
    put(file, text.data, text.length);
    return;
  }
  put(file, "\"", 1);
  for (size_t i = 0; i < text.length; i++) {
    put(file, "\"\"", text.data[i] == '"' ? 1 : 0);
    put(file, &text.data[i], 1);
  }
  put(file, "\"", 1);
}

static bool is_text(const PlanformValue *value, const char *word) {
  PlanformString text = host->text(value);
  return text.length == strlen(word) && memcmp(text.data, word, text.length) == 0;
}

/* Points are arrays [x, y]. */
struct point {
  double x, y;
};

static struct point point(const PlanformValue *value) {
  struct point point = {host->number(host->element(value, 0), 0), host->number(host->element(value, 1), 0)};
  return point;
}

/* Sums of the shoelace formula. */
struct sums {
  double area, x, y;
};

/* Adds a ring. `o` is a point of the room: far from the origin the products would lose digits. */
static void add_ring(struct sums *sums, const PlanformValue *ring, struct point o) {
  size_t count = host->length(ring);
  for (size_t i = 0; i < count; i++) {
    struct point a = point(host->element(ring, i)), b = point(host->element(ring, (i + 1) % count));
    double ax = a.x - o.x, ay = a.y - o.y, bx = b.x - o.x, by = b.y - o.y;
    double cross = ax * by - bx * ay;
    sums->area += cross / 2;
    sums->x += (ax + bx) * cross / 6;
    sums->y += (ay + by) * cross / 6;
  }
}

/* Writes the area of a floor in square metres, and its centroid. */
static void put_area_and_centre(struct file *file, const PlanformValue *floor) {
  const PlanformValue *exterior = host->member(floor, "exterior"), *holes = host->member(floor, "holes");
  struct point o = point(host->element(exterior, 0));
  struct sums sums = {0, 0, 0};
  add_ring(&sums, exterior, o);
  /* Holes run against the exterior, so they count as less than nothing. */
  for (size_t i = 0; i < host->length(holes); i++) {
    add_ring(&sums, host->element(holes, i), o);
  }
  put_hundredths(file, sums.area);
  put_separator(file);
  put_hundredths(file, sums.area == 0 ? o.x : o.x + sums.x / sums.area);
  put_separator(file);
  put_hundredths(file, sums.area == 0 ? o.y : o.y + sums.y / sums.area);
}

static size_t doors(const PlanformValue *layout, double room) {
  const PlanformValue *openings = host->member(layout, "openings");
  size_t count = 0;
  for (size_t i = 0; i < host->length(openings); i++) {
    const PlanformValue *opening = host->element(openings, i), *rooms = host->member(opening, "rooms");
    bool leads = host->number(host->element(rooms, 0), 0) == room || host->number(host->element(rooms, 1), 0) == room;
    count += leads && is_text(host->member(opening, "kind"), "door") ? 1 : 0;
  }
  return count;
}

static void put_room(struct file *file, const PlanformValue *layout, const PlanformValue *room) {
  double id = host->number(host->member(room, "id"), 0);
  put_number(file, id, 0);
  put_separator(file);
  put_text(file, host->text(host->member(room, "name")));
  put_separator(file);
  put_area_and_centre(file, host->member(room, "inner"));
  put_separator(file);
  put_number(file, (double)doors(layout, id), 0);
  put(file, "\n", 1);
}

static void put_header(struct file *file) {
  static const char *const columns[] = {"id", "name", "area_m2", "centre_x_m", "centre_y_m", "doors"};
  for (size_t i = 0; i < sizeof columns / sizeof *columns; i++) {
    put(file, &file->separator, i > 0 ? 1 : 0);
    put(file, columns[i], strlen(columns[i]));
  }
  put(file, "\n", 1);
}

static char separator(const PlanformJson *options) {
  const PlanformValue *chosen = host->member(options->value, "separator");
  return is_text(chosen, "semicolon") ? ';' : is_text(chosen, "tab") ? '\t' : ',';
}

/* Writes the whole file. When it does not return PLANFORM_OK, planform keeps nothing of the file. */
static PlanformStatus write_table(const PlanformExporter *exporter, const PlanformDocument *document,
                                  const PlanformJson *options, const PlanformOutput *output) {
  struct file file = {output, PLANFORM_OK, separator(options)};
  const PlanformValue *layout = document->layout->value, *rooms = host->member(layout, "rooms");
  (void)exporter;
  put_header(&file);
  for (size_t i = 0; i < host->length(rooms) && file.status == PLANFORM_OK; i++) {
    put_room(&file, layout, host->element(rooms, i));
  }
  return file.status;
}

static const char *const extensions[] = {NAME, NULL};
static const char *const media_types[] = {"text/csv", NULL};

static const char options_schema[] =
    "{\"type\": \"object\", \"properties\": {\"separator\": {\"type\": \"string\", \"enum\": [\"comma\", \"semicolon\","
    " \"tab\"], \"default\": \"comma\", \"description\": \"what stands between two columns; some spreadsheets want a"
    " semicolon\"}}}";

static const PlanformInfo info = {
    .size = sizeof info,
    .name = NAME,
    .description = "A table of the rooms",
    .version = "0.1.0",
    .licence = "MIT",
    .extensions = extensions,
    .media_types = media_types,
    .options = options_schema,
    /* `host` is set once, before any other call, and nothing else is ever changed. */
    .flags = PLANFORM_THREAD_SAFE,
};

static const PlanformExporter exporter = {.size = sizeof exporter, .info = &info, .write = write_table};
static const PlanformExporter *const exporters[] = {&exporter, NULL};

static const PlanformPlugin plugin = {
    .size = sizeof plugin,
    .abi_major = PLANFORM_ABI_MAJOR,
    .abi_minor = PLANFORM_ABI_MINOR,
    .exporters = exporters,
};

/* What planform calls when it has loaded the library. */
const PlanformPlugin *planform_plugin(const PlanformHost *given) {
  if (given->abi_major != PLANFORM_ABI_MAJOR || given->size < sizeof *given) {
    return NULL; /* Made for another planform. */
  }
  host = given;
  return &plugin;
}
