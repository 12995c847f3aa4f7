//! `planform-synth`: writes a synthetic robot map and its truth.

mod files;

use clap::{Parser, ValueEnum};
use planform_synth::{Building, BuildingParams, Noise, Outline, ScanParams, Size, shrunk};
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// Writes the map that a robot would make of a made-up building (map.pgm, map.yaml), and the truth about that
/// building (truth.json, labels.png).
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
    /// Make any kind of building and robot of the seed, for training; --size, --noise, --furniture, --glass and
    /// --unexplored then say nothing
    #[arg(long)]
    varied: bool,
    /// Make the map smaller by this whole number, as figures are: walls grow and doors shrink
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=20))]
    shrink: u32,
    /// Write the exact raster of the building in place of a robot's map
    #[arg(long)]
    exact: bool,
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
        let resolution = self.resolution;
        if self.varied {
            return ScanParams { resolution, ..ScanParams::varied(self.seed) };
        }
        ScanParams {
            seed: self.seed,
            resolution,
            noise,
            furniture: self.furniture,
            unexplored: self.unexplored,
            glass: self.glass,
            ..ScanParams::default()
        }
    }

    fn building(&self) -> Building {
        let params = if self.varied {
            BuildingParams::varied(self.seed)
        } else {
            BuildingParams::of_size(self.size())
        };
        Building::generate(self.seed, &params)
    }

    fn outline(&self) -> Outline {
        match self.labels {
            LabelsArg::Centre => Outline::Centre,
            LabelsArg::Inner => Outline::Inner,
        }
    }
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    let building = args.building();
    let grid =
        if args.exact { building.clean_grid(args.resolution)? } else { building.scan(&args.scan())?.grid };
    let grid = shrunk(&grid, args.shrink)?;
    let labels = building.labels(args.resolution, args.outline())?.shrunk(args.shrink);
    files::write(&args.out, &grid, building.layout(), &labels)?;
    println!(
        "{}: {} rooms, {} openings, {} x {} cells",
        args.out.display(),
        building.layout().rooms.len(),
        building.layout().openings.len(),
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
