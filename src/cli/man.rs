//! `planform man`.

use super::{Failure, command, failure::print};
use clap::{Args, Command};
use clap_mangen::Man;
use std::io::{self, Write};

/// Print the manual page, with every command on it
#[derive(Args)]
#[command(after_help = "Example:\n  planform man > planform.1 && man ./planform.1")]
pub struct ManArgs {}

pub fn run(_: &ManArgs) -> Result<(), Failure> {
    let page = page().map_err(|e| Failure::of_io("manual page", e))?;
    print(page.as_bytes())
}

fn page() -> io::Result<String> {
    let mut program = command();
    program.build();
    let man = Man::new(program.clone());
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    page.extend(sections(&program)?.into_bytes());
    for verb in verbs(&program) {
        let name = verb.get_bin_name().unwrap_or(verb.get_name());
        writeln!(page, ".SH \"{}\"", name.to_uppercase())?;
        page.extend(sections(verb)?.replace(".SH ", ".SS ").into_bytes());
    }
    man.render_version_section(&mut page)?;
    Ok(String::from_utf8_lossy(&page).into_owned())
}

/// All commands below this one, each before those below it.
fn verbs(command: &Command) -> Vec<&Command> {
    let below = command.get_subcommands().filter(|v| v.get_name() != "help");
    below.flat_map(|verb| std::iter::once(verb).chain(verbs(verb))).collect()
}

/// What a page of the command's own would say, without title, name and version. The examples keep their lines.
fn sections(command: &Command) -> io::Result<String> {
    let man = Man::new(command.clone());
    let (mut text, mut examples) = (Vec::new(), Vec::new());
    man.render_description_section(&mut text)?;
    man.render_synopsis_section(&mut text)?;
    man.render_options_section(&mut text)?;
    man.render_extra_section(&mut examples)?;
    let examples = String::from_utf8_lossy(&examples).replace(".SH EXTRA", ".SH EXAMPLES\n.nf");
    let examples = examples.replacen("\nExamples:\n", "\n", 1).replacen("\nExample:\n", "\n", 1);
    Ok(format!("{}{examples}.fi\n", String::from_utf8_lossy(&text)))
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_verb_and_option_is_on_the_page() {
        let page = super::page().unwrap();
        for text in
            ["PLANFORM CONVERT", "PLANFORM INSPECT", "PLANFORM PLUGINS NEW", "resolution", ".SH EXAMPLES"]
        {
            assert!(page.contains(text), "{text} is missing");
        }
        assert!(!page.contains("\nExample"), "the heading is doubled");
    }
}
