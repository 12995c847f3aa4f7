/*
 * Reads the maps of the MovingAI pathfinding benchmarks (movingai.com/benchmarks/formats.html) into planform.
 *
 * A map is a text: a header of `type octile`, `height H`, `width W` and `map`, each on a line of its own, then H rows
 * of W characters, the top row first. It is read in three steps: the header; all rows, to see that each is there and
 * means something; and only then, with memory for as many cells as there really are, the rows once more.
 */

#include <planform.h>

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

/* The largest grid that planform takes. */
#define MAX_CELLS (UINT64_C(1) << 27)
#define MAX_SIDE UINT64_C(65536)

#define FREE 0
#define OBSTACLE 100
#define UNKNOWN (-1)
#define MEANINGLESS (-2)

/* What planform offers, as handed to planform_plugin. Written once, before anything else is called. */
static const PlanformHost *host;

/* ---- Faults ---- */

/* Why a document cannot be read. */
typedef struct Fault {
  PlanformStatus status;
  uint64_t line; /* From 1; 0 for no line. */
  char message[160];
  const char *advice; /* NULL for none. */
} Fault;

/* Notes what is wrong. Returns false, for the caller to return. */
static bool refuse(Fault *fault, PlanformStatus status, uint64_t line, const char *advice, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(fault->message, sizeof fault->message, format, arguments);
  va_end(arguments);
  fault->status = status;
  fault->line = line;
  fault->advice = advice;
  return false;
}

/* ---- Lines ---- */

/* The rest of a text. */
typedef struct Reader {
  const uint8_t *at;
  const uint8_t *end;
  uint64_t line; /* Number of the last line read, from 1. */
} Reader;

/* A line without its end, be that a line feed, or a carriage return and a line feed. Not followed by a zero byte. */
typedef struct Line {
  const uint8_t *text;
  size_t length;
} Line;

static Reader read_from(const uint8_t *bytes, size_t length) {
  Reader reader = {bytes, bytes, 0};
  if (length > 0) /* `bytes` may be NULL when there are none, and nothing may be added to NULL. */
    reader.end = bytes + length;
  if (length >= 3 && memcmp(bytes, "\xEF\xBB\xBF", 3) == 0)
    reader.at += 3; /* The byte order mark that some editors put in front. */
  return reader;
}

/* Reads the next line; false at the end of the text. */
static bool next_line(Reader *reader, Line *line) {
  if (reader->at == reader->end)
    return false;
  const uint8_t *feed = memchr(reader->at, '\n', (size_t)(reader->end - reader->at));
  const uint8_t *end = feed ? feed : reader->end;
  line->text = reader->at;
  line->length = (size_t)(end - reader->at);
  if (line->length > 0 && end[-1] == '\r')
    line->length--;
  reader->at = feed ? feed + 1 : end;
  reader->line++;
  return true;
}

static bool is_blank(uint8_t c) { return c == ' ' || c == '\t'; }

/* Takes the next word off the line's front; an empty word at its end. */
static Line next_word(Line *line) {
  size_t start = 0;
  while (start < line->length && is_blank(line->text[start]))
    start++;
  size_t end = start;
  while (end < line->length && !is_blank(line->text[end]))
    end++;
  Line word = {line->text + start, end - start};
  line->text += end;
  line->length -= end;
  return word;
}

static bool is_word(Line word, const char *expected) {
  return word.length == strlen(expected) && memcmp(word.text, expected, word.length) == 0;
}

/* ---- The header ---- */

typedef struct Header {
  uint64_t width;  /* 0 until it is read. */
  uint64_t height; /* 0 until it is read. */
  bool typed;
} Header;

/* The number that a word of digits stands for, stopping at the first that is too large; 0 for all other words. */
static uint64_t number_of(Line word) {
  uint64_t number = 0;
  for (size_t i = 0; i < word.length && number <= MAX_SIDE; i++) {
    if (word.text[i] < '0' || word.text[i] > '9')
      return 0;
    number = number * 10 + (uint64_t)(word.text[i] - '0');
  }
  return number;
}

static bool read_type(Header *header, Line value, uint64_t line, Fault *fault) {
  if (header->typed)
    return refuse(fault, PLANFORM_BAD_INPUT, line, NULL, "`type` is there twice");
  /* Both are grids of squares, and differ in the moves that they allow. */
  if (!is_word(value, "octile") && !is_word(value, "tile"))
    return refuse(fault, PLANFORM_UNSUPPORTED, line, "convert it to a map of type octile",
                  "the type is neither octile nor tile");
  header->typed = true;
  return true;
}

static bool read_side(const char *name, uint64_t *side, Line value, uint64_t line, Fault *fault) {
  if (*side != 0)
    return refuse(fault, PLANFORM_BAD_INPUT, line, NULL, "`%s` is there twice", name);
  *side = number_of(value);
  if (*side == 0)
    return refuse(fault, PLANFORM_BAD_INPUT, line, "give a whole number from 1, such as `height 512`",
                  "`%s` has no whole number from 1", name);
  if (*side > MAX_SIDE)
    return refuse(fault, PLANFORM_LIMIT, line, "cut the map into smaller ones",
                  "`%s` is more than the %u cells that a side may have", name, (unsigned)MAX_SIDE);
  return true;
}

static bool read_field(Header *header, Line line, uint64_t number, Fault *fault) {
  Line key = next_word(&line);
  Line value = next_word(&line);
  if (next_word(&line).length == 0) {
    if (is_word(key, "type"))
      return read_type(header, value, number, fault);
    if (is_word(key, "height"))
      return read_side("height", &header->height, value, number, fault);
    if (is_word(key, "width"))
      return read_side("width", &header->width, value, number, fault);
  }
  return refuse(fault, PLANFORM_BAD_INPUT, number, "a map begins with the lines `type octile`, `height H`, "
                "`width W` and `map`", "this is no line of a MovingAI map's header");
}

/* Whether all that the header must say was there when its last line, `map`, came. */
static bool check_header(const Header *header, uint64_t line, Fault *fault) {
  const char *missing = !header->typed ? "type" : header->height == 0 ? "height" : header->width == 0 ? "width" : NULL;
  if (missing)
    return refuse(fault, PLANFORM_BAD_INPUT, line, "add it above the line `map`", "`%s` is missing", missing);
  if (header->width * header->height > MAX_CELLS)
    return refuse(fault, PLANFORM_LIMIT, line, "cut the map into smaller ones",
                  "the map has more than the %lu cells that a map may have", (unsigned long)MAX_CELLS);
  return true;
}

/* Reads the header and its last line, `map`. */
static bool read_header(Reader *reader, Header *header, Fault *fault) {
  Line line;
  while (next_line(reader, &line)) {
    Line rest = line;
    if (is_word(next_word(&rest), "map") && next_word(&rest).length == 0)
      return check_header(header, reader->line, fault);
    if (!read_field(header, line, reader->line, fault))
      return false;
  }
  return refuse(fault, PLANFORM_BAD_INPUT, reader->line, "a map begins with the lines `type octile`, `height H`, "
                "`width W` and `map`", "the document ends before the line `map`");
}

/* ---- The rows ---- */

/* What the user chose for the characters that may mean several things. */
typedef struct Legend {
  int8_t out_of_bounds;
  int8_t water;
} Legend;

static int8_t meaning(uint8_t character, const Legend *legend) {
  switch (character) {
  case '.': /* Passable. */
  case 'G': /* Passable. */
  case 'S': /* Swamp: passable from regular terrain. */
    return FREE;
  case 'T': /* Trees. */
    return OBSTACLE;
  case '@':
  case 'O':
    return legend->out_of_bounds;
  case 'W': /* Water: passable, but not from regular terrain. */
    return legend->water;
  default:
    return MEANINGLESS;
  }
}

static bool check_row(Line row, const Header *header, const Legend *legend, uint64_t line, Fault *fault) {
  for (size_t i = 0; i < row.length; i++) {
    uint8_t character = row.text[i];
    if (meaning(character, legend) == MEANINGLESS)
      return refuse(fault, PLANFORM_BAD_INPUT, line, "a row is made of the characters . G @ O T S W",
                    character > ' ' && character < 127 ? "column %lu has the character `%c`, which means nothing"
                                                       : "column %lu has the byte 0x%02X, which means nothing",
                    (unsigned long)(i + 1), (unsigned)character);
  }
  if (row.length != header->width)
    return refuse(fault, PLANFORM_BAD_INPUT, line, "make the row as long as the header's `width`",
                  "the row has %lu characters where the header says %lu", (unsigned long)row.length,
                  (unsigned long)header->width);
  return true;
}

/* Whether there are as many rows as the header says, each as it should be, and nothing after them. */
static bool check_rows(Reader reader, const Header *header, const Legend *legend, Fault *fault) {
  Line row;
  for (uint64_t i = 0; i < header->height; i++) {
    if (!next_line(&reader, &row))
      return refuse(fault, PLANFORM_BAD_INPUT, reader.line, "the document may be cut short",
                    "the document ends after %lu of %lu rows", (unsigned long)i, (unsigned long)header->height);
    if (!check_row(row, header, legend, reader.line, fault))
      return false;
  }
  while (next_line(&reader, &row)) {
    if (next_word(&row).length != 0)
      return refuse(fault, PLANFORM_BAD_INPUT, reader.line, "make `height` the number of rows",
                    "there is more than the %lu rows that the header says", (unsigned long)header->height);
  }
  return true;
}

/* The cells of rows that are checked already, the bottom row first; to be freed. NULL if there is no memory. */
static int8_t *read_cells(Reader reader, const Header *header, const Legend *legend) {
  size_t width = (size_t)header->width;
  int8_t *cells = malloc(width * (size_t)header->height);
  if (!cells)
    return NULL;
  Line row;
  for (size_t i = (size_t)header->height; i > 0 && next_line(&reader, &row); i--) {
    int8_t *target = cells + (i - 1) * width;
    for (size_t column = 0; column < width; column++)
      target[column] = meaning(row.text[column], legend);
  }
  return cells;
}

/* ---- The adapter ---- */

/* Whether an option of words has this one. */
static bool is_chosen(const PlanformJson *options, const char *option, const char *word) {
  PlanformString text = host->text(host->member(options->value, option));
  return text.length == strlen(word) && memcmp(text.data, word, text.length) == 0;
}

static PlanformStatus fail(const PlanformSceneSink *sink, const Fault *fault) {
  PlanformProblem problem = planform_problem(fault->status, fault->line, fault->message, fault->advice);
  return sink->fail(sink->context, &problem);
}

static PlanformStatus hand_over(const PlanformSceneSink *sink, const Header *header, double resolution,
                                const int8_t *cells) {
  PlanformGrid grid = {0};
  grid.size = sizeof grid;
  grid.width = (uint32_t)header->width;
  grid.height = (uint32_t)header->height;
  grid.resolution = resolution;
  grid.cells = cells;
  grid.cell_count = (size_t)(header->width * header->height);
  return sink->grid(sink->context, &grid);
}

static PlanformStatus read_map(const PlanformAdapter *adapter, const PlanformSource *source,
                               const PlanformJson *options, const PlanformSceneSink *sink) {
  (void)adapter;
  Legend legend = {is_chosen(options, "out-of-bounds", "unknown") ? UNKNOWN : OBSTACLE,
                   is_chosen(options, "water", "free") ? FREE : OBSTACLE};
  Fault fault = {0};
  Header header = {0};
  Reader reader = read_from(source->bytes, source->length);
  if (!read_header(&reader, &header, &fault) || !check_rows(reader, &header, &legend, &fault))
    return fail(sink, &fault);
  int8_t *cells = read_cells(reader, &header, &legend);
  if (!cells) {
    refuse(&fault, PLANFORM_LIMIT, 0, "cut the map into smaller ones", "there is no memory for the map's cells");
    return fail(sink, &fault);
  }
  double resolution = host->number(host->member(options->value, "resolution"), 0.2);
  PlanformStatus status = hand_over(sink, &header, resolution, cells);
  free(cells);
  return status;
}

static int32_t sure(const PlanformProbe *probe, int32_t percent, const char *reason) {
  probe->reason(probe->context, planform_string(reason));
  return percent;
}

static bool is_named_map(PlanformString path) {
  return path.length >= 4 && memcmp(path.data + path.length - 4, ".map", 4) == 0;
}

static int32_t probe_map(const PlanformAdapter *adapter, const PlanformProbe *probe) {
  (void)adapter;
  Fault fault = {0};
  Header header = {0};
  Reader reader = read_from(probe->head, probe->head_length);
  if (read_header(&reader, &header, &fault))
    return sure(probe, 95, "a MovingAI map by its header");
  /* Damaged, but ours: the one who opens it should hear what is wrong with it. */
  if (header.typed)
    return sure(probe, 80, "a MovingAI map by its type, though its header is damaged");
  return is_named_map(probe->path) ? sure(probe, 5, "a MovingAI map by its name, though not by its header") : 0;
}

/* ---- The tables ---- */

static const char *const extensions[] = {"map", NULL};

static const char options_schema[] =
    "{\"type\": \"object\", \"properties\": {"
    "\"resolution\": {\"type\": \"number\", \"minimum\": 0.0001, \"maximum\": 1000, \"default\": 0.2,"
    " \"description\": \"metres per cell; the format does not say, and a wall of one cell should be a wall\"},"
    "\"out-of-bounds\": {\"type\": \"string\", \"enum\": [\"obstacle\", \"unknown\"], \"default\": \"obstacle\","
    " \"description\": \"what @ and O are: many maps draw their walls with them\"},"
    "\"water\": {\"type\": \"string\", \"enum\": [\"obstacle\", \"free\"], \"default\": \"obstacle\","
    " \"description\": \"what W is: nobody walks into it from the land\"}}}";

static const PlanformInfo info = {
    sizeof(PlanformInfo), "movingai", "Grid maps of the MovingAI pathfinding benchmarks", "0.1.0", "MIT OR Apache-2.0",
    extensions,           NULL,       options_schema,                                     PLANFORM_THREAD_SAFE,
};

static const PlanformAdapter adapter = {sizeof(PlanformAdapter), &info, NULL, probe_map, read_map};
static const PlanformAdapter *const adapters[] = {&adapter, NULL};

static const PlanformPlugin plugin = {
    sizeof(PlanformPlugin), PLANFORM_ABI_MAJOR, PLANFORM_ABI_MINOR, adapters, NULL,
};

const PlanformPlugin *planform_plugin(const PlanformHost *offered) {
  /* An older planform has fewer functions, and another major version others. */
  if (!offered || offered->size < sizeof(PlanformHost) || offered->abi_major != PLANFORM_ABI_MAJOR)
    return NULL;
  host = offered;
  return &plugin;
}
