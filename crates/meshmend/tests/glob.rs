//! All names of the facade can be imported at once.

use meshmend::*;

#[test]
fn a_glob_import_hides_no_name_of_the_language() {
    let version = core::option_env!("CARGO_PKG_VERSION");
    assert!(version.is_some());
    // The function and the module of its passes have names of their own.
    let _: fn(&PolygonMesh) -> Result<Repaired, PassError> = repair;
    assert_eq!(passes::PassKind::ALL, PassKind::ALL);
}
