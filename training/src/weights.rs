//! The weights as Rust source.

use planform::reconstruct::basins::evidence::NAMES;
use planform::reconstruct::basins::model::Model;

/// The source of a module with the weights.
pub fn source(model: &Model, buildings: u64) -> String {
    let mut text = format!(
        "//! The weights of the model, fitted to {buildings} synthetic buildings by `cargo run --release -p planform-training --\n\
         //! --write src/reconstruct/basins/weights.rs`; not to be edited.\n\n\
         use super::evidence::COUNT;\n\n\
         /// The log odds where all evidence is 0.\n\
         pub const BIAS: f64 = {:.4};\n\n\
         /// What each number of the evidence adds to the log odds, for each of its units.\n\
         pub const WEIGHTS: [f64; COUNT] = [\n",
        model.bias
    );
    let weights = model.weights.map(|w| format!("{w:.4},"));
    let longest = weights.iter().map(String::len).max().unwrap_or(0);
    for (weight, name) in weights.iter().zip(NAMES) {
        text += &format!("    {weight:longest$} // {name}\n");
    }
    text + "];\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_weights_in_use_are_as_they_were_written() {
        let file = include_str!("../../src/reconstruct/basins/weights.rs");
        assert_eq!(file, source(&Model::default(), 600));
    }
}
