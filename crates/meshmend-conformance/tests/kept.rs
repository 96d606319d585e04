//! The default kernel keeps every law.

use meshmend_core::EdgeUse;

meshmend_conformance::kernel!(edge_use: EdgeUse, at_least = PERMISSIVE);
