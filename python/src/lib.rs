//! What the classes of the Python package `meshmend` are made of.
//!
//! The Python side (`python/meshmend`) has the classes that people see, the words of their arguments and how arrays come in; this
//! crate has the work. A call copies what it is given, works off the interpreter's lock (`watched`) in threads of its own
//! (`pool`), and gives whole arrays back. Nothing here borrows the memory of an array longer than it takes to copy it.

mod arrays;
mod check;
mod command;
mod defects;
mod document;
mod errors;
mod files;
mod how;
mod layers;
mod mesh;
mod panics;
mod picture;
mod plan;
mod pool;
mod record;
mod registries;
mod repair;
mod surfaces;
mod watched;
mod words;

use pyo3::prelude::*;

#[pymodule(gil_used = false)]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("SCHEMA", meshmend::report::SCHEMA)?;
    module.add_class::<mesh::MeshHandle>()?;
    module.add_class::<document::DocumentHandle>()?;
    module.add_class::<check::CheckHandle>()?;
    module.add_class::<defects::DefectList>()?;
    module.add_class::<surfaces::LoopsHandle>()?;
    module.add_class::<surfaces::CutHandle>()?;
    module.add_function(wrap_pyfunction!(surfaces::find_loops, module)?)?;
    module.add_function(wrap_pyfunction!(surfaces::cut_mesh, module)?)?;
    module.add_function(wrap_pyfunction!(surfaces::make, module)?)?;
    module.add_class::<plan::PlanHandle>()?;
    module.add_class::<repair::RepairHandle>()?;
    module.add_class::<record::RecordHandle>()?;
    module.add_function(wrap_pyfunction!(repair::repair_mesh, module)?)?;
    module.add_function(wrap_pyfunction!(repair::repair_document, module)?)?;
    module.add_function(wrap_pyfunction!(files::read, module)?)?;
    module.add_function(wrap_pyfunction!(files::write, module)?)?;
    module.add_function(wrap_pyfunction!(command::command_line, module)?)?;
    module.add_function(wrap_pyfunction!(check::check_mesh, module)?)?;
    module.add_function(wrap_pyfunction!(check::parts_json, module)?)?;
    module.add_function(wrap_pyfunction!(picture::picture, module)?)?;
    module.add_function(wrap_pyfunction!(registries::registries, module)?)?;
    module.add_function(wrap_pyfunction!(registries::explain, module)?)?;
    module.add_function(wrap_pyfunction!(registries::set_threads, module)?)?;
    module.add_function(wrap_pyfunction!(registries::threads, module)?)?;
    module.add_function(wrap_pyfunction!(registries::panic, module)?)?;
    Ok(())
}
