//! `planform completions`.

use super::{Failure, command, failure::print};
use clap::Args;
use clap_complete::Shell;

const EXAMPLES: &str = "\
Examples:
  planform completions bash > ~/.local/share/bash-completion/completions/planform
  planform completions zsh > ~/.zfunc/_planform
  planform completions fish > ~/.config/fish/completions/planform.fish";

/// Print a script that teaches your shell to complete planform's commands
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct CompletionsArgs {
    /// The shell
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

pub fn run(args: &CompletionsArgs) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command(), "planform", &mut script);
    print(&script)
}
