//! The form of the tables of codes.

/// One code with what a reader needs to know of it.
pub(super) struct CodeEntry {
    /// Code on the wire, `area/kind`.
    pub(super) code: &'static str,
    /// Meaning, in a sentence.
    pub(super) meaning: &'static str,
    /// Usual fix, in a sentence; empty where there is nothing to mend.
    pub(super) fix: &'static str,
}

impl CodeEntry {
    /// Returns the part of the code before the stroke.
    pub(super) fn area(&self) -> &'static str {
        self.code.split('/').next().unwrap_or_default()
    }
}

/// Makes the enum of the codes of one area: each variant with its kind on the wire, its meaning and
/// the usual fix.
macro_rules! fault_codes {
    (
        $(#[$doc:meta])*
        $name:ident in $area:literal {
            $($variant:ident = $kind:literal: $meaning:literal $(, $fix:literal)?;)*
        }
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name {
            $(
                #[doc = $meaning]
                $variant,
            )*
        }

        impl $name {
            /// All codes of this area.
            pub(super) const TABLE: &'static [super::table::CodeEntry] = &[
                $(super::table::CodeEntry {
                    code: concat!($area, "/", $kind),
                    meaning: $meaning,
                    fix: concat!($($fix)?),
                },)*
            ];

            /// Returns the code on the wire.
            pub const fn as_str(self) -> &'static str {
                match self {
                    $(Self::$variant => concat!($area, "/", $kind),)*
                }
            }
        }

        impl From<$name> for super::FaultCode {
            fn from(code: $name) -> Self {
                Self::from_table(code.as_str())
            }
        }

        impl PartialEq<$name> for super::FaultCode {
            fn eq(&self, code: &$name) -> bool {
                self.as_str() == code.as_str()
            }
        }
    };
}

pub(super) use fault_codes;
