//! What there is by name: kinds, passes and their options, kernels, formats. The Python side and its types are made from it.

use meshmend::passes::{OptionValues, PRESETS, Passes};
use meshmend::shapes::NAMED_SHAPES;
use meshmend::{DefectKind, Format, KernelKind, Kernels, PassKind, Question, Rules};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::how::{self, How};
use crate::words;

/// Every list of names, and every option of a repair.
#[pyfunction]
pub(crate) fn registries(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    all.set_item("kinds", Rules::builtin().kinds().map(DefectKind::code).collect::<Vec<_>>())?;
    all.set_item("passes", Passes::builtin().kinds().into_iter().map(PassKind::name).collect::<Vec<_>>())?;
    all.set_item("kernels", Kernels::builtin().all().map(|kernel| kernel.name).collect::<Vec<_>>())?;
    all.set_item("questions", Question::ALL.map(Question::name))?;
    all.set_item("shapes", NAMED_SHAPES.iter().map(|shape| shape.name).collect::<Vec<_>>())?;
    all.set_item("repair_kernels", KernelKind::ALL.iter().map(|kernel| kernel.name()).collect::<Vec<_>>())?;
    all.set_item("presets", PRESETS.map(|preset| preset.name))?;
    all.set_item("witnesses", words::WITNESSES.map(|(name, _)| name))?;
    let variants =
        Format::ALL.iter().flat_map(|format| format.encodings().iter().map(|&e| format.variant(e)));
    all.set_item("variants", variants.collect::<Vec<_>>())?;
    let extensions = Format::ALL.iter().flat_map(|format| format.extensions()).copied();
    all.set_item("formats", extensions.collect::<Vec<_>>())?;
    let options = PyDict::new(py);
    for (pass, option) in Passes::builtin().options() {
        options.set_item(option.name, (takes(&option.values), words_of(pass, option), option.help))?;
    }
    all.set_item("options", options)?;
    Ok(all)
}

/// What an option can be, in a word.
fn takes(values: &OptionValues) -> &'static str {
    match values {
        OptionValues::Words(_) => "words",
        OptionValues::Flag(_) => "flag",
        OptionValues::Aspect => "number",
        OptionValues::Distance | OptionValues::Reach => "length",
        OptionValues::Limits | OptionValues::ComponentLimit => "limits",
    }
}

/// The words that an option can be, if it has some.
fn words_of(pass: PassKind, option: &meshmend::passes::PassOption) -> Vec<&'static str> {
    let off = (option.name == pass.name()).then_some("off");
    match option.values {
        OptionValues::Words(words) => words.iter().map(|word| word.name).chain(off).collect(),
        OptionValues::Flag(word) => vec![word],
        _ => off.into_iter().collect(),
    }
}

/// The page of a name, as the command prints it.
#[pyfunction]
pub(crate) fn explain(py: Python<'_>, name: &str, how: How<'_>) -> PyResult<String> {
    let (status, out, errors) = how.watched(py)?.run(|_| {
        let (mut out, mut errors) = (Vec::new(), Vec::new());
        let mut console = meshmend_cli::Console::of(&mut out, &mut errors);
        let status = meshmend_cli::run(["meshmend", "explain", "--", name], &mut console);
        drop(console);
        (status, out, errors)
    })?;
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    match status {
        meshmend_cli::Status::Done => Ok(text(out)),
        _ => Err(PyValueError::new_err(text(errors).trim_end().trim_start_matches("meshmend: ").to_owned())),
    }
}

/// Sets how many threads calls have that do not say it.
#[pyfunction]
pub(crate) fn set_threads(count: Option<i64>) -> PyResult<()> {
    crate::pool::set_default(count.map(how::threads).transpose()?);
    Ok(())
}

/// How many threads calls have that do not say it.
#[pyfunction]
pub(crate) fn threads() -> usize {
    crate::pool::usual()
}

/// A mistake, for the test of what becomes of one.
#[pyfunction]
#[pyo3(name = "_panic")]
#[expect(clippy::panic, reason = "it is what is tested")]
pub(crate) fn panic(py: Python<'_>, how: How<'_>) -> PyResult<()> {
    how.watched(py)?.run(|_| std::panic::panic_any("a mistake, as it was asked for"))
}
