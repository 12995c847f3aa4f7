/* Plugins that misbehave, for tests alone. Compiled once for each misdeed and each moment:
 *   cc -DMISDEED=segfault -DWHEN='"read"' ...
 * The misdeed is also the plugin's name, and the ending of the documents that it claims and writes. */
#define _GNU_SOURCE
#include "planform.h"
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define SHOWN(text) #text
#define TEXT(text) SHOWN(text)
#define NAME TEXT(MISDEED)
#define CALLED(misdeed) do_##misdeed()
#define CALL(misdeed) CALLED(misdeed)
#define MAYBE __attribute__((unused)) static

/* Keeps compilers from seeing what comes of it. */
static volatile int one = 1;

MAYBE void do_segfault(void) {
  volatile int *nowhere = (volatile int *)(size_t)(one - 1);
  *nowhere = one;
}

MAYBE void do_abort(void) { abort(); }

MAYBE void do_loop(void) {
  while (one) {
  }
}

MAYBE void do_sleep(void) {
  while (one) sleep(100);
}

MAYBE void do_allocate(void) {
  while (one) {
    char *block = malloc(1 << 20);
    if (block) memset(block, one, 1 << 20);
  }
}

MAYBE void do_exhaust(void) {
  while (one) memset(malloc(1 << 20), one, 1 << 20);
}

MAYBE int deeper(int depth) {
  volatile char here[4096];
  here[depth % 4096] = (char)depth;
  return deeper(depth + one) + here[0];
}

MAYBE void do_overflow(void) { deeper(0); }

MAYBE void do_exit(void) { exit(3); }

MAYBE void do_divide(void) { raise(SIGFPE); }

static const PlanformHost *host;

/* Does no harm: it talks to the user in the way that it should. */
MAYBE void do_talk(void) {
  host->log(PLANFORM_LOG_WARNING, planform_string("the plan is old\nand \x1b[31mred"));
  host->log(PLANFORM_LOG_INFO, planform_string("it has three floors"));
}

/* The sink of the document that is read. */
static const PlanformSceneSink *the_sink;

static PlanformStatus show(const char *name, size_t length) {
  static const uint8_t rgb[2 * 1 * 3] = {255, 0, 0, 0, 0, 255};
  bool wanted = the_sink->flags & PLANFORM_WANTS_PICTURES;
  PlanformStage stage = {.size = sizeof stage, .name = planform_string(name)};
  if (wanted) stage.width = 2, stage.height = 1, stage.rgb = rgb, stage.rgb_length = length;
  return the_sink->stage(the_sink->context, &stage);
}

/* Does no harm: it tells of the stages of its work. */
MAYBE void do_stages(void) { show("light", 6), show("../No Way\x1b[31m", 6); }

/* Does no harm: it finds what a plan shows beside its walls. */
MAYBE void do_plan(void) {
  static const PlanformDoorLeaf leaf = {1.0, 1.5, 1.9, 1.5, 1.0, 2.4};
  PlanformSymbol door = {.size = sizeof door, .kind = planform_string("door"), .x = 1.45, .y = 1.95, .score = 1.0};
  PlanformSymbol sink = door;
  sink.kind = planform_string("sink");
  door.leaves = &leaf, door.leaf_count = 1;
  PlanformScale scale = {.size = sizeof scale, .metres_per_pixel = 0.02, .confidence = 0.9};
  scale.source = planform_string("written scale 1:100");
  the_sink->symbol(the_sink->context, &door);
  the_sink->symbol(the_sink->context, &sink);
  the_sink->symbol(the_sink->context, &door);
  the_sink->scale(the_sink->context, &scale);
}

/* Has far too many stages, whatever it is answered. */
MAYBE void do_flood(void) {
  for (int i = 0; i < 1000; i++) show("light", 6);
}

/* Has a picture that ends too soon. */
MAYBE void do_torn(void) { show("light", 5); }

/* Leaves a process behind that would run for ever, and then crashes. */
MAYBE void do_orphan(void) {
  if (fork() == 0) do_sleep();
  do_segfault();
}

MAYBE void do_complain(void) {
  fprintf(stderr, "bad.c: this cannot be\n");
  abort();
}

/* Prints what is no answer where the answers go, and closes it. */
MAYBE void do_chatter(void) {
  printf("hello, I am a plugin\n");
  fprintf(stderr, "and I complain\n");
}

MAYBE void do_close(void) {
  for (int i = 0; i < 64; i++) close(i);
}

static void at(const char *moment) {
  if (strcmp(moment, WHEN) == 0) CALL(MISDEED);
}

static int32_t probe(const PlanformAdapter *adapter, const PlanformProbe *document) {
  (void)adapter;
  at("probe");
  size_t length = strlen(NAME);
  return document->head_length >= length && memcmp(document->head, NAME, length) == 0 ? 90 : 0;
}

static PlanformStatus read_(const PlanformAdapter *adapter, const PlanformSource *source,
                            const PlanformJson *options, const PlanformSceneSink *sink) {
  (void)adapter, (void)source, (void)options;
  the_sink = sink;
  at("read");
  static int8_t cells[100 * 100];
  for (int i = 0; i < 100 * 100; i++) {
    int x = i % 100, y = i / 100;
    cells[i] = x < 10 || y < 10 || x > 89 || y > 89 ? -1 : x < 13 || y < 13 || x > 86 || y > 86 ? 100 : 0;
  }
  PlanformGrid grid = {
      .size = sizeof grid, .width = 100, .height = 100, .resolution = 0.05, .cells = cells, .cell_count = 100 * 100};
  return sink->grid(sink->context, &grid);
}

static PlanformStatus write_(const PlanformExporter *exporter, const PlanformDocument *document,
                             const PlanformJson *options, const PlanformOutput *output) {
  (void)exporter, (void)document, (void)options;
  at("write");
  return output->write(output->context, (const uint8_t *)"done\n", 5);
}

static const char *const EXTENSIONS[] = {NAME, NULL};
static const PlanformInfo INFO = {.size = sizeof INFO,
                                  .name = NAME,
                                  .description = "Misbehaves, for tests",
                                  .version = "1.0.0",
                                  .licence = "MIT",
                                  .extensions = EXTENSIONS};
static const PlanformAdapter ADAPTER = {.size = sizeof ADAPTER, .info = &INFO, .probe = probe, .read = read_};
static const PlanformExporter EXPORTER = {.size = sizeof EXPORTER, .info = &INFO, .write = write_};
static const PlanformAdapter *const ADAPTERS[] = {&ADAPTER, NULL};
static const PlanformExporter *const EXPORTERS[] = {&EXPORTER, NULL};

#ifndef MAJOR
#define MAJOR PLANFORM_ABI_MAJOR
#endif
#ifndef SIZE
#define SIZE sizeof(PlanformPlugin)
#endif
static const PlanformPlugin PLUGIN = {
    .size = SIZE, .abi_major = MAJOR, .abi_minor = 0, .adapters = ADAPTERS, .exporters = EXPORTERS};

const PlanformPlugin *planform_plugin(const PlanformHost *given) {
  host = given;
  at("load");
  return strcmp(WHEN, "refuse") == 0 ? NULL : &PLUGIN;
}
