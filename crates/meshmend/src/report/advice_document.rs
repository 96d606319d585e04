//! The document of an advice.

use meshmend_repair::Advice;
use serde::Serialize;

use super::SCHEMA;

/// Which weld tolerance stands out in the mesh of a file.
#[derive(Clone, Debug, Serialize)]
pub struct AdviceDocument {
    /// The number of this form.
    pub schema: u32,
    /// The file.
    pub file: String,
    /// Which form of which format the file has.
    pub format: &'static str,
    /// What `--weld` has to be for it; `None` if nothing stands out.
    pub option: Option<String>,
    /// What was found.
    #[serde(flatten)]
    pub advice: Advice,
}

/// A number as people write it: `0.0021`, `9.3e-17`.
pub fn short(number: f64) -> String {
    const LONGEST: usize = 8;
    let plain = number.to_string();
    if plain.len() > LONGEST { format!("{number:e}") } else { plain }
}

impl AdviceDocument {
    /// The document of the advice on a file.
    pub fn new(file: String, format: &'static str, advice: Advice) -> Self {
        let option = advice.tolerance.map(|tolerance| format!("boundary:{}", short(tolerance.distance)));
        AdviceDocument { schema: SCHEMA, file, format, option, advice }
    }
}
