//! PDF documents: a page is rendered, and the words of its text layer are taken.

mod bombs;
mod glyphs;
mod lines;
mod survey;

use super::PageRequest;
use super::guard::{PATIENCE, guarded};
use super::limit::{MAX_PIXELS, largest_scale};
use super::no_such_page;
use crate::page::Page;
use hayro::hayro_interpret::InterpreterSettings;
use hayro::hayro_interpret::util::TransformExt;
use hayro::hayro_syntax::page::Page as PdfPage;
use hayro::hayro_syntax::{DecryptionError, LoadPdfError, Pdf};
use hayro::kurbo::Affine;
use hayro::vello_cpu::color::palette::css::WHITE;
use hayro::vello_cpu::{Pixmap, RasterizerSettings, RenderContext, Resources, TargetInit};
use hayro::{RenderCache, RenderSettings, render_into};
use image::RgbImage;
use planform_sdk::{ErrorKind, PluginError};
use survey::Survey;

/// PDF counts in points.
const POINTS_PER_INCH: f64 = 72.0;
/// The most pixels a side that the renderer can draw.
const MAX_SIDE: f64 = 65_535.0;
/// Densities of scans that are believed, pixels per inch.
const SCANS: std::ops::RangeInclusive<f64> = 20.0..=2400.0;

/// Renders the page that is asked for.
pub fn page(bytes: &[u8], request: &PageRequest) -> Result<Page, PluginError> {
    let (bytes, request) = (bytes.to_vec(), request.clone());
    guarded("the PDF page", PATIENCE, move || read(bytes, &request))
}

fn read(bytes: Vec<u8>, request: &PageRequest) -> Result<Page, PluginError> {
    bombs::check(&bytes)?;
    let pdf = Pdf::new(bytes).map_err(cannot_load)?;
    let pages = pdf.pages();
    if pages.is_empty() {
        return Err(PluginError::new(ErrorKind::BadInput, "the PDF has no pages").advise("save it again"));
    }
    let page = pages.get(request.page as usize - 1).ok_or_else(|| no_such_page(request.page, pages.len()))?;
    let survey = Survey::of(page);
    survey.check(request.page)?;
    let scale = Scale::of(page, &survey, request.dpi);
    let mut warnings = vec![];
    warnings.extend(scale.warning());
    Ok(Page {
        picture: render(page, &scale)?,
        dpi: Some(scale.dpi),
        metres_per_pixel: None,
        origin: [0.0; 2],
        texts: survey.texts(scale.per_unit(), [f64::from(scale.width), f64::from(scale.height)]),
        drawn: true,
        symbols: vec![],
        walls_only: false,
        warnings,
    })
}

/// How large a page is drawn.
struct Scale {
    /// Pixels.
    width: u16,
    height: u16,
    /// Pixels per inch, as wanted and as drawn.
    wanted: f64,
    dpi: f64,
    /// Inches of one unit of the page.
    unit: f64,
}

impl Scale {
    fn of(page: &PdfPage<'_>, survey: &Survey, dpi: f64) -> Self {
        let (width, height) = page.render_dimensions();
        let unit = f64::from(page.raw().get::<f32>(b"UserUnit").filter(|u| *u > 0.0).unwrap_or(1.0))
            / POINTS_PER_INCH;
        let scan = survey.scan_density(f64::from(width) * f64::from(height)).map(|per_unit| per_unit / unit);
        let wanted = scan.filter(|d| SCANS.contains(d)).unwrap_or(dpi);
        let sides = [width, height].map(|side| f64::from(side) * unit * wanted);
        let largest = largest_scale(sides[0], sides[1]).min((MAX_SIDE - 1.0) / sides[0].max(sides[1]));
        // Rounding up must not lead beyond the limit.
        let shrink = if largest < 1.0 { largest * 0.999 } else { 1.0 };
        let [width, height] = sides.map(|side| (side * shrink).round().clamp(1.0, MAX_SIDE) as u16);
        Self { width, height, wanted, dpi: wanted * shrink, unit }
    }

    /// Pixels per unit of the page.
    fn per_unit(&self) -> f64 {
        self.dpi * self.unit
    }

    fn warning(&self) -> Option<String> {
        let message = format!(
            "the page is drawn with {:.0} pixels per inch instead of {:.0}, since at most {} million pixels are read",
            self.dpi,
            self.wanted,
            MAX_PIXELS / 1_000_000
        );
        (self.dpi < self.wanted).then_some(message)
    }
}

fn render(page: &PdfPage<'_>, scale: &Scale) -> Result<RgbImage, PluginError> {
    let mut context = RenderContext::new(scale.width, scale.height);
    let transform = Affine::scale(scale.per_unit()) * page.initial_transform(true).to_kurbo();
    let settings = RenderSettings::default();
    render_into(
        page,
        &RenderCache::new(),
        &InterpreterSettings::default(),
        &settings,
        &mut context,
        transform,
    );
    context.flush();
    let mut pixmap = Pixmap::new(scale.width, scale.height);
    let settings = RasterizerSettings { target_init: TargetInit::Clear(WHITE), ..Default::default() };
    context.render_with(&mut pixmap, &mut Resources::default(), settings);
    drop(context);
    let rgb = pixmap.data_as_u8_slice().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]);
    let mut samples = Vec::with_capacity(usize::from(scale.width) * usize::from(scale.height) * 3);
    samples.extend(rgb);
    RgbImage::from_raw(scale.width.into(), scale.height.into(), samples)
        .ok_or_else(|| PluginError::new(ErrorKind::Plugin, "the PDF renderer drew too few pixels"))
}

fn cannot_load(e: LoadPdfError) -> PluginError {
    match e {
        LoadPdfError::Decryption(DecryptionError::PasswordProtected) => {
            PluginError::new(ErrorKind::Unsupported, "the PDF is encrypted and opens with a password only")
                .advise("save it without a password")
        }
        LoadPdfError::Decryption(_) => {
            PluginError::new(ErrorKind::Unsupported, "the PDF is encrypted in a way that is not read")
                .advise("save it without encryption")
        }
        LoadPdfError::Invalid => {
            PluginError::new(ErrorKind::BadInput, "the PDF is damaged: it has no readable pages")
                .advise("the file may be cut short: save or copy it again")
        }
    }
}

#[cfg(test)]
mod tests;
