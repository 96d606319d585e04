//! How much is tried, and for how long.

use std::time::Duration;

use serde::{Deserialize, Serialize};

/// Over how many meshes a kernel is asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Effort {
    /// Sets of triangles over up to four vertices, small tables, shapes, and 200 random tables.
    Quick,
    /// Sets over up to five vertices, and 2 000 random tables.
    #[default]
    Usual,
    /// As usual, with 20 000 random tables.
    Thorough,
}

/// How the laws of a kernel are asked.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Settings {
    /// Over how many meshes.
    pub effort: Effort,
    /// How long a kernel may take for one law on one mesh.
    pub patience: Duration,
    /// Whether the laws run in the process that asks, unguarded against what never ends.
    pub in_process: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { effort: Effort::Usual, patience: Duration::from_secs(10), in_process: false }
    }
}

impl Settings {
    /// What the environment says: `MESHMEND_EFFORT` (`quick`, `usual` or `thorough`), `MESHMEND_PATIENCE` (seconds) and
    /// `MESHMEND_IN_PROCESS` (`1`).
    ///
    /// # Errors
    /// A value that is none of these, with those that there are.
    pub fn from_environment() -> Result<Self, String> {
        let mut settings = Settings::default();
        let value = |name| std::env::var(name).ok().filter(|value| !value.is_empty());
        if let Some(effort) = value("MESHMEND_EFFORT") {
            settings.effort = effort_named(&effort)?;
        }
        if let Some(seconds) = value("MESHMEND_PATIENCE") {
            settings.patience = patience_of(&seconds)?;
        }
        if let Some(answer) = value("MESHMEND_IN_PROCESS") {
            settings.in_process = answer != "0";
        }
        Ok(settings)
    }

    /// The same with another effort.
    #[must_use]
    pub fn with_effort(self, effort: Effort) -> Self {
        Settings { effort, ..self }
    }

    /// The same with another patience.
    #[must_use]
    pub fn with_patience(self, patience: Duration) -> Self {
        Settings { patience, ..self }
    }

    /// The same, run in the process that asks.
    #[must_use]
    pub fn in_process(self) -> Self {
        Settings { in_process: true, ..self }
    }
}

fn effort_named(word: &str) -> Result<Effort, String> {
    match word {
        "quick" => Ok(Effort::Quick),
        "usual" => Ok(Effort::Usual),
        "thorough" => Ok(Effort::Thorough),
        other => Err(format!("MESHMEND_EFFORT is {other:?} and should be quick, usual or thorough")),
    }
}

fn patience_of(seconds: &str) -> Result<Duration, String> {
    let patience = seconds.parse().ok().and_then(|seconds: f64| Duration::try_from_secs_f64(seconds).ok());
    let wrong = || format!("MESHMEND_PATIENCE is {seconds:?} and should be a number of seconds above 0");
    patience.filter(|patience| !patience.is_zero()).ok_or_else(wrong)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_the_environment_are_taken_or_refused_with_those_that_there_are() {
        assert_eq!(effort_named("thorough"), Ok(Effort::Thorough));
        assert!(effort_named("Quick").unwrap_err().ends_with("should be quick, usual or thorough"));
        assert_eq!(patience_of("0.5"), Ok(Duration::from_millis(500)));
        for wrong in ["0", "-1", "ten", "inf", "NaN", "1e99"] {
            assert!(patience_of(wrong).unwrap_err().contains("a number of seconds"), "{wrong}");
        }
    }
}
