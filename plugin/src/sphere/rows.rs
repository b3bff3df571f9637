//! Lists of different lengths in one array (compressed sparse rows).

use crate::parallel::CHUNK;

/// A list of items for each of the numbers 0..n.
#[derive(Clone, Debug)]
pub(crate) struct Rows<T> {
    /// Where each row begins, and where the last one ends.
    start: Vec<u32>,
    items: Vec<T>,
}

impl<T: Copy + Default> Rows<T> {
    /// Sorts pairs of row and item into `n` rows. Items of one row keep their order.
    pub(crate) fn new(n: usize, pairs: impl Iterator<Item = (u32, T)> + Clone) -> Self {
        // Counted one place ahead: the running sum then says where rows begin.
        let mut start = vec![0_u32; n + 1];
        for (row, _) in pairs.clone() {
            start[row as usize + 1] += 1;
        }
        for row in 0..n {
            start[row + 1] += start[row];
        }
        let mut next = start.clone();
        let mut items = vec![T::default(); start[n] as usize];
        for (row, item) in pairs {
            let at = &mut next[row as usize];
            items[*at as usize] = item;
            *at += 1;
        }
        Self { start, items }
    }

    /// Number of rows.
    pub(crate) fn len(&self) -> usize {
        self.start.len() - 1
    }

    /// The items of row `k`.
    #[inline(always)]
    pub(crate) fn row(&self, k: usize) -> &[T] {
        &self.items[self.start[k] as usize..self.start[k + 1] as usize]
    }

    /// Replaces the items of every row by as many others, which `change` writes; `None` if it fails
    /// for one of them.
    pub(crate) fn map<U: Copy + Default + Send>(
        mut self,
        change: impl Fn(&mut [T], &mut [U]) -> Option<()> + Sync,
    ) -> Option<Rows<U>>
    where
        T: Send,
    {
        let mut items = vec![U::default(); self.items.len()];
        change_rows(&self.start, &mut self.items, &mut items, &change)?;
        Some(Rows {
            start: self.start,
            items,
        })
    }
}

/// Changes some rows, which begin at all but the last of `start`, half of them on another thread.
fn change_rows<T: Send, U: Send>(
    start: &[u32],
    from: &mut [T],
    to: &mut [U],
    change: &(impl Fn(&mut [T], &mut [U]) -> Option<()> + Sync),
) -> Option<()> {
    let first = start[0];
    if start.len() <= CHUNK {
        return start.windows(2).try_for_each(|row| {
            let [start, end] = [row[0], row[1]].map(|at| (at - first) as usize);
            change(&mut from[start..end], &mut to[start..end])
        });
    }
    let half = start.len() / 2;
    let middle = (start[half] - first) as usize;
    let (from_low, from_high) = from.split_at_mut(middle);
    let (to_low, to_high) = to.split_at_mut(middle);
    let (low, high) = rayon::join(
        || change_rows(&start[..=half], from_low, to_low, change),
        || change_rows(&start[half..], from_high, to_high, change),
    );
    low.and(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_are_sorted_by_row_and_keep_their_order() {
        let rows = Rows::new(3, [(2, 'a'), (0, 'b'), (2, 'c')].into_iter());
        assert_eq!(rows.len(), 3);
        assert_eq!((rows.row(0), rows.row(1)), (&['b'][..], &[][..]));
        assert_eq!(rows.row(2), ['a', 'c']);
    }
}
