/*
 * Feeds the adapter good and bad documents, in planform's place, and checks its answers.
 *
 * Every document is handed over in memory of just its size, so that a sanitizer or valgrind sees each byte that is
 * read beyond it.
 */

#include <planform.h>

#include <stdio.h>
#include <stdlib.h>

static int failures;

#define CHECK(condition, document)                                                             \
  do {                                                                                         \
    if (!(condition)) {                                                                        \
      fprintf(stderr, "line %d: %s does not hold for:\n%s\n", __LINE__, #condition, document); \
      failures++;                                                                              \
    }                                                                                          \
  } while (0)

/* ---- The host ---- */

/* The options of a call. A value is one of its members, or the whole. */
struct PlanformValue {
  double resolution;
  const char *out_of_bounds;
  const char *water;
  const char *asked; /* The member that this is; NULL for the whole. */
};

static const PlanformValue *member(const PlanformValue *value, const char *name) {
  static PlanformValue found[3];
  static unsigned turn;
  PlanformValue *next = &found[turn++ % 3];
  *next = *value;
  next->asked = name;
  return next;
}

static double number(const PlanformValue *value, double otherwise) {
  return strcmp(value->asked, "resolution") == 0 ? value->resolution : otherwise;
}

static PlanformString text(const PlanformValue *value) {
  return planform_string(strcmp(value->asked, "water") == 0 ? value->water : value->out_of_bounds);
}

static const PlanformHost the_host = {
    .size = sizeof(PlanformHost),
    .abi_major = PLANFORM_ABI_MAJOR,
    .abi_minor = PLANFORM_ABI_MINOR,
    .member = member,
    .number = number,
    .text = text,
};

/* What a sink was told. */
typedef struct Record {
  PlanformStatus answer; /* What the sink is to say to a grid. */
  int grids;
  uint32_t width, height;
  double resolution;
  char cells[64]; /* The first of them, as text: '.', '#', '?'. */
  int problems;
  PlanformStatus status;
  uint64_t line;
  char message[256];
  bool advised;
} Record;

static PlanformStatus take_grid(void *context, const PlanformGrid *grid) {
  Record *record = context;
  record->grids++;
  record->width = grid->width;
  record->height = grid->height;
  record->resolution = grid->resolution;
  for (size_t i = 0; i < grid->cell_count; i++) {
    char cell = grid->cells[i] < 0 ? '?' : grid->cells[i] == 0 ? '.' : '#';
    if (i + 1 < sizeof record->cells)
      record->cells[i] = cell;
  }
  return record->answer;
}

static PlanformStatus take_problem(void *context, const PlanformProblem *problem) {
  Record *record = context;
  record->problems++;
  record->status = problem->status;
  record->line = problem->place == PLANFORM_LINE ? problem->position : 0;
  record->advised = problem->advice.length > 0;
  snprintf(record->message, sizeof record->message, "%.*s", (int)problem->message.length, problem->message.data);
  return problem->status;
}

static void take_reason(void *context, PlanformString reason) { (void)context, (void)reason; }

/* ---- Calls ---- */

static const PlanformAdapter *adapter;

/* The document in memory of its own, to be freed; NULL for an empty one. */
static uint8_t *copied(const char *document, size_t length) {
  uint8_t *bytes = length ? malloc(length) : NULL;
  if (bytes)
    memcpy(bytes, document, length);
  return bytes;
}

static PlanformStatus read_bytes(const char *document, size_t length, PlanformValue value, Record *record) {
  uint8_t *bytes = copied(document, length);
  PlanformSource source = {.size = sizeof source, .path = planform_string("a.map"), .bytes = bytes, .length = length};
  PlanformJson options = {.size = sizeof options, .value = &value};
  PlanformSceneSink sink = {.size = sizeof sink, .context = record, .grid = take_grid, .fail = take_problem};
  PlanformStatus status = adapter->read(adapter, &source, &options, &sink);
  free(bytes);
  return status;
}

static const PlanformValue defaults = {0.5, "obstacle", "obstacle", NULL};

static int32_t probe(const char *path, const char *document) {
  uint8_t *bytes = copied(document, strlen(document));
  PlanformProbe probe = {.size = sizeof probe, .path = planform_string(path), .reason = take_reason};
  probe.head = bytes;
  probe.head_length = strlen(document);
  int32_t percent = adapter->probe(adapter, &probe);
  free(bytes);
  return percent;
}

/* ---- Tests ---- */

#define HEADER(height, width) "type octile\nheight " height "\nwidth " width "\nmap\n"
#define GOOD HEADER("2", "7") ".G@OTSW\n......."

/* The document is read with these options, as these cells. */
static void reads(const char *document, PlanformValue value, const char *cells) {
  Record record = {0};
  CHECK(read_bytes(document, strlen(document), value, &record) == PLANFORM_OK, document);
  CHECK(record.grids == 1 && record.problems == 0, document);
  CHECK(strcmp(record.cells, cells) == 0, document);
  CHECK(record.resolution == value.resolution, document);
}

static void test_good_documents(void) {
  PlanformValue unlike = {0.25, "unknown", "free", NULL};
  reads(GOOD, defaults, ".........###.#");
  reads(GOOD, unlike, ".........??#..");
  reads(GOOD "\n", defaults, ".........###.#");
  reads(GOOD "\r\n\r\n \n", defaults, ".........###.#");
  reads("type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n@.\r\n", defaults, "#.");
  reads("\xEF\xBB\xBFtype tile\nwidth  2 \n\theight 1\nmap\n@.", defaults, "#.");
  Record record = {0};
  read_bytes(GOOD, strlen(GOOD), defaults, &record);
  CHECK(record.width == 7 && record.height == 2, GOOD);
}

/* The document is refused, with this status, line and words, and no grid is handed over. */
static void refuses_bytes(const char *document, size_t length, PlanformStatus status, uint64_t line,
                          const char *words) {
  Record record = {0};
  CHECK(read_bytes(document, length, defaults, &record) == status, document);
  CHECK(record.grids == 0 && record.problems == 1, document);
  CHECK(record.status == status && record.line == line, document);
  CHECK(strstr(record.message, words) != NULL, document);
}

static void refuses(const char *document, PlanformStatus status, uint64_t line, const char *words) {
  refuses_bytes(document, strlen(document), status, line, words);
}

static void test_bad_headers(void) {
  const PlanformStatus bad = PLANFORM_BAD_INPUT;
  refuses("", bad, 0, "ends before the line `map`");
  refuses("\n", bad, 1, "no line of a MovingAI map's header");
  refuses("type octile\nheight 2\n", bad, 2, "ends before");
  refuses("type hexagon\n", PLANFORM_UNSUPPORTED, 1, "neither octile nor tile");
  refuses("type\n", PLANFORM_UNSUPPORTED, 1, "neither");
  refuses("type octile\ntype octile\n", bad, 2, "`type` is there twice");
  refuses("type octile\nheight 1\nheight 1\n", bad, 3, "`height` is there twice");
  refuses("height 1\nwidth 1\nmap\n.", bad, 3, "`type` is missing");
  refuses("type octile\nwidth 1\nmap\n.", bad, 3, "`height` is missing");
  refuses("type octile\nheight 1\nmap\n.", bad, 3, "`width` is missing");
  refuses("type octile\nheight 1 2\n", bad, 2, "no line of");
  const char *wrong[] = {"0", "", "-1", "1.5", "0x10", "many", "1\xE9"};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    char document[64];
    snprintf(document, sizeof document, "type octile\nwidth %s\n", wrong[i]);
    refuses(document, bad, 2, "`width` has no whole number from 1");
  }
  refuses_bytes("\x7F" "ELF\0\0\0\xFF\n\n", 10, bad, 1, "no line of");
  refuses_bytes("\xFF\xFEt\0y\0p\0e\0", 10, bad, 1, "no line of");
}

static void test_lying_sizes(void) {
  refuses(HEADER("65537", "1"), PLANFORM_LIMIT, 2, "`height` is more than the 65536");
  refuses(HEADER("1", "18446744073709551617"), PLANFORM_LIMIT, 3, "`width` is more than");
  refuses(HEADER("65536", "65536") ".", PLANFORM_LIMIT, 4, "more than the 134217728 cells");
  /* As many as a map may have, but not as many as there are: refused before memory is taken for them. */
  refuses(HEADER("2048", "65536") ".", PLANFORM_BAD_INPUT, 5, "the row has 1 characters where the header says 65536");
}

static void test_bad_rows(void) {
  const PlanformStatus bad = PLANFORM_BAD_INPUT;
  refuses(HEADER("2", "3"), bad, 4, "ends after 0 of 2 rows");
  refuses(HEADER("2", "3") "...\n", bad, 5, "ends after 1 of 2 rows");
  refuses(HEADER("2", "3") "...\n..", bad, 6, "the row has 2 characters where the header says 3");
  refuses(HEADER("2", "3") "...\n....\n", bad, 6, "has 4 characters");
  refuses(HEADER("2", "3") "...\n\n...", bad, 6, "has 0 characters");
  refuses(HEADER("2", "3") "...\n...\n...", bad, 7, "more than the 2 rows");
  refuses(HEADER("1", "3") "..x", bad, 5, "column 3 has the character `x`");
  refuses(HEADER("1", "3") ".\xC3\xA9", bad, 5, "column 2 has the byte 0xC3");
  refuses(HEADER("1", "3") "..\r.", bad, 5, "column 3 has the byte 0x0D");
  refuses_bytes(HEADER("1", "3") ".\0.", strlen(HEADER("1", "3")) + 3, bad, 5, "column 2 has the byte 0x00");
}

static void test_advice(void) {
  Record record = {0};
  read_bytes(HEADER("1", "3") "..x", strlen(HEADER("1", "3") "..x"), defaults, &record);
  CHECK(record.advised, "a meaningless character");
}

/* Whatever the bytes, there is either a grid or a problem, and its status is returned. */
static void holds(const char *document, size_t length) {
  Record record = {0};
  PlanformStatus status = read_bytes(document, length, defaults, &record);
  CHECK(record.grids + record.problems == 1, document);
  CHECK((status == PLANFORM_OK) == (record.grids == 1), document);
}

static void test_damaged_documents(void) {
  char document[] = GOOD;
  size_t length = strlen(document);
  for (size_t i = 0; i <= length; i++)
    holds(document, i);
  for (size_t i = 0; i < length; i++) {
    char was = document[i];
    for (int byte = 0; byte < 256; byte++) {
      document[i] = (char)byte;
      holds(document, length);
    }
    document[i] = was;
  }
}

/* A sink may refuse a grid; its status is what the adapter returns. */
static void test_refusing_sink(void) {
  Record record = {.answer = PLANFORM_LIMIT};
  CHECK(read_bytes(GOOD, strlen(GOOD), defaults, &record) == PLANFORM_LIMIT, GOOD);
  CHECK(record.grids == 1 && record.problems == 0, GOOD);
}

static void test_large_map(void) {
  size_t header = strlen(HEADER("2000", "3000"));
  size_t length = header + 2000 * 3001;
  char *document = malloc(length + 1);
  if (!document)
    exit(1);
  memcpy(document, HEADER("2000", "3000"), header);
  memset(document + header, '.', length - header);
  for (size_t row = 1; row <= 2000; row++)
    document[header + row * 3001 - 1] = '\n';
  document[length] = 0;
  Record record = {0};
  CHECK(read_bytes(document, length, defaults, &record) == PLANFORM_OK, "a large map");
  CHECK(record.width == 3000 && record.height == 2000, "a large map");
  free(document);
}

static void test_probe(void) {
  CHECK(probe("a.map", GOOD) == 95, GOOD);
  CHECK(probe("", GOOD) == 95, "standard input");
  CHECK(probe("", "type octile\nheight x") == 80, "a damaged header");
  CHECK(probe("a.map", "hello") == 5, "hello");
  CHECK(probe("a.txt", "hello") == 0, "hello");
  CHECK(probe("", "") == 0, "nothing");
}

static void test_entry(void) {
  PlanformHost other = the_host;
  other.abi_major++;
  CHECK(planform_plugin(NULL) == NULL, "no host");
  CHECK(planform_plugin(&other) == NULL, "another major version");
  other = the_host;
  other.size--;
  CHECK(planform_plugin(&other) == NULL, "a smaller table");
}

int main(void) {
  test_entry();
  const PlanformPlugin *plugin = planform_plugin(&the_host);
  if (!plugin || !plugin->adapters[0] || plugin->adapters[1])
    return fprintf(stderr, "there is not one adapter\n"), 1;
  adapter = plugin->adapters[0];
  CHECK(adapter->info->flags == PLANFORM_THREAD_SAFE, "its information");
  test_good_documents();
  test_bad_headers();
  test_lying_sizes();
  test_bad_rows();
  test_advice();
  test_damaged_documents();
  test_refusing_sink();
  test_large_map();
  test_probe();
  printf("%d checks failed\n", failures);
  return failures != 0;
}
