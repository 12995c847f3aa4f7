//! The user's `NAME=VALUE` settings, handed out to the plugins that take them.

use planform_sdk::{ErrorKind, Options, PluginError, PluginInfo};
use serde::{Deserialize, Serialize};
use std::str::FromStr;

/// One value for an option: `NAME=VALUE` for every plugin that has the option, `PLUGIN.NAME=VALUE` for one plugin.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Setting {
    /// The only plugin meant, if one was named.
    pub plugin: Option<String>,
    /// The option.
    pub name: String,
    /// Its value as typed.
    pub value: String,
}

impl Setting {
    /// A setting for every plugin that has the option.
    pub fn of(name: &str, value: &str) -> Self {
        Self { plugin: None, name: name.into(), value: value.into() }
    }

    /// Whether this plugin takes it.
    pub fn is_for(&self, plugin: &PluginInfo) -> bool {
        match &self.plugin {
            Some(name) => *name == plugin.name,
            None => plugin.options.iter().any(|o| o.name == self.name),
        }
    }
}

impl FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (key, value) = text.split_once('=').ok_or("write NAME=VALUE")?;
        match key.split_once('.') {
            Some((plugin, name)) => Ok(Self { plugin: Some(plugin.into()), ..Self::of(name, value) }),
            None => Ok(Self::of(key, value)),
        }
    }
}

/// The options of each of the run's `plugins`, in their order.
///
/// Fails when a setting has a value that its option does not take, or when none of the plugins takes the setting.
pub fn run_options(settings: &[Setting], plugins: &[&PluginInfo]) -> Result<Vec<Options>, PluginError> {
    if let Some(lost) = settings.iter().find(|s| !plugins.iter().any(|p| s.is_for(p))) {
        return Err(nobody_takes(lost, plugins));
    }
    plugins.iter().map(|plugin| plugin_options(settings, plugin)).collect()
}

fn plugin_options(settings: &[Setting], plugin: &PluginInfo) -> Result<Options, PluginError> {
    let given = settings.iter().filter(|s| s.is_for(plugin)).map(|s| (s.name.as_str(), s.value.as_str()));
    Options::parse(&plugin.options, given)
        .map_err(|e| PluginError { message: format!("{}: {}", plugin.name, e.message), ..e })
}

fn nobody_takes(setting: &Setting, plugins: &[&PluginInfo]) -> PluginError {
    let message = match &setting.plugin {
        Some(name) => format!("plugin `{name}` takes no part in this run"),
        None => format!("no plugin of this run has an option `{}`", setting.name),
    };
    let mut known: Vec<_> = plugins.iter().map(|p| names_of(p)).collect();
    known.dedup();
    PluginError::new(ErrorKind::BadOption, message).advise(known.join("; "))
}

fn names_of(plugin: &PluginInfo) -> String {
    let names: Vec<_> = plugin.options.iter().map(|o| o.name.as_str()).collect();
    let names = if names.is_empty() { "no options".into() } else { names.join(", ") };
    format!("{} takes {names}", plugin.name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Bounds, OptionKind, OptionSpec};

    fn plugin(name: &str, options: &[&str]) -> PluginInfo {
        let spec = |name: &&str| OptionSpec {
            name: name.to_string(),
            help: String::new(),
            kind: OptionKind::Number(Bounds::above(0.0)),
            default: None,
        };
        PluginInfo {
            name: name.into(),
            description: String::new(),
            version: String::new(),
            licence: String::new(),
            extensions: vec![],
            media_types: vec![],
            options: options.iter().map(spec).collect(),
        }
    }

    fn options(settings: &[&str]) -> Result<Vec<Options>, PluginError> {
        let settings: Vec<Setting> = settings.iter().map(|s| s.parse().unwrap()).collect();
        run_options(&settings, &[&plugin("grid", &["resolution", "scale"]), &plugin("svg", &["scale"])])
    }

    #[test]
    fn unqualified_settings_reach_every_plugin_that_has_them() {
        let o = options(&["scale=2", "resolution=0.1"]).unwrap();
        assert_eq!((o[0].number("scale"), o[1].number("scale")), (Some(2.0), Some(2.0)));
        assert_eq!((o[0].number("resolution"), o[1].number("resolution")), (Some(0.1), None));
    }

    #[test]
    fn qualified_settings_reach_one_plugin() {
        let o = options(&["svg.scale=2"]).unwrap();
        assert_eq!((o[0].number("scale"), o[1].number("scale")), (None, Some(2.0)));
    }

    #[test]
    fn settings_that_nobody_takes_are_answered_with_those_there_are() {
        let e = options(&["colour=red"]).unwrap_err();
        assert_eq!(
            e.to_string(),
            "no plugin of this run has an option `colour`; grid takes resolution, scale; svg takes scale"
        );
        assert!(options(&["dxf.scale=2"]).unwrap_err().to_string().contains("`dxf` takes no part"));
        assert!(options(&["svg.resolution=2"]).unwrap_err().to_string().contains("svg: there is no option"));
        assert!(
            options(&["scale=0"]).unwrap_err().to_string().starts_with("grid: option `scale` cannot be `0`")
        );
    }

    #[test]
    fn a_setting_needs_a_value() {
        assert!("colour".parse::<Setting>().is_err());
        assert_eq!("a=b=c".parse::<Setting>().unwrap(), Setting::of("a", "b=c"));
    }
}
