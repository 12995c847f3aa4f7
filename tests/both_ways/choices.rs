//! Every choice of a plugin's options.

use planform_sdk::{OptionKind, OptionSpec, Options, PluginInfo};

/// Names and values as a user would type them.
#[derive(Debug, Clone, Default)]
pub struct Choice(Vec<(String, String)>);

impl Choice {
    pub fn of(&self, info: &PluginInfo) -> Options {
        let given = self.0.iter().map(|(name, value)| (name.as_str(), value.as_str()));
        Options::parse(&info.options, given).unwrap()
    }
}

/// Every combination of what each option can be: left out, every word, yes and no, these numbers and these texts.
pub fn choices(info: &PluginInfo, numbers: &[&str], texts: &[&str]) -> Vec<Choice> {
    let mut all = vec![Choice::default()];
    for option in &info.options {
        let values = values(option, numbers, texts);
        let with = |choice: &Choice| {
            let set =
                |value: &String| [choice.0.as_slice(), &[(option.name.clone(), value.clone())]].concat();
            values.iter().map(set).map(Choice).collect::<Vec<_>>()
        };
        let more: Vec<_> = all.iter().flat_map(with).collect();
        all.extend(more);
    }
    all
}

fn values(option: &OptionSpec, numbers: &[&str], texts: &[&str]) -> Vec<String> {
    match &option.kind {
        OptionKind::Choice(words) => words.clone(),
        OptionKind::Flag => ["true", "false"].map(String::from).to_vec(),
        OptionKind::Number(_) => numbers.iter().map(|n| (*n).to_owned()).collect(),
        OptionKind::Text => texts.iter().map(|t| (*t).to_owned()).collect(),
    }
}
