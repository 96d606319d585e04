//! The formats: a folder each, and a row each in the registry (`rows.rs`).
//!
//! A folder has two things that others ask for: `facts::FACTS`, what is known of the format, and `DRIVER`, what reads
//! and writes it. [`Format`](crate::Format) is made of the facts alone, and only [`drivers`] knows the drivers.

#[macro_use]
mod rows;

pub(crate) mod driver;
pub(crate) mod drivers;
pub(crate) mod encoding;
pub(crate) mod facts;
pub(crate) mod foreign;
pub(crate) mod format;
#[cfg(test)]
mod tests;

macro_rules! folders {
    ($($(#[doc = $doc:literal])* $(#[cfg($only:meta)])? $format:ident => $folder:ident,)*) => {
        $($(#[cfg($only)])? pub(crate) mod $folder;)*
    };
}

with_formats!(folders);
