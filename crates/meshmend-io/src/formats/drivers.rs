//! Which driver reads and writes which format.

use crate::Format;
use crate::formats::driver::Driver;

macro_rules! table {
    ($($(#[doc = $doc:literal])* $(#[cfg($only:meta)])? $format:ident => $folder:ident,)*) => {
        /// The driver of a format.
        pub(crate) fn driver(format: Format) -> &'static Driver {
            match format {
                $($(#[cfg($only)])? Format::$format => &crate::formats::$folder::DRIVER,)*
            }
        }
    };
}

with_formats!(table);
