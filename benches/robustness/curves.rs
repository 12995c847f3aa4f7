//! The curves: mean measures over buildings, for each value of each factor.

use crate::accuracy_support::for_seeds;
use crate::factors::{FACTORS, Factor};
use crate::page::{percent, table};
use crate::trial::{MEASURES, Trial};

/// What came of one factor.
pub struct Curve {
    pub factor: &'static Factor,
    /// For each value the means, in the order of [`MEASURES`].
    pub means: Vec<[f64; 5]>,
}

/// Tries all values of all factors on the buildings.
pub fn draw(buildings: u64) -> Vec<Curve> {
    let points: Vec<(&Factor, f64)> =
        FACTORS.iter().flat_map(|f| f.values.iter().map(move |&value| (f, value))).collect();
    let measured = for_seeds(0..points.len() as u64 * buildings, |job| {
        let (factor, value) = points[(job / buildings) as usize];
        let mut trial = Trial::usual(job % buildings + 1);
        (factor.set)(&mut trial, value);
        trial.measures()
    });
    let mut means = measured.chunks(buildings as usize).map(mean);
    let curve =
        |factor: &'static Factor| Curve { factor, means: means.by_ref().take(factor.values.len()).collect() };
    FACTORS.iter().map(curve).collect()
}

fn mean(measured: &[[f64; 5]]) -> [f64; 5] {
    std::array::from_fn(|i| measured.iter().map(|m| m[i]).sum::<f64>() / measured.len() as f64)
}

/// All curves as tables.
pub fn report(curves: &[Curve], buildings: u64) -> String {
    let tables: String = curves.iter().map(|c| section(c) + "\n").collect();
    let [p, r] = [2, 3].map(|measure| percent(spread(curves, "Rotation", measure)));
    format!(
        "Means over {buildings} buildings, percent.\n\n{tables}Over all rotations, mean P differs by at most {p} \
         points and mean R by at most {r}.\n"
    )
}

fn section(curve: &Curve) -> String {
    let Factor { name, unit, values, .. } = curve.factor;
    let header: Vec<String> = [*unit].into_iter().chain(MEASURES).map(String::from).collect();
    let rows = values.iter().zip(&curve.means);
    let rows = rows.map(|(v, means)| [v.to_string()].into_iter().chain(means.map(percent)).collect());
    format!("#### {name}\n\n{}", table(&header, &rows.collect::<Vec<_>>()))
}

/// The largest difference of a measure's means along a curve.
fn spread(curves: &[Curve], name: &str, measure: usize) -> f64 {
    let means = || curves.iter().filter(|c| c.factor.name == name).flat_map(|c| &c.means).map(|m| m[measure]);
    means().fold(f64::MIN, f64::max) - means().fold(f64::MAX, f64::min)
}
