//! The editor keeps every law of editors.

meshmend_conformance::editor!(editor: meshmend_testkit::edits::Indexed);
