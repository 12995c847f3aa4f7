//! A JSON document as it crosses to a plugin.

use super::value::Content;
use crate::abi::PlanformJson;
use crate::abi::plugin::of_host;
use crate::abi::string::Terminated;
use crate::{ErrorKind, Options, PluginError};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// The document, written and read.
pub struct Json {
    text: Terminated,
    content: Content,
}

impl Json {
    /// The document of something that is written as JSON.
    pub fn new<T: Serialize + DeserializeOwned>(of: &T) -> Result<Self, PluginError> {
        let text = exact(of)?;
        let value: serde_json::Value = serde_json::from_str(&text).map_err(of_host)?;
        Ok(Self { text: Terminated::new(text), content: value.into() })
    }

    /// The document of options.
    pub fn of_options(options: &Options) -> Result<Self, PluginError> {
        Self::new(&options.values())
    }

    /// As a plugin sees it, as long as this lives.
    pub fn as_table(&self) -> PlanformJson {
        PlanformJson {
            size: size_of::<PlanformJson>(),
            text: self.text.as_string(),
            value: self.content.as_ptr(),
        }
    }
}

/// Something as JSON, which cannot hold every number: what is not finite turns to null in it, and is found by reading it
/// back.
pub fn exact<T: Serialize + DeserializeOwned>(of: &T) -> Result<String, PluginError> {
    let text = serde_json::to_string(of).map_err(of_host)?;
    match serde_json::from_str::<T>(&text) {
        Ok(_) => Ok(text),
        Err(_) => Err(PluginError::new(ErrorKind::BadInput, "the layout has a number that is not finite")),
    }
}
