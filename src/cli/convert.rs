//! `planform convert`.

use super::Failure;
use super::caps::CapArgs;
use super::failure::say;
use super::input::{InputArgs, Opened};
use super::memory::{MIB, most_held};
use super::output::{self, Target};
use super::outside::{OutsideArgs, tell_messages, tell_refusals};
use super::params::MethodArgs;
use super::progress::{Progress, Voice};
use super::watch::{DebugFolder, ReadWatch, Watch};
use crate::reconstruct::{Params, reconstruct};
use clap::Args;
use planform_sdk::parallel::{VARIABLE, set_threads};
use planform_sdk::{Layout, OpeningKind, Options, RoomState, Scene};
use std::num::NonZero;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  planform convert map.yaml -o rooms.svg
      draw the rooms, walls and doors of a robot's map
  planform convert map.yaml -o rooms.svg -o rooms.dxf -o rooms.geojson
      the same in three formats at once
  planform convert scan.png --resolution 0.05 -o rooms.dxf
      a robot's map as a bare picture whose pixels are 5 cm wide
  planform convert plan.pdf --set scale=1:100 -o rooms.dxf
      the plan of a floor, drawn at 1:100; without that, the plan itself is asked
  planform convert map.yaml -o rooms.geojson --anchor 48.1374,11.5755,12
      put the rooms on the Earth
  cat map.pgm | planform convert - --resolution 0.05 -o - --to svg > rooms.svg
      from standard input to standard output
  planform convert map.yaml -o rooms.svg --debug-dir steps
      also paint what each step of the reconstruction found";

/// Reconstruct the rooms, walls and doors that a document shows, and write them
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct ConvertArgs {
    #[command(flatten)]
    input: InputArgs,
    /// Write this file; its extension names the format. May be given several times; `-` is standard output
    #[arg(short, long, value_name = "FILE", required = true)]
    output: Vec<PathBuf>,
    /// The format of outputs whose name does not tell it; `planform plugins` lists them
    #[arg(long, value_name = "FORMAT")]
    to: Option<String>,
    /// Overwrite files that are there already
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    method: MethodArgs,
    /// Paint what each step found into this folder, as `01-clutter.png` and so on; the adapter's own steps come first
    #[arg(long, value_name = "DIR")]
    debug_dir: Option<PathBuf>,
    /// Work on N threads instead of one for each core; the result is the same
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true, env = VARIABLE, hide_env_values = true)]
    threads: Option<NonZero<usize>>,
    /// Tell each step and how long it took, and the peak of memory
    #[arg(short, long, conflicts_with = "quiet")]
    verbose: bool,
    /// Tell nothing but errors
    #[arg(short, long)]
    quiet: bool,
    #[command(flatten)]
    caps: CapArgs,
    // The heading that it begins would hold whatever comes after it.
    #[command(flatten)]
    outside: OutsideArgs,
}

/// More threads than this only take memory.
const MOST_THREADS: usize = 1024;

fn threads(text: &str) -> Result<NonZero<usize>, String> {
    let count = text.parse::<NonZero<usize>>().ok().filter(|n| n.get() <= MOST_THREADS);
    count.ok_or_else(|| format!("give a whole number from 1 to {MOST_THREADS}"))
}

impl ConvertArgs {
    fn voice(&self) -> Voice {
        match (self.quiet, self.verbose) {
            (true, _) => Voice::Quiet,
            (_, true) => Voice::Verbose,
            _ => Voice::Normal,
        }
    }
}

pub fn run(args: &ConvertArgs) -> Result<(), Failure> {
    args.threads.into_iter().for_each(set_threads);
    let registry = args.outside.registry(args.verbose)?;
    let targets = output::plan(&args.output, args.to.as_deref(), &registry)?;
    let mut params = args.method.params()?;
    args.caps.limit(&mut params)?;
    targets.iter().try_for_each(|t| t.check(&args.input.input, args.force))?;
    let exporters: Vec<_> = targets.iter().map(|t| t.exporter.info()).collect();
    let mut opened = Opened::open(&args.input, args.caps.caps(), &registry, &exporters)?;
    tell_refusals(&registry, args.voice());
    let options = opened.options(&args.input.reading.settings(), &exporters)?;
    let folder = args.debug_dir.as_deref().map(|dir| DebugFolder::prepare(dir, args.force));
    let mut folder = folder.transpose()?;
    let (adapter_options, exporter_options) = options.split_at(1);
    let scene = read(&mut opened, &adapter_options[0], args.voice(), folder.as_mut())?;
    folder.iter().try_for_each(|f| f.check(params.method.steps()))?;
    let run = Run { opened: &opened, scene: &scene, voice: args.voice() };
    let layout = run.finish(&params, folder.as_ref(), &targets, exporter_options, args.force)?;
    if args.voice() == Voice::Verbose {
        tell_memory();
    }
    if args.voice() != Voice::Quiet {
        say(&summary(&opened.shown(), &layout, &targets));
    }
    Ok(())
}

/// Tells the most memory that was held, where the system knows.
fn tell_memory() {
    if let bytes @ 1.. = most_held() {
        say(&format!("peak memory{:>5} MiB", bytes.div_ceil(MIB)));
    }
}

fn read(
    opened: &mut Opened<'_>,
    options: &Options,
    voice: Voice,
    folder: Option<&mut DebugFolder>,
) -> Result<Scene, Failure> {
    let mut progress = Progress::new(voice);
    progress.step("reading");
    let mut watch = ReadWatch::new(&mut progress, folder);
    let scene = opened.read(options, &mut watch);
    let watched = watch.finish();
    drop(progress);
    tell_messages(voice);
    let scene = scene?;
    watched?;
    if voice != Voice::Quiet {
        tell_warnings(&opened.shown(), &scene.warnings);
    }
    Ok(scene)
}

/// The most warnings of one document that are told.
const MOST_WARNINGS: usize = 20;

fn tell_warnings(document: &str, warnings: &[String]) {
    warnings.iter().take(MOST_WARNINGS).for_each(|w| say(&format!("warning: {document}: {w}")));
    if let more @ 1.. = warnings.len().saturating_sub(MOST_WARNINGS) {
        say(&format!("warning: {document}: and {more} more warnings"));
    }
}

/// A document that has been read.
struct Run<'a> {
    opened: &'a Opened<'a>,
    scene: &'a Scene,
    voice: Voice,
}

impl Run<'_> {
    /// Reconstructs the layout and writes it.
    fn finish(
        &self,
        params: &Params,
        folder: Option<&DebugFolder>,
        targets: &[Target<'_>],
        options: &[Options],
        force: bool,
    ) -> Result<Layout, Failure> {
        let mut progress = Progress::new(self.voice);
        let layout = self.reconstruct(params, folder, &mut progress)?;
        progress.step("writing");
        let contents: Result<Vec<_>, _> =
            targets.iter().zip(options).map(|(t, o)| t.render(&layout, self.scene, o)).collect();
        drop(progress);
        tell_messages(self.voice);
        output::write(targets, &contents?, force)?;
        Ok(layout)
    }

    fn reconstruct(
        &self,
        params: &Params,
        folder: Option<&DebugFolder>,
        progress: &mut Progress,
    ) -> Result<Layout, Failure> {
        let mut watch = Watch::new(progress, folder, &self.scene.grid, params.method.steps());
        let layout =
            reconstruct(self.scene, params, &mut watch).map_err(|e| Failure::over(self.opened.shown(), e))?;
        watch.finish()?;
        Ok(layout)
    }
}

/// `map.yaml: 12 rooms (2 partial), 58 walls, 14 doors -> out.svg, out.dxf`
fn summary(input: &str, layout: &Layout, targets: &[Target<'_>]) -> String {
    let outputs: Vec<_> = targets.iter().map(|t| t.shown()).collect();
    format!("{input}: {} -> {}", found(layout), outputs.join(", "))
}

/// `12 rooms (2 partial), 58 walls, 14 doors`
pub fn found(layout: &Layout) -> String {
    let partial = layout.rooms.iter().filter(|r| r.state == RoomState::Partial).count();
    let partial = if partial > 0 { format!(" ({partial} partial)") } else { String::new() };
    let openings = |kind| layout.openings.iter().filter(|o| o.kind == kind).count();
    let (doors, passages) = (openings(OpeningKind::Door), openings(OpeningKind::Passage));
    let passages = if passages > 0 { format!(", {}", count(passages, "passage")) } else { String::new() };
    format!(
        "{}{partial}, {}, {}{passages}{}",
        count(layout.rooms.len(), "room"),
        count(layout.walls.len(), "wall"),
        count(doors, "door"),
        read_beside(layout)
    )
}

/// What the document says beside its grid, if anything.
fn read_beside(layout: &Layout) -> String {
    let counts = [(layout.texts.len(), "text"), (layout.symbols.len(), "symbol")];
    let counts =
        counts.into_iter().filter(|(n, _)| *n > 0).map(|(n, thing)| format!(", {}", count(n, thing)));
    let scale = layout.scale.as_ref().map(|s| format!(", scale {}", s.told()));
    counts.chain(scale).collect()
}

fn count(n: usize, thing: &str) -> String {
    format!("{n} {thing}{}", if n == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Opening, Polygon, Pose, Room, Scale, Segment, Text};

    #[test]
    fn the_summary_counts_what_was_found() {
        let room = |id, state| Room {
            id,
            name: None,
            stated_area: None,
            state,
            inner: Polygon::default(),
            centre: Polygon::default(),
        };
        let door = Opening { kind: OpeningKind::Door, segment: Segment::default(), rooms: [1, 2] };
        let layout = Layout {
            rooms: vec![room(1, RoomState::Complete), room(2, RoomState::Partial)],
            openings: vec![door],
            ..Layout::default()
        };
        assert_eq!(found(&layout), "2 rooms (1 partial), 0 walls, 1 door");
        assert_eq!(found(&Layout::default()), "0 rooms, 0 walls, 0 doors");
        let text =
            Text { content: "Hall".into(), pose: Pose::default(), width: 1.0, height: 0.2, confidence: 1.0 };
        let scale = Scale { metres_per_pixel: 0.01, source: "door widths".into(), confidence: 0.4 };
        let plan = Layout { texts: vec![text.clone(), text], scale: Some(scale), ..Layout::default() };
        assert_eq!(found(&plan), "0 rooms, 0 walls, 0 doors, 2 texts, scale by door widths");
    }
}
