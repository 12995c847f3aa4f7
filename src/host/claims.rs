//! Whose document is it? Every input adapter is asked, the surest one wins.

use super::{Registry, messages};
use planform_sdk::{Confidence, ErrorKind, InputAdapter, PluginError, Probe, Source};

/// What one input adapter says of a document.
pub struct Claim<'a> {
    /// The adapter.
    pub adapter: &'a dyn InputAdapter,
    /// How sure it is that the document is its own.
    pub confidence: Confidence,
}

/// How sure a built-in adapter must be for those from outside not to be asked, percent.
const SURE: u8 = 50;

impl Registry {
    /// What each input adapter says of the document, the surest first and equally sure ones in the registry's order.
    /// Those from outside are asked only when no built-in one is sure.
    pub fn claims(&self, source: &Source) -> Vec<Claim<'_>> {
        let probe = Probe::of(source);
        let claim = |adapter: &dyn InputAdapter| adapter.probe(&probe);
        let mut claims: Vec<_> =
            self.builtin_adapters().map(|adapter| Claim { adapter, confidence: claim(adapter) }).collect();
        if claims.iter().all(|c| c.confidence.percent < SURE) {
            let outside = self.outside().adapters.iter().map(|a| a as &dyn InputAdapter);
            claims.extend(outside.map(|adapter| Claim { adapter, confidence: claim(adapter) }));
        }
        claims.sort_by_key(|c| std::cmp::Reverse(c.confidence.percent));
        claims
    }

    /// The input adapter for the document: the one named, or else the surest.
    pub fn adapter_for(&self, source: &Source, name: Option<&str>) -> Result<&dyn InputAdapter, PluginError> {
        match name {
            Some(name) => self.adapter(name).ok_or_else(|| self.no_such_adapter(name)),
            None => self.surest(source).ok_or_else(|| self.unclaimed()),
        }
    }

    fn surest(&self, source: &Source) -> Option<&dyn InputAdapter> {
        self.claims(source).into_iter().find(|c| c.confidence.percent > 0).map(|c| c.adapter)
    }

    fn no_such_adapter(&self, name: &str) -> PluginError {
        let names: Vec<_> = self.adapters().map(|(a, _)| a.info().name.as_str()).collect();
        PluginError::new(ErrorKind::BadOption, format!("there is no input adapter `{name}`")).advise(format!(
            "there are {}{}",
            names.join(", "),
            self.refused()
        ))
    }

    fn unclaimed(&self) -> PluginError {
        let error = PluginError::new(ErrorKind::Unsupported, "is no kind of document that planform knows");
        let refused = self.refused();
        // What the user installed says more than a list of formats.
        if let Some(refused) = refused.strip_prefix("; ") {
            return error.advise(refused);
        }
        let known: Vec<_> = self.adapters().flat_map(|(a, _)| a.info().extensions.iter().cloned()).collect();
        error.advise(format!("it reads {}; `--from` names the adapter to try anyway", known.join(", ")))
    }

    /// What might have helped and is not used, or failed when it was asked, as the end of a sentence.
    pub fn refused(&self) -> String {
        let refused =
            self.refusals().iter().chain(&self.outside().shadowed).map(|refusal| format!("; {refusal}"));
        let warnings = messages().into_iter().filter(|(_, (warning, _))| *warning);
        refused
            .chain(warnings.map(|(plugin, (_, message))| format!("; plugin `{plugin}`: {message}")))
            .collect()
    }
}
