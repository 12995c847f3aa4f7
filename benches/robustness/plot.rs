//! The curves as a picture.

use crate::curves::Curve;
use crate::trial::MEASURES;
use plotters::prelude::*;

const COLUMNS: usize = 3;
/// Width and height of one plot, and height of the legend, pixels.
const PLOT: (u32, u32) = (320, 260);
const LEGEND: u32 = 34;
/// Okabe and Ito's colours, which the colour-blind can tell apart.
const COLOURS: [RGBColor; 5] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(90, 90, 90),
];

/// One small plot for each factor, as SVG.
pub fn plot(curves: &[Curve]) -> String {
    let rows = curves.len().div_ceil(COLUMNS);
    let size = (PLOT.0 * COLUMNS as u32, PLOT.1 * rows as u32 + LEGEND);
    let lowest = lowest(curves);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        root.fill(&WHITE).unwrap();
        let (plots, bottom) = root.split_vertically(PLOT.1 * rows as u32);
        for (area, curve) in plots.split_evenly((rows, COLUMNS)).iter().zip(curves) {
            draw(area, curve, lowest);
        }
        legend(&bottom);
        root.present().unwrap();
    }
    svg
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

/// The lower end of all plots, percent: one for all, so that they can be compared.
fn lowest(curves: &[Curve]) -> f64 {
    let least = curves.iter().flat_map(|c| &c.means).flatten().fold(0.9, |low: f64, &v| low.min(v));
    (least * 10.0).floor() * 10.0
}

fn draw(area: &Area, curve: &Curve, lowest: f64) {
    let values = curve.factor.values;
    let ends = values.iter().fold((f64::MAX, f64::MIN), |(lo, hi), &v| (lo.min(v), hi.max(v)));
    let mut chart = ChartBuilder::on(area)
        .caption(curve.factor.name, ("sans-serif", 18))
        .margin(8)
        .set_label_area_size(LabelAreaPosition::Left, 36)
        .set_label_area_size(LabelAreaPosition::Bottom, 38)
        .build_cartesian_2d(ends.0..ends.1, lowest..100.0)
        .unwrap();
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(RGBColor(225, 225, 225))
        .label_style(("sans-serif", 13))
        .x_labels(6)
        .y_labels(6)
        .x_label_formatter(&|v| short(*v))
        .y_label_formatter(&|v| format!("{v:.0}"))
        .x_desc(curve.factor.unit)
        .draw()
        .unwrap();
    for (measure, colour) in COLOURS.iter().enumerate() {
        let points = || values.iter().zip(&curve.means).map(|(&v, means)| (v, 100.0 * means[measure]));
        chart.draw_series(LineSeries::new(points(), colour.stroke_width(2))).unwrap();
        chart.draw_series(points().map(|p| Circle::new(p, 2, colour.filled()))).unwrap();
    }
}

/// A number without needless noughts.
fn short(value: f64) -> String {
    format!("{value:.3}").trim_end_matches('0').trim_end_matches('.').into()
}

fn legend(area: &Area) {
    let font = ("sans-serif", 15).into_font();
    for (i, (name, colour)) in MEASURES.iter().zip(COLOURS).enumerate() {
        let x = 250 + 100 * i as i32;
        let line = PathElement::new(vec![(x, 14), (x + 26, 14)], colour.stroke_width(2));
        area.draw(&line).unwrap();
        area.draw(&Text::new(*name, (x + 32, 8), font.clone())).unwrap();
    }
    area.draw(&Text::new("Means over the buildings, percent:", (30, 8), font)).unwrap();
}
