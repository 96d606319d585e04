//! Where is everything that is wrong?

mod defect_list;
mod items;
mod survey;

pub use defect_list::DefectList;
