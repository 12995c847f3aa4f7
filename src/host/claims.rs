//! Whose document is it? Every input adapter is asked, the surest one wins.

use super::{Registry, Setting, messages};
use planform_sdk::{Confidence, ErrorKind, InputAdapter, Kept, PluginError, Probe, Source};
use std::cmp::Reverse;
use std::ops::Range;

/// What one input adapter says of a document.
pub struct Claim<'a> {
    /// The adapter.
    pub adapter: &'a dyn InputAdapter,
    /// How sure its probe is that the document is its own.
    pub probe: Confidence,
    /// How sure it is after a closer look, if it was asked for one and took it.
    pub look: Option<Confidence>,
}

impl Claim<'_> {
    /// How sure the adapter is, all in all, percent.
    pub fn percent(&self) -> u8 {
        self.look.as_ref().unwrap_or(&self.probe).percent
    }
}

/// The adapter that reads a document.
pub struct Choice<'a> {
    /// The adapter.
    pub adapter: &'a dyn InputAdapter,
    /// What each adapter says of the document; none if they were not asked.
    pub claims: Option<Vec<Claim<'a>>>,
    /// What their looks at the document left for the one that reads it.
    pub kept: Kept,
}

/// How sure a built-in adapter must be for those from outside not to be asked, percent.
const SURE: u8 = 50;

/// Adapters whose probes are no further apart are about equally sure, percent.
const CLOSE: u8 = 20;

impl Registry {
    /// What each input adapter says of the document, the surest first and equally sure ones in the registry's order.
    /// Those from outside are asked only when no built-in one is sure. Where several are about as sure as the surest,
    /// each of these takes a closer look.
    pub fn claims(&self, source: &Source) -> Vec<Claim<'_>> {
        self.claims_and_kept(source).0
    }

    fn claims_and_kept(&self, source: &Source) -> (Vec<Claim<'_>>, Kept) {
        let probe = Probe::of(source);
        let claim = |adapter: &dyn InputAdapter| adapter.probe(&probe);
        let claim = |adapter| Claim { adapter, probe: claim(adapter), look: None };
        let mut claims: Vec<_> = self.builtin_adapters().map(claim).collect();
        if claims.iter().all(|c| c.probe.percent < SURE) {
            claims.extend(self.outside().adapters.iter().map(|a| a as &dyn InputAdapter).map(claim));
        }
        let tied = tied(&claims);
        let mut kept = Kept::default();
        claims
            .iter_mut()
            .filter(|c| tied.contains(&c.probe.percent))
            .for_each(|c| c.look = c.adapter.look(source, &mut kept));
        claims.sort_by_key(|c| Reverse(c.percent()));
        (claims, kept)
    }

    /// The input adapter for the document: the one named; or else, of those that are about as sure as the surest, the
    /// one that alone takes what is set; or else the surest.
    pub fn choose(
        &self,
        source: &Source,
        name: Option<&str>,
        settings: &[&Setting],
    ) -> Result<Choice<'_>, PluginError> {
        if let Some(name) = name {
            let adapter = self.adapter(name).ok_or_else(|| self.no_such_adapter(name))?;
            return Ok(Choice { adapter, claims: None, kept: Kept::default() });
        }
        let (claims, kept) = self.claims_and_kept(source);
        let surest = claims.first().filter(|c| c.percent() > 0).map(|c| c.adapter);
        let adapter = meant(&claims, settings).or(surest).ok_or_else(|| self.unclaimed())?;
        Ok(Choice { adapter, claims: Some(claims), kept })
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
        let mut known: Vec<String> = Vec::new();
        for extension in self.adapters().flat_map(|(a, _)| a.info().extensions.clone()) {
            if !known.contains(&extension) {
                known.push(extension);
            }
        }
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

/// What the probes of claims say that are about as sure as the surest, percent; nothing where that one stands alone.
fn tied(claims: &[Claim<'_>]) -> Range<u8> {
    let percents = || claims.iter().map(|c| c.probe.percent);
    let least = percents().max().unwrap_or(0).saturating_sub(CLOSE).max(SURE);
    if percents().filter(|p| *p >= least).count() > 1 { least..u8::MAX } else { 0..0 }
}

/// The one of the tied adapters that alone takes something that is set; none if two settings mean two adapters.
fn meant<'a>(claims: &[Claim<'a>], settings: &[&Setting]) -> Option<&'a dyn InputAdapter> {
    let tied = tied(claims);
    let tied = || claims.iter().filter(|c| tied.contains(&c.probe.percent)).map(|c| c.adapter);
    let sole = |setting: &&Setting| {
        let mut takers = tied().filter(|a| setting.is_for(a.info()));
        takers.next().filter(|_| takers.next().is_none())
    };
    let mut meant = settings.iter().filter_map(sole);
    let first = meant.next()?;
    meant.all(|other| other.info().name == first.info().name).then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{OptionSpec, Options, PluginInfo, Scene};

    struct Fixed {
        info: PluginInfo,
        probe: u8,
        look: Option<u8>,
    }

    impl InputAdapter for Fixed {
        fn info(&self) -> &PluginInfo {
            &self.info
        }

        fn probe(&self, _: &Probe<'_>) -> Confidence {
            Confidence::because(self.probe, "its head")
        }

        fn look(&self, _: &Source, _: &mut Kept) -> Option<Confidence> {
            assert!(self.look != Some(u8::MAX), "there is nothing to decide");
            self.look.map(|percent| Confidence::because(percent, "the whole"))
        }

        fn read(&self, _: &Source, _: &Options) -> Result<Scene, PluginError> {
            Err(PluginError::new(ErrorKind::Unsupported, "is never read"))
        }
    }

    /// A look that must not be asked for.
    const NEVER: Option<u8> = Some(u8::MAX);

    /// Adapters called a, b and so on. Each has an option of its own name and the option `both`.
    fn registry(adapters: &[(u8, Option<u8>)]) -> Registry {
        let adapter = |(name, (probe, look)): (char, &(u8, Option<u8>))| {
            let option = |name: &str| OptionSpec::flag(name, "", false);
            let info = PluginInfo {
                name: name.into(),
                description: String::new(),
                version: String::new(),
                licence: String::new(),
                extensions: vec![],
                media_types: vec![],
                options: vec![option(&name.to_string()), option("both")],
            };
            Box::new(Fixed { info, probe: *probe, look: *look }) as Box<dyn InputAdapter>
        };
        Registry::new(('a'..).zip(adapters).map(adapter).collect(), vec![])
    }

    fn chosen(adapters: &[(u8, Option<u8>)], name: Option<&str>, settings: &[&str]) -> String {
        let registry = registry(adapters);
        let settings: Vec<Setting> = settings.iter().map(|s| s.parse().unwrap()).collect();
        let source = Source { path: "x".into(), bytes: vec![1], byte_limit: 1 };
        let choice = registry.choose(&source, name, &settings.iter().collect::<Vec<_>>());
        choice.map_or_else(|e| e.message, |c| c.adapter.info().name.clone())
    }

    #[test]
    fn a_closer_look_decides_between_equals() {
        for (adapters, expected) in [
            ([(60, Some(30)), (60, Some(70))].as_slice(), "b"),
            (&[(60, None), (50, Some(70))], "b"),
            (&[(60, None), (50, Some(60))], "a"),
            (&[(70, Some(10)), (50, Some(20)), (20, NEVER)], "b"),
            // One stands alone, or none is sure.
            (&[(60, NEVER), (49, NEVER)], "a"),
            (&[(95, NEVER), (74, NEVER)], "a"),
            (&[(40, NEVER), (45, NEVER)], "b"),
            (&[(60, NEVER)], "a"),
            (&[(60, Some(0)), (60, Some(0))], "is no kind of document that planform knows"),
        ] {
            assert_eq!(chosen(adapters, None, &[]), expected, "{adapters:?}");
        }
    }

    #[test]
    fn what_is_set_can_say_which_adapter_is_meant() {
        let tied = [(60, Some(30)), (60, Some(70))];
        for (settings, expected) in [
            (["a=true"].as_slice(), "a"),
            (&["a.both=true"], "a"),
            (&["both=true"], "b"),
            (&["both=true", "a=true"], "a"),
            (&["unheard=of"], "b"),
            (&["a=true", "b=true"], "b"),
        ] {
            assert_eq!(chosen(&tied, None, settings), expected, "{settings:?}");
        }
        assert_eq!(chosen(&tied, Some("b"), &["a=true"]), "b");
        assert_eq!(chosen(&[(90, NEVER), (60, NEVER)], None, &["b=true"]), "a", "there is no tie");
    }

    #[test]
    fn both_answers_are_kept() {
        let registry = registry(&[(60, Some(30)), (60, None)]);
        let source = Source { path: "x".into(), bytes: vec![1], byte_limit: 1 };
        let claims = registry.claims(&source);
        let told = |c: &Claim<'_>| (c.probe.percent, c.look.as_ref().map(|l| l.percent), c.percent());
        assert_eq!(claims.iter().map(told).collect::<Vec<_>>(), [(60, None, 60), (60, Some(30), 30)]);
    }
}
