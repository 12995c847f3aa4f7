//! What a plugin may be called.

use crate::cli::Failure;
use crate::cli::plugins::all;
use crate::host::Registry;

/// Words that the Rust compiler or cargo keeps for itself. Those with an underscore are no names anyway.
const RESERVED: &str = "\
    abstract alloc as async await become box break build const continue core crate deps do dyn else enum \
    examples extern false final fn for gen if impl in incremental let loop macro match mod move mut \
    override priv proc-macro pub ref return self static std struct super test trait true try type typeof \
    unsafe unsized use virtual where while yield";

/// The longest name that planform takes.
const LONGEST: usize = 64;

/// Refuses what cannot be a plugin's name, or would be mistaken for another one.
pub fn check(name: &str) -> Result<(), Failure> {
    let refuse =
        |reason: String| Err(Failure::Usage(format!("a plugin cannot be called `{name}`: {reason}")));
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if name.len() > LONGEST || !name.starts_with(|c: char| c.is_ascii_lowercase()) || !name.chars().all(plain)
    {
        return refuse(format!(
            "give 1 to {LONGEST} lower-case letters, digits and hyphens, of which a letter comes first"
        ));
    }
    if RESERVED.split(' ').any(|word| word == name) || name == "planform-sdk" {
        return refuse("the Rust compiler or cargo keeps this word for itself; give another name".into());
    }
    match taken(name) {
        Some(plugin) => {
            refuse(format!("this is the name or an extension of the built-in plugin {plugin}; give another"))
        }
        None => Ok(()),
    }
}

/// The built-in plugin that has this name, or this extension, which would never be asked for this one's files.
fn taken(name: &str) -> Option<String> {
    let registry = Registry::builtin();
    let named = all(&registry).find(|l| l.info.name == name);
    let owner = named.or_else(|| all(&registry).find(|l| l.info.extensions.iter().any(|e| e == name)));
    owner.map(|l| l.info.name.clone())
}

#[cfg(test)]
mod tests {
    use super::check;

    #[test]
    fn names_are_checked() {
        for good in ["a", "my-plan", "plan2", "x-", &"a".repeat(64)] {
            assert!(check(good).is_ok(), "{good}");
        }
        let long = "a".repeat(65);
        for bad in [
            "",
            "2d",
            "-a",
            "My-plan",
            "my_plan",
            "a/b",
            "..",
            "plän",
            "fn",
            "proc-macro",
            "test",
            "svg",
            "png",
            &long,
        ] {
            assert!(check(bad).is_err(), "{bad}");
        }
    }
}
