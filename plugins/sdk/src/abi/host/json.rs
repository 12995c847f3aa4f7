//! A JSON document as it crosses to a plugin.

use super::value::Content;
use crate::PluginError;
use crate::abi::PlanformJson;
use crate::abi::plugin::of_host;
use crate::abi::string::Terminated;
use serde::Serialize;

/// The document, written and read.
pub struct Json {
    text: Terminated,
    content: Content,
}

impl Json {
    /// The document of something that is written as JSON.
    pub fn new(of: &impl Serialize) -> Result<Self, PluginError> {
        let text = serde_json::to_string(of).map_err(of_host)?;
        let value: serde_json::Value = serde_json::from_str(&text).map_err(of_host)?;
        Ok(Self { text: Terminated::new(text), content: value.into() })
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
