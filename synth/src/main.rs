//! `planform-synth`: writes a synthetic robot map and its truth.

mod files;

use clap::{Parser, ValueEnum};
use planform_synth::{Building, BuildingParams, Noise, Outline, Plan, PlanStyle, Sample, ScanParams, Size};
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// Writes the map that a robot would make of a made-up building (map.pgm, map.yaml), and the truth about that
/// building (truth.json, labels.png). With --plan, a drawing of a building in place of a map.
#[derive(Parser)]
#[command(version)]
struct Args {
    /// Number of the building; the same number gives the same files
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How large the building is
    #[arg(long, value_enum, default_value = "school")]
    size: SizeArg,
    /// Folder to write to; it is made if it does not exist
    #[arg(long)]
    out: PathBuf,
    /// How well the robot measures
    #[arg(long, value_enum, default_value = "default")]
    noise: NoiseArg,
    /// How much furniture there is, 0 to 1
    #[arg(long, default_value_t = 0.0, value_parser = share)]
    furniture: f64,
    /// Share of the rooms that the robot does not enter, 0 to 1
    #[arg(long, default_value_t = 0.0, value_parser = share)]
    unexplored: f64,
    /// Share of the outer walls with a window that lets the laser out, 0 to 1
    #[arg(long, default_value_t = 0.0, value_parser = share)]
    glass: f64,
    /// Metres per cell
    #[arg(long, default_value_t = 0.05)]
    resolution: f64,
    /// Outline of the rooms in labels.png
    #[arg(long, value_enum, default_value = "centre")]
    labels: LabelsArg,
    /// Make any kind of map of any kind of building, for training: of the other options only --seed and --out count
    #[arg(long)]
    varied: bool,
    /// Write the exact raster of the building in place of a robot's map
    #[arg(long)]
    exact: bool,
    /// Draw a building as people do (plan.jpg or plan.png, truth.json, labels.png, walls.png, letters.png): of the other
    /// options only --seed and --out count
    #[arg(long, value_enum, conflicts_with = "varied")]
    plan: Option<PlanArg>,
}

#[derive(Clone, Copy, ValueEnum)]
enum PlanArg {
    /// An architect's plan
    Blueprint,
    /// A plan with escape routes and safety signs
    Evacuation,
}

#[derive(Clone, Copy, ValueEnum)]
enum SizeArg {
    House,
    Office,
    School,
}

#[derive(Clone, Copy, ValueEnum)]
enum NoiseArg {
    Default,
    None,
    Heavy,
}

#[derive(Clone, Copy, ValueEnum)]
enum LabelsArg {
    /// Up to the middle of the walls
    Centre,
    /// Up to the inner faces of the walls
    Inner,
}

fn share(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| format!("`{text}` is not a number"))?;
    if (0.0..=1.0).contains(&value) { Ok(value) } else { Err("give a number from 0 to 1".into()) }
}

impl Args {
    fn size(&self) -> Size {
        match self.size {
            SizeArg::House => Size::House,
            SizeArg::Office => Size::Office,
            SizeArg::School => Size::School,
        }
    }

    fn scan(&self) -> ScanParams {
        let noise = match self.noise {
            NoiseArg::Default => Noise::default(),
            NoiseArg::None => Noise::none(),
            NoiseArg::Heavy => Noise::heavy(),
        };
        ScanParams {
            seed: self.seed,
            resolution: self.resolution,
            noise,
            furniture: self.furniture,
            unexplored: self.unexplored,
            glass: self.glass,
            ..ScanParams::default()
        }
    }

    fn sample(&self) -> Result<Sample, Box<dyn Error>> {
        let building = Building::generate(self.seed, &BuildingParams::of_size(self.size()));
        let resolution = self.resolution;
        let grid =
            if self.exact { building.clean_grid(resolution)? } else { building.scan(&self.scan())?.grid };
        let labels = building.labels(resolution, self.outline())?;
        Ok(Sample { grid, labels, layout: building.layout().clone() })
    }

    fn outline(&self) -> Outline {
        match self.labels {
            LabelsArg::Centre => Outline::Centre,
            LabelsArg::Inner => Outline::Inner,
        }
    }
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    match args.plan {
        Some(style) => draw_plan(args, style),
        None => make_map(args),
    }
}

fn draw_plan(args: &Args, style: PlanArg) -> Result<(), Box<dyn Error>> {
    let style = match style {
        PlanArg::Blueprint => PlanStyle::Blueprint,
        PlanArg::Evacuation => PlanStyle::Evacuation,
    };
    let plan =
        Plan::draw(args.seed, style).ok_or("no building of this seed fits a sheet; give another --seed")?;
    files::write_plan(&args.out, &plan)?;
    println!(
        "{}: {} rooms, {} symbols, {} texts, {} x {} pixels of {:.4} m",
        args.out.display(),
        plan.truth.layout.rooms.len(),
        plan.truth.symbols.len(),
        plan.truth.texts.len(),
        plan.picture.width(),
        plan.picture.height(),
        plan.truth.metres_per_pixel
    );
    Ok(())
}

fn make_map(args: &Args) -> Result<(), Box<dyn Error>> {
    let Sample { grid, labels, layout } = if args.varied { Sample::draw(args.seed)? } else { args.sample()? };
    files::write(&args.out, &grid, &layout, &labels)?;
    println!(
        "{}: {} rooms, {} openings, {} x {} cells",
        args.out.display(),
        layout.rooms.len(),
        layout.openings.len(),
        grid.width(),
        grid.height()
    );
    Ok(())
}

fn main() -> ExitCode {
    match run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            eprintln!("planform-synth: {e}");
            ExitCode::FAILURE
        }
    }
}
