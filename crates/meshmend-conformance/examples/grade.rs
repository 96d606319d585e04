//! A program for graders: all verdicts on a kernel as one JSON document.
//!
//! ```sh
//! cargo run -p meshmend-conformance --example grade
//! ```

use meshmend_core::EdgeUse;

meshmend_conformance::grade!(EdgeUse, at_least = PERMISSIVE);
