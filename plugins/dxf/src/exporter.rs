//! The plugin itself: what it says of itself, and its options.

use crate::check::check;
use crate::drawing::Drawing;
use crate::file::file;
use crate::version::Version;
use planform_sdk::{Boundary, Document, Exporter, OptionSpec, Options, PluginError, PluginInfo};
use std::io::Write;

/// The exporter `dxf`: drawings for CAD programs.
///
/// Options: `version` = `R12`, `R2000` (default), `R2013`, `R2018`; `boundary` = `inner` (default: rooms along the
/// walls' inner faces) or `centre` (along their centre lines). Areas are those of the boundary that is drawn.
///
/// A layout with a number that is not finite or beyond 1e12, or with a ring of fewer than 3 points, is
/// [`planform_sdk::ErrorKind::BadInput`]. An unwritable `out` is [`planform_sdk::ErrorKind::Io`].
///
/// ```
/// use planform_sdk::{Document, Layout, Options};
/// let exporter = planform_dxf::exporter();
/// let options = Options::parse(&exporter.info().options, [("version", "R12")])?;
/// let mut file = vec![];
/// exporter.write(&Document { layout: &Layout::default(), scene: None }, &options, &mut file)?;
/// assert!(file.starts_with(b"  0\nSECTION\n"));
/// # Ok::<(), planform_sdk::PluginError>(())
/// ```
pub fn exporter() -> Box<dyn Exporter> {
    planform_sdk::exporter(info(), write)
}

fn write(document: &Document<'_>, options: &Options, out: &mut dyn Write) -> Result<(), PluginError> {
    let ring = Boundary::chosen(options);
    check(document.layout, ring)?;
    let drawing = Drawing::of(document.layout, ring);
    out.write_all(&file(&drawing, version(options)))?;
    Ok(())
}

fn version(options: &Options) -> Version {
    let named = |v: &Version| options.text("version") == Some(v.name());
    Version::ALL.into_iter().find(named).unwrap_or(Version::DEFAULT)
}

fn info() -> PluginInfo {
    PluginInfo {
        name: "dxf".into(),
        description: "DXF drawing for CAD programs, in metres".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: vec!["dxf".into()],
        media_types: vec!["image/vnd.dxf".into(), "application/dxf".into()],
        options: vec![
            OptionSpec::choice(
                "version",
                "DXF version; R2000 is the oldest with a unit and opens nearly everywhere",
                &Version::ALL.map(Version::name),
                Version::DEFAULT.name(),
            ),
            Boundary::option(),
        ],
    }
}
