//! The columns of the crust (paper 000, Table 1), one entry per sample of the lattice.
//!
//! One table names each column once, with its type, default, limits and tag in save files. From it
//! follow [`Crust`] (a vector per column), [`CrustRow`] (a value per column), [`CrustChunk`] (a
//! slice per column, for parallel sweeps), comparison, copies and files. A new column is one entry:
//! rows that do not name it have its default, and so have saves from before it, unless it is
//! required.

use super::kinds::{CrustKind, Orogeny};
use super::value::{ColumnError, ColumnValue, decode_column, encode_column};
use crate::ids::FrameId;
use crate::parallel::CHUNK;
use crate::params::TectonicParams;
use bevy::prelude::*;
use core::ops::Range;

/// A column as files and messages know it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnInfo {
    /// Name of the field.
    pub name: &'static str,
    /// Tag of its section in a save file.
    pub tag: &'static [u8; 4],
    /// Name in messages.
    pub label: &'static str,
    /// Smallest value that a file may hold, component by component.
    pub min: f32,
    /// Largest value that a file may hold.
    pub max: f32,
    /// Bytes of a value.
    pub bytes: usize,
    /// Whether a file must hold it. A column may be left out if its default claims nothing, as a
    /// direction of zero does.
    pub is_required: bool,
}

macro_rules! columns {
    ($( $(#[doc = $doc:literal])+ $name:ident: $kind:ty = $default:expr, $label:literal, $tag:literal, $min:literal..$max:literal, required: $required:literal; )+) => {
        /// The state of the crust: a column per quantity, an entry per sample,
        /// [`BYTES`](Self::BYTES) bytes a sample.
        ///
        /// Samples never move. A sample's direction and its two vectors are given in the
        /// coordinates of its [`Frame`](super::Frame); the frame's rotation takes them to where the
        /// crust is now.
        ///
        /// ```
        /// use bevy_pangaea::prelude::*;
        ///
        /// let recipe = PlanetRecipe { samples: 500, ..Default::default() };
        /// let crust = PlanetState::new(&recipe)?.crust;
        /// let highest = crust.elevation.iter().copied().fold(f32::MIN, f32::max);
        /// assert!(highest > 0.0 && crust.len() == 500);
        /// // A row has all that is known of a sample.
        /// assert_eq!(crust.row(7).kind == CrustKind::Continental, crust.is_continental(7));
        /// # Ok::<(), PlanetError>(())
        /// ```
        #[derive(Component, Clone, Debug, Default, PartialEq, Reflect)]
        #[reflect(Component, Default)]
        pub struct Crust {
            $( $(#[doc = $doc])+ pub $name: Vec<$kind>, )+
        }

        /// The crust at one sample: a value of every column of [`Crust`].
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct CrustRow {
            $( $(#[doc = $doc])+ pub $name: $kind, )+
        }

        /// A run of samples with a slice of every column, for sweeps that write.
        #[derive(Debug)]
        pub struct CrustChunk<'a> {
            /// Number of the first sample.
            pub start: usize,
            $( $(#[doc = $doc])+ pub $name: &'a mut [$kind], )+
        }

        impl Crust {
            /// All columns, in the order of files.
            pub const COLUMNS: &'static [ColumnInfo] = &[
                $( ColumnInfo {
                    name: stringify!($name),
                    tag: $tag,
                    label: $label,
                    min: $min,
                    max: $max,
                    bytes: <$kind as ColumnValue>::BYTES,
                    is_required: $required,
                }, )+
            ];

            /// Bytes of a sample.
            pub const BYTES: usize = 0 $( + <$kind as ColumnValue>::BYTES )+;

            /// `n` samples that are all alike.
            pub fn uniform(n: usize, row: &CrustRow) -> Self {
                Self { $( $name: vec![row.$name; n], )+ }
            }

            /// The crust at sample `i`.
            #[inline]
            pub fn row(&self, i: usize) -> CrustRow {
                CrustRow { $( $name: self.$name[i], )+ }
            }

            /// Stores the crust at sample `i`.
            #[inline]
            pub fn set_row(&mut self, i: usize, row: &CrustRow) {
                $( self.$name[i] = row.$name; )+
            }

            /// Takes over all samples of another crust into memory that is already there.
            pub fn copy_from(&mut self, from: &Self) {
                rayon::scope(|scope| {
                    $( scope.spawn(|_| self.$name.clone_from(&from.$name)); )+
                });
            }

            /// The samples of `range`, which begins at a whole chunk, cut into chunks of
            /// [`CHUNK`].
            pub fn chunks_mut(&mut self, range: Range<usize>) -> Vec<CrustChunk<'_>> {
                let starts = range.clone().step_by(CHUNK);
                $( let mut $name = self.$name[range.clone()].chunks_mut(CHUNK); )+
                starts
                    .map(|start| CrustChunk {
                        start,
                        $( $name: $name.next().unwrap_or_default(), )+
                    })
                    .collect()
            }

            /// Names of the columns that differ from another crust's.
            pub fn differences(&self, other: &Self) -> Vec<&'static str> {
                let mut names = Vec::new();
                $( if self.$name != other.$name {
                    names.push(stringify!($name));
                } )+
                names
            }

            /// Every column as bytes, in the order of [`COLUMNS`](Self::COLUMNS).
            pub fn encode_columns(&self) -> Vec<Vec<u8>> {
                vec![ $( encode_column(&self.$name), )+ ]
            }

            /// The crust of `n` samples that columns of bytes hold, in the order of
            /// [`COLUMNS`](Self::COLUMNS). One that is left out has its default.
            ///
            /// # Errors
            /// [`ColumnError`] names the column and the sample.
            pub fn decode_columns(
                columns: &[Option<&[u8]>],
                n: usize,
            ) -> Result<Self, ColumnError> {
                if columns.len() != Self::COLUMNS.len() {
                    return Err(ColumnError::Count {
                        found: columns.len(),
                        expected: Self::COLUMNS.len(),
                    });
                }
                let mut columns = columns.iter().zip(Self::COLUMNS);
                $( let $name = match columns.next() {
                    Some((&bytes, info)) => decode_or_default(bytes, n, info, $default)?,
                    None => Vec::new(),
                }; )+
                Ok(Self { $( $name, )+ })
            }
        }

        impl CrustRow {
            /// The default of every column.
            const DEFAULT: Self = Self { $( $name: $default, )+ };
        }

        impl CrustChunk<'_> {
            /// The crust at the chunk's sample `k`.
            #[inline]
            pub fn row(&self, k: usize) -> CrustRow {
                CrustRow { $( $name: self.$name[k], )+ }
            }

            /// Stores the crust at the chunk's sample `k`.
            #[inline]
            pub fn set_row(&mut self, k: usize, row: &CrustRow) {
                $( self.$name[k] = row.$name; )+
            }
        }
    };
}

columns! {
    /// The frame that carries the sample.
    frame: FrameId = 0, "frame", b"FRAM", 0.0..65_535.0, required: true;
    /// Type of the crust x_C.
    kind: CrustKind = CrustKind::Oceanic, "crust type", b"KIND", 0.0..1.0, required: true;
    /// Thickness e in km.
    thickness: f32 = 0.0, "thickness", b"THIC", -1.0..1000.0, required: true;
    /// Elevation z of the unbent crust above sea level in km; trenches are a derived offset.
    elevation: f32 = 0.0, "elevation", b"ELEV", -100.0..100.0, required: true;
    /// Age a_o of oceanic crust since it left its ridge in My.
    ocean_age: f32 = 0.0, "ocean age", b"OAGE", 0.0..1e6, required: true;
    /// Unit vector r parallel to the ridge that made the crust; zero where unknown.
    ridge: Vec3 = Vec3::ZERO, "ridge direction", b"RIDG", -1.001..1.001, required: false;
    /// Time a_c since the last folding in My.
    orogeny_age: f32 = 0.0, "orogeny age", b"FAGE", 0.0..1e6, required: true;
    /// Type o of the last folding.
    orogeny: Orogeny = Orogeny::None, "orogeny", b"OROG", 0.0..2.0, required: true;
    /// Fold direction f: a tangent vector, unit length once folded, zero before or where unknown.
    fold: Vec3 = Vec3::ZERO, "fold direction", b"FOLD", -1.001..1.001, required: false;
}

/// The column of `n` values that `bytes` hold, or its default if it may be left out.
fn decode_or_default<T: ColumnValue>(
    bytes: Option<&[u8]>,
    n: usize,
    info: &ColumnInfo,
    default: T,
) -> Result<Vec<T>, ColumnError> {
    match bytes {
        Some(bytes) => decode_column(bytes, n, info.label, info.min..=info.max),
        None if info.is_required => Err(ColumnError::Missing(info.label)),
        None => Ok(vec![default; n]),
    }
}

impl CrustRow {
    /// Abyssal ocean floor on frame 0, of age 0 and never folded.
    pub fn ocean(params: &TectonicParams) -> Self {
        Self {
            thickness: params.ocean_thickness as f32,
            elevation: params.abyss_elevation as f32,
            ..Self::DEFAULT
        }
    }
}

impl Crust {
    /// `n` samples of [abyssal ocean floor](CrustRow::ocean).
    pub fn ocean(n: usize, params: &TectonicParams) -> Self {
        Self::uniform(n, &CrustRow::ocean(params))
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.frame.len()
    }

    /// Whether there are no samples.
    pub fn is_empty(&self) -> bool {
        self.frame.is_empty()
    }

    /// Whether sample `i` is continental.
    #[inline]
    pub fn is_continental(&self, i: usize) -> bool {
        self.kind[i] == CrustKind::Continental
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Crust with another value at every sample of every column.
    fn varied(n: usize) -> Crust {
        let mut crust = Crust::ocean(n, &default());
        for i in 0..n {
            let x = i as f32 / n as f32;
            crust.set_row(
                i,
                &CrustRow {
                    frame: i as FrameId,
                    kind: CrustKind::from_u8(i as u8 % 2).unwrap(),
                    thickness: 7.0 + x,
                    elevation: -x,
                    ocean_age: 100.0 * x,
                    ridge: Vec3::new(x, 0.0, -x),
                    orogeny_age: 3.0 * x,
                    orogeny: Orogeny::from_u8(i as u8 % 3).unwrap(),
                    fold: Vec3::new(0.0, x, 0.5),
                },
            );
        }
        crust
    }

    /// Columns of bytes as a file with all of them has them.
    fn all(columns: &[Vec<u8>]) -> Vec<Option<&[u8]>> {
        columns.iter().map(|column| Some(&column[..])).collect()
    }

    #[test]
    fn a_sample_has_as_many_bytes_as_its_values() {
        assert_eq!(Crust::BYTES, 2 + 1 + 4 + 4 + 4 + 12 + 4 + 1 + 12);
    }

    #[test]
    fn columns_survive_files_and_copies() {
        let crust = varied(3000);
        let columns = crust.encode_columns();
        assert_eq!(Crust::decode_columns(&all(&columns), 3000).unwrap(), crust);
        let mut copy = Crust::default();
        copy.copy_from(&crust);
        assert!(copy.differences(&crust).is_empty());
        copy.fold[7] = Vec3::X;
        copy.frame[9] = 1;
        assert_eq!(copy.differences(&crust), ["frame", "fold"]);
    }

    #[test]
    fn chunks_hold_every_sample_once() {
        let (mut crust, n) = (varied(5000), 5000);
        let whole = crust.clone();
        let mut seen = 0;
        for mut chunk in crust.chunks_mut(0..n) {
            for k in 0..chunk.frame.len() {
                let row = chunk.row(k);
                assert_eq!(row, whole.row(chunk.start + k));
                chunk.set_row(k, &CrustRow { frame: 3, ..row });
                seen += 1;
            }
        }
        assert_eq!(seen, n);
        assert!(crust.frame.iter().all(|&frame| frame == 3));
        let later = crust.chunks_mut(2 * CHUNK..n);
        assert_eq!(
            (later[0].start, later[0].frame.len()),
            (2 * CHUNK, n - 2 * CHUNK)
        );
    }

    /// The refusal of ten samples with some bytes of column `k` replaced from `at` on.
    fn refused(k: usize, at: usize, with: &[u8]) -> String {
        let mut columns = varied(10).encode_columns();
        columns[k][at..at + with.len()].copy_from_slice(with);
        let refused = Crust::decode_columns(&all(&columns), 10);
        refused.unwrap_err().to_string()
    }

    #[test]
    fn refused_columns_name_the_sample() {
        let columns = varied(10).encode_columns();
        assert_eq!(refused(1, 4, &[2]), "unknown crust type of sample 4");
        let nan = f32::NAN.to_le_bytes();
        assert_eq!(refused(2, 8, &nan), "thickness of sample 2 is NaN");
        let long = 1.5_f32.to_le_bytes();
        assert_eq!(refused(8, 16, &long), "fold direction of sample 1 is 1.5");
        let bytes = all(&columns);
        assert_eq!(
            Crust::decode_columns(&bytes, 11).unwrap_err().to_string(),
            "the column of frame has the wrong length"
        );
        assert!(Crust::decode_columns(&bytes[1..], 10).is_err());
    }

    #[test]
    fn columns_that_are_left_out_have_their_defaults_or_are_named() {
        let crust = varied(10);
        let columns = crust.encode_columns();
        for (k, info) in Crust::COLUMNS.iter().enumerate() {
            let mut bytes = all(&columns);
            bytes[k] = None;
            let read = Crust::decode_columns(&bytes, 10);
            if info.is_required {
                assert_eq!(read, Err(ColumnError::Missing(info.label)));
                continue;
            }
            let read = read.unwrap();
            assert_eq!(read.differences(&crust), [info.name]);
            assert!(read.ridge == crust.ridge || read.ridge == [Vec3::ZERO; 10]);
            assert!(read.fold == crust.fold || read.fold == [Vec3::ZERO; 10]);
        }
    }
}
