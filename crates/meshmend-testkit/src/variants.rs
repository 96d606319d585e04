//! That every way to fail is seen to fail, and says what it should.

/// Checks that each variant of an error has a case, and that each case shows its message.
///
/// The variants are listed in a `match`: a new one doesn't compile until it is named, and then fails until some case
/// raises it. An error is given with its message, as a list of `(error, message)`.
///
/// ```
/// # #[derive(Debug)]
/// enum Weather { Rain, Hail { size: u8 } }
/// # impl std::fmt::Display for Weather {
/// #     fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
/// #         match self {
/// #             Weather::Rain => f.write_str("it rains"),
/// #             Weather::Hail { size } => write!(f, "stones of {size} mm fall"),
/// #         }
/// #     }
/// # }
/// let cases = vec![(Weather::Rain, "it rains"), (Weather::Hail { size: 3 }, "stones of 3 mm fall")];
/// meshmend_testkit::assert_every_variant!(cases, Weather { Rain, Hail });
/// ```
///
/// # Panics
/// When a message is another one, or a variant has no case.
#[macro_export]
macro_rules! assert_every_variant {
    ($cases:expr, $error:ident { $($variant:ident),+ $(,)? }) => {{
        let name = |error: &$error| match error {
            $($error::$variant { .. } => stringify!($variant),)+
        };
        let mut unseen = ::std::vec![$(stringify!($variant)),+];
        for (error, message) in &$cases {
            ::std::assert_eq!(error.to_string(), &message[..], "{}", name(error));
            unseen.retain(|variant| *variant != name(error));
        }
        ::std::assert!(unseen.is_empty(), "no case raises {unseen:?}");
    }};
}
