//! From which aspect on a triangle is a sliver.

use serde::{Deserialize, Deserializer, de};

/// An aspect that is one.
///
/// # Errors
/// When it is not a finite number of 1 or more.
pub(super) fn checked(aspect: f64) -> Result<f64, String> {
    if aspect.is_finite() && aspect >= 1.0 {
        Ok(aspect)
    } else {
        Err(format!("an aspect must be a finite number of 1 or more, not {aspect}"))
    }
}

/// Reads an aspect.
pub(super) fn aspect<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    checked(f64::deserialize(deserializer)?).map_err(de::Error::custom)
}
