//! Panels, captions and a legend, put together.

pub(crate) mod contact_sheet;
pub(crate) mod error;
pub(crate) mod layout;
pub(crate) mod picture;
pub(crate) mod size;
