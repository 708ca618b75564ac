//! `denavit completions` and `denavit man`: shell completions and manual pages.

use std::path::{Path, PathBuf};

use clap::{Args, Command};
use clap_complete::Shell;

use super::Failure;
use super::files;

/// Write the completions of a shell to standard output.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  denavit completions bash > ~/.local/share/bash-completion/completions/denavit\n  denavit completions zsh > ~/.zfunc/_denavit\n  denavit completions fish > ~/.config/fish/completions/denavit.fish"
)]
pub(super) struct Completions {
    /// Shell.
    #[arg(value_enum)]
    shell: Shell,
}

impl Completions {
    pub(super) fn run(self, mut command: Command) -> Result<(), Failure> {
        let mut text = Vec::new();
        clap_complete::generate(self.shell, &mut command, "denavit", &mut text);
        files::print(&String::from_utf8_lossy(&text))
    }
}

/// Write the manual pages: one of the command, one of each verb.
#[derive(Args)]
#[command(after_help = "Example:\n  denavit man --out ~/.local/share/man/man1")]
pub(super) struct Man {
    /// Folder for `denavit.1`, `denavit-identify.1` and the others; without it the page of the
    /// command goes to standard output.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Man {
    pub(super) fn run(self, command: Command) -> Result<(), Failure> {
        let Some(folder) = self.out else {
            return files::print(&String::from_utf8_lossy(&page(command, "denavit")?));
        };
        files::create_folder(&folder, Path::new("denavit.1"))?;
        pages(command, &mut |file, text| files::write(&folder.join(format!("{file}.1")), text))?;
        files::print(&format!("wrote the manual pages into {}\n", folder.display()))
    }
}

/// Writes a page with its name.
type Writer<'a> = dyn FnMut(&str, &[u8]) -> Result<(), Failure> + 'a;

/// Writes the pages of a command and of its verbs, each with its name.
fn pages(mut command: Command, write: &mut Writer<'_>) -> Result<(), Failure> {
    command.build();
    let name = command.get_bin_name().unwrap_or_else(|| command.get_name()).replace(' ', "-");
    let verbs: Vec<Command> = command.get_subcommands().filter(|verb| verb.get_name() != "help").cloned().collect();
    write(&name, &page(command, &name)?)?;
    verbs.into_iter().try_for_each(|verb| pages(verb, write))
}

fn page(command: Command, name: &str) -> Result<Vec<u8>, Failure> {
    let mut text = Vec::new();
    clap_mangen::Man::new(command).title(name).render(&mut text).map_err(Failure::other)?;
    Ok(text)
}
