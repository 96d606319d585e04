//! What any kernel must do.

mod kernel;
mod same;

pub use kernel::{heap_law, kernel_laws, refusal_law};
