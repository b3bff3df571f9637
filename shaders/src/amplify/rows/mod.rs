//! The rows of the buffers in which a GPU has the ground's columns: words of 32 bits, in rows of 16
//! and 32 bytes, none of which lies across a border of its own size.
//!
//! An edge has two rows and so has a face: the part that passes of the level above wrote and a
//! run's own part are mixed, so that both rows of an item are full and a pass that follows a number
//! loads no more than it needs. Nothing is smaller than a word but kinds, births, descents and
//! marks, which share one. A run therefore has rows of level 0 of its own, copied once; it never
//! resets them, because each pass writes all that it owns, of items that take no part, too.
//!
//! | row | bytes | written by |
//! |---|---|---|
//! | [`EdgeJoins`] | 16 | the level above |
//! | [`EdgeState`] | 16 | the level above; `mark` by `count_edges`, `mid` and `child` by `place_edges` |
//! | [`FaceSides`] | 16 | the level above; `marks` by `mark_halo` and `face_decide` |
//! | [`FaceCorners`] | 16 | the level above; `child` by `place_faces` |
//! | [`VertexCore`] | 32 | `edge_split` |
//! | [`VertexCourse`] | 16 | `edge_split` |
//! | [`VertexLand`] | 40 | `edge_split` |
//! | [`VertexRiver`] | 80 | `edge_split`, `vertex_resolve` |
//! | [`Carved`](super::carve::Carved) | 8 | `carve_all` |
//! | [`BlockCounts`], [`LevelSizes`], [`LevelArgs`] | 32, 32, 64 | the counts, `scan` |
//!
//! A binding of 128 MiB holds 8 million edges or faces of a level, and 1.6 million vertices, of 176
//! bytes each in all: a vertex carries its river by value.

pub mod edge;
pub mod face;
pub mod level;
pub mod vertex;

pub use edge::{EdgeJoins, EdgeState};
pub use face::{FaceCorners, FaceSides};
pub use level::{BlockCounts, LevelArgs, LevelCaps, LevelSizes};
pub use vertex::{VertexCore, VertexCourse, VertexLand, VertexRiver};

/// Where the members of a row lie, as its twin in WGSL has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RowLayout {
    /// Name of the type.
    pub name: &'static str,
    /// Bytes from one row to the next.
    pub size: usize,
    /// Names, offsets and sizes of the members, in bytes; none of a row that is no struct.
    pub members: &'static [(&'static str, usize, usize)],
}

/// A row of a buffer: a value of words of 32 bits without a hole.
pub trait Row: Copy {
    /// Where its members lie.
    const LAYOUT: RowLayout;

    /// Appends its words.
    fn write(&self, words: &mut Vec<u32>);

    /// The row of the next words; those that are missing are 0.
    fn read(words: &mut impl Iterator<Item = u32>) -> Self;
}

/// The words of many rows.
///
/// ```
/// use pangaea_shaders::amplify::rows::{FaceCorners, from_words, words};
///
/// let row = FaceCorners { vertices: [7, 8, 9], child: 4 };
/// assert_eq!(words([row, row]), [7, 8, 9, 4, 7, 8, 9, 4]);
/// assert_eq!(from_words::<FaceCorners>(&words([row])), [row]);
/// ```
pub fn words<R: Row>(rows: impl IntoIterator<Item = R>) -> Vec<u32> {
    let mut words = Vec::new();
    rows.into_iter().for_each(|row| row.write(&mut words));
    words
}

/// The rows of words; of a last row that is not whole the rest is 0.
pub fn from_words<R: Row>(words: &[u32]) -> Vec<R> {
    let rows = words.chunks(R::LAYOUT.size / 4);
    rows.map(|row| R::read(&mut row.iter().copied())).collect()
}

impl Row for u32 {
    const LAYOUT: RowLayout = RowLayout {
        name: "u32",
        size: 4,
        members: &[],
    };

    fn write(&self, words: &mut Vec<u32>) {
        words.push(*self);
    }

    fn read(words: &mut impl Iterator<Item = u32>) -> Self {
        words.next().unwrap_or_default()
    }
}

impl Row for i32 {
    const LAYOUT: RowLayout = RowLayout {
        name: "i32",
        size: 4,
        members: &[],
    };

    fn write(&self, words: &mut Vec<u32>) {
        words.push(*self as u32);
    }

    fn read(words: &mut impl Iterator<Item = u32>) -> Self {
        u32::read(words) as Self
    }
}

impl<R: Row, const N: usize> Row for [R; N] {
    const LAYOUT: RowLayout = RowLayout {
        name: "array",
        size: N * R::LAYOUT.size,
        members: &[],
    };

    fn write(&self, words: &mut Vec<u32>) {
        self.iter().for_each(|row| row.write(words));
    }

    fn read(words: &mut impl Iterator<Item = u32>) -> Self {
        core::array::from_fn(|_| R::read(words))
    }
}

/// Bytes of a member.
pub(crate) const fn member_size<R, M>(_: fn(&R) -> &M) -> usize {
    size_of::<M>()
}

/// Makes a `repr(C)` struct of words a row: `row!(FaceCorners { vertices, child })`.
macro_rules! row {
    ($name:ident { $($member:ident),+ $(,)? }) => {
        impl crate::amplify::rows::Row for $name {
            const LAYOUT: crate::amplify::rows::RowLayout = crate::amplify::rows::RowLayout {
                name: stringify!($name),
                size: size_of::<Self>(),
                members: &[$((
                    stringify!($member),
                    core::mem::offset_of!($name, $member),
                    crate::amplify::rows::member_size(|row: &Self| &row.$member),
                )),+],
            };

            fn write(&self, words: &mut Vec<u32>) {
                $(crate::amplify::rows::Row::write(&self.$member, words);)+
            }

            fn read(words: &mut impl Iterator<Item = u32>) -> Self {
                Self { $($member: crate::amplify::rows::Row::read(words)),+ }
            }
        }
    };
}

pub(crate) use row;

#[cfg(test)]
mod tests;
