//! `meshmend explain`: the words of reports, in sentences.

use clap::Args;
use meshmend::passes::Passes;
use meshmend::{KernelKind, Rules};

use crate::console::Console;
use crate::failure::{Failure, Status};
use crate::render;

/// Explain a kind of defect, a pass or a kernel; without a name, list them all
#[derive(Debug, Args)]
pub(crate) struct Explain {
    /// The name, as it stands in reports
    #[arg(value_name = "NAME")]
    name: Option<String>,
}

impl Explain {
    pub(crate) fn run(
        self,
        rules: Rules,
        passes: Passes,
        console: &mut Console<'_>,
    ) -> Result<Status, Failure> {
        let style = console.style();
        let text = match self.name.as_deref() {
            None => render::glossary(rules, passes, style),
            Some(name) => entry(rules, passes, name)
                .map(|(heading, text)| render::explanation(&heading, text, style))
                .ok_or_else(|| {
                    Failure::usage(format!(
                        "there is no kind of defect, pass or kernel `{name}`; `meshmend explain` lists them"
                    ))
                })?,
        };
        console.write(&text)?;
        Ok(Status::Done)
    }
}

/// A heading and an explanation.
fn entry(rules: Rules, passes: Passes, name: &str) -> Option<(String, &'static str)> {
    let defect = rules.kind(name).map(|kind| (render::defect_heading(kind), kind.explanation()));
    let pass = || passes.kind(name).map(|pass| (format!("{pass}: a pass"), pass.explanation()));
    let kernel =
        || KernelKind::from_name(name).map(|kernel| (format!("{kernel}: a kernel"), kernel.explanation()));
    defect.or_else(pass).or_else(kernel)
}
