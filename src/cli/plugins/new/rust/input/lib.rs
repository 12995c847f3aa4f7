//! Reads plans that are drawn with characters: `#` is a wall, `.` or a space is free floor, `?` is unknown, one line
//! of text for each row of the plan, the first one on top.

use planform_sdk::{
    Bounds, Cell, Confidence, ErrorKind, Grid, InputAdapter, OptionKind, OptionSpec, OptionValue,
    Options, Place, PluginError, PluginInfo, Pose, Probe, Provenance, Scene, Source,
};

// What planform calls when it loads the library. A library may hold several adapters and exporters.
planform_sdk::export_plugin!(adapters: [adapter()], exporters: []);

/// The plugin's name, and the extension of its files.
const NAME: &str = "{{name}}";

struct TextPlan {
    info: PluginInfo,
}

fn adapter() -> Box<dyn InputAdapter> {
    Box::new(TextPlan { info: info() })
}

fn info() -> PluginInfo {
    // Bounds that every grid keeps to: planform checks the user's value before `read` sees it.
    let bounds = Bounds {
        min: Some(0.001),
        max: Some(1000.0),
        ..Bounds::default()
    };
    let resolution = OptionSpec::new(
        "resolution",
        "metres per character",
        OptionKind::Number(bounds),
        Some(OptionValue::Number(0.1)),
    );
    PluginInfo {
        name: NAME.into(),
        description: "Plans drawn with characters".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: "MIT".into(),
        extensions: vec![NAME.into()],
        media_types: vec!["text/plain".into()],
        options: vec![resolution],
    }
}

impl InputAdapter for TextPlan {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    /// Every adapter is asked, of every document, and the surest one reads it. So do not claim what may be another's.
    fn probe(&self, probe: &Probe<'_>) -> Confidence {
        let drawn = probe.head.contains(&b'#') && probe.head.iter().all(|b| is_plan(*b));
        match (probe.extension() == NAME, drawn) {
            (true, true) => Confidence::because(90, "a plan by its name and its characters"),
            // Ours, though damaged: `read` can say in which line.
            (true, false) => Confidence::because(20, "a plan by its name alone"),
            (false, true) => Confidence::because(40, "a plan by its characters"),
            (false, false) => Confidence::no(),
        }
    }

    fn read(&self, source: &Source, options: &Options) -> Result<Scene, PluginError> {
        let resolution = options.number("resolution").unwrap_or(0.1);
        let grid = grid(&rows(&source.bytes), resolution)?;
        Ok(Scene::of_grid(
            grid,
            Provenance {
                source: source.name(),
                adapter: NAME.into(),
            },
        ))
    }
}

fn is_plan(byte: u8) -> bool {
    cell(byte).is_some() || matches!(byte, b'\n' | b'\r')
}

/// What a character stands for.
fn cell(byte: u8) -> Option<Cell> {
    match byte {
        b'#' => Some(Cell::OCCUPIED),
        b'.' | b' ' => Some(Cell::FREE),
        b'?' => Some(Cell::UNKNOWN),
        _ => None,
    }
}

/// The lines without their ends, be they of Unix or of Windows.
fn rows(bytes: &[u8]) -> Vec<&[u8]> {
    let text = bytes.strip_suffix(b"\n").unwrap_or(bytes);
    text.split(|b| *b == b'\n')
        .map(|row| row.strip_suffix(b"\r").unwrap_or(row))
        .collect()
}

fn grid(rows: &[&[u8]], resolution: f64) -> Result<Grid, PluginError> {
    let unusable = |e: planform_sdk::GridError| PluginError::new(ErrorKind::Limit, e.to_string());
    let width = rows.iter().map(|row| row.len()).max().unwrap_or(0);
    let (width, height) = (side(width), side(rows.len()));
    // Before memory is taken: one long line among many short ones makes a huge grid of a small file.
    Grid::check_size(width, height).map_err(unusable)?;
    let mut drawn = vec![];
    for (i, row) in rows.iter().enumerate() {
        drawn.push(cells(row, i + 1, width as usize)?);
    }
    // A grid's rows go from the bottom up, those of a text from the top down.
    drawn.reverse();
    // The plan does not say where it lies, so its lower left corner is the origin of the map frame.
    Grid::new(width, height, resolution, Pose::default(), drawn.concat()).map_err(unusable)
}

/// The cells of one line, filled up to the width: nothing is known of what lies to the right of its end.
fn cells(row: &[u8], line: usize, width: usize) -> Result<Vec<Cell>, PluginError> {
    let mut cells = Vec::with_capacity(width);
    for (i, byte) in row.iter().enumerate() {
        cells.push(cell(*byte).ok_or_else(|| stranger(*byte, line, i + 1))?);
    }
    cells.resize(width, Cell::UNKNOWN);
    Ok(cells)
}

/// A side of the grid; what is too long for a number is refused as too large.
fn side(length: usize) -> u32 {
    u32::try_from(length).unwrap_or(u32::MAX)
}

fn stranger(byte: u8, line: usize, column: usize) -> PluginError {
    let shown = byte.escape_ascii();
    PluginError::new(
        ErrorKind::BadInput,
        format!("column {column} holds `{shown}`, which means nothing in a plan"),
    )
    .at(Place::Line(line))
    .advise("draw with `#` (wall), `.` or a space (free) and `?` (unknown)")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &[u8]) -> Result<Scene, PluginError> {
        let source = Source {
            path: "a.{{name}}".into(),
            bytes: text.into(),
            byte_limit: Source::BYTE_LIMIT,
        };
        let options = Options::parse(&info().options, [("resolution", "0.5")])?;
        adapter().read(&source, &options)
    }

    #[test]
    fn rows_go_from_the_top_down() {
        let grid = read(b"#?\r\n .\n#\n").unwrap().grid;
        let row = |row| [grid.cell(0, row), grid.cell(1, row)];
        assert_eq!(
            (grid.width(), grid.height(), grid.resolution()),
            (2, 3, 0.5)
        );
        assert_eq!(row(2), [Cell::OCCUPIED, Cell::UNKNOWN]);
        assert_eq!(row(1), [Cell::FREE, Cell::FREE]);
        assert_eq!(row(0), [Cell::OCCUPIED, Cell::UNKNOWN]);
    }

    #[test]
    fn errors_say_where_and_what_to_do() {
        let e = read(b"##\n#x\ny\n").unwrap_err().to_string();
        assert!(
            e.starts_with("line 2: column 2 holds `x`") && e.contains("draw with"),
            "{e}"
        );
        assert_eq!(read(b"").unwrap_err().kind, ErrorKind::Limit);
    }

    #[test]
    fn a_small_file_of_a_huge_plan_is_refused() {
        let text = [vec![b'#'; 60_000], vec![b'\n'; 60_000]].concat();
        assert_eq!(read(&text).unwrap_err().kind, ErrorKind::Limit);
    }

    #[test]
    fn the_sample_is_known_and_read() {
        let bytes = include_bytes!("../sample.{{name}}");
        let probe = Probe {
            path: "sample.{{name}}".as_ref(),
            head: &bytes[..bytes.len().min(4096)],
        };
        assert_eq!(adapter().probe(&probe).percent, 90);
        assert_eq!(read(bytes).unwrap().grid.width(), 100);
    }
}
