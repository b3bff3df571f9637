//! Values as the words of 32 bits that both languages have them in.

use core::fmt::Debug;

/// A value as words: its parts one after the other, smaller numbers extended.
pub trait Words: Clone + Debug {
    /// How many there are.
    const COUNT: usize;

    /// Appends them.
    fn write(&self, words: &mut Vec<u32>);

    /// The value of the next words, whatever they are. They may run out for no value.
    fn read(words: &mut impl Iterator<Item = u32>) -> Self;
}

impl Words for u32 {
    const COUNT: usize = 1;

    fn write(&self, words: &mut Vec<u32>) {
        words.push(*self);
    }

    fn read(words: &mut impl Iterator<Item = u32>) -> Self {
        words.next().expect("a word")
    }
}

impl Words for i32 {
    const COUNT: usize = 1;

    fn write(&self, words: &mut Vec<u32>) {
        words.push(*self as u32);
    }

    fn read(words: &mut impl Iterator<Item = u32>) -> Self {
        u32::read(words) as i32
    }
}

impl Words for i16 {
    const COUNT: usize = 1;

    fn write(&self, words: &mut Vec<u32>) {
        i32::from(*self).write(words);
    }

    fn read(words: &mut impl Iterator<Item = u32>) -> Self {
        i32::read(words) as i16
    }
}

impl Words for bool {
    const COUNT: usize = 1;

    fn write(&self, words: &mut Vec<u32>) {
        words.push(u32::from(*self));
    }

    fn read(words: &mut impl Iterator<Item = u32>) -> Self {
        u32::read(words) & 1 == 1
    }
}

impl<T: Words, const N: usize> Words for [T; N] {
    const COUNT: usize = N * T::COUNT;

    fn write(&self, words: &mut Vec<u32>) {
        self.iter().for_each(|part| part.write(words));
    }

    fn read(words: &mut impl Iterator<Item = u32>) -> Self {
        std::array::from_fn(|_| T::read(words))
    }
}

macro_rules! tuples {
    ($($($part:ident)+;)+) => {$(
        impl<$($part: Words),+> Words for ($($part,)+) {
            const COUNT: usize = 0 $(+ $part::COUNT)+;

            #[allow(non_snake_case, reason = "a part is named as its type")]
            fn write(&self, words: &mut Vec<u32>) {
                let ($($part,)+) = self;
                $($part.write(words);)+
            }

            fn read(words: &mut impl Iterator<Item = u32>) -> Self {
                ($($part::read(words),)+)
            }
        }
    )+};
}

tuples! {
    A;
    A B;
    A B C;
    A B C D;
    A B C D E;
    A B C D E F;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_their_words() {
        let mut words = Vec::new();
        (-1, [7_u32, 8], (true, -3_i16)).write(&mut words);
        assert_eq!(words, [u32::MAX, 7, 8, 1, u32::MAX - 2]);
        let read = <(i32, [u32; 2], (bool, i16))>::read(&mut words.into_iter());
        assert_eq!(read, (-1, [7, 8], (true, -3)));
    }
}
