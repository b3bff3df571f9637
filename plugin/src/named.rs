//! Enums whose variants have names in files, commands and menus.

/// Makes an enum of named variants from one table: its declaration, the list of all, their names,
/// and the ways back from a name and from a number.
macro_rules! named_enum {
    (
        $(#[$attribute:meta])*
        $visibility:vis enum $name:ident {
            $( $(#[$of_variant:meta])* $variant:ident = $text:literal, )+
        }
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, bevy::reflect::Reflect)]
        #[repr(u8)]
        $visibility enum $name {
            $( $(#[$of_variant])* $variant, )+
        }

        impl $name {
            /// All of them, in order.
            $visibility const ALL: [Self; Self::COUNT] = [$( Self::$variant, )+];

            /// How many there are.
            $visibility const COUNT: usize = [$( $text, )+].len();

            /// Its name in files, commands and menus.
            $visibility const fn name(self) -> &'static str {
                match self {
                    $( Self::$variant => $text, )+
                }
            }

            /// The one with this name.
            $visibility fn from_name(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|one| one.name() == name)
            }

            /// The one with this number, counted from 0, as files store it.
            $visibility fn from_u8(number: u8) -> Option<Self> {
                Self::ALL.get(usize::from(number)).copied()
            }
        }
    };
}

pub(crate) use named_enum;

#[cfg(test)]
mod tests {
    named_enum! {
        /// Directions of the wind.
        enum Wind {
            /// From the north.
            North = "north",
            /// From the south-east.
            SouthEast = "south_east",
        }
    }

    #[test]
    fn names_and_numbers_lead_back() {
        assert_eq!(Wind::COUNT, 2);
        for (number, wind) in Wind::ALL.into_iter().enumerate() {
            assert_eq!(wind as usize, number);
            assert_eq!(Wind::from_u8(number as u8), Some(wind));
            assert_eq!(Wind::from_name(wind.name()), Some(wind));
        }
        assert_eq!(Wind::from_u8(2), None);
        assert_eq!(Wind::from_name("east"), None);
    }
}
