//! A queue that takes items in the order of their distance, but for what lies in one bucket.

/// Items in buckets of distance (Dial 1969): a push and a pop take constant time. Within a bucket
/// the first in is the first out.
pub(super) struct BucketQueue<T> {
    buckets: Vec<Vec<T>>,
    /// The bucket that is being emptied.
    current: usize,
    /// Place of the next item in it.
    next: usize,
}

impl<T: Copy> BucketQueue<T> {
    pub(super) fn new() -> Self {
        Self {
            buckets: Vec::new(),
            current: 0,
            next: 0,
        }
    }

    /// Adds an item to a bucket; to the present one if that bucket is done already.
    #[inline]
    pub(super) fn push(&mut self, bucket: usize, item: T) {
        let bucket = bucket.max(self.current);
        if self.buckets.len() <= bucket {
            self.buckets.resize_with(bucket + 1, Vec::new);
        }
        self.buckets[bucket].push(item);
    }

    /// The next item and its bucket.
    #[inline]
    pub(super) fn pop(&mut self) -> Option<(usize, T)> {
        while let Some(bucket) = self.buckets.get_mut(self.current) {
            if let Some(&item) = bucket.get(self.next) {
                self.next += 1;
                return Some((self.current, item));
            }
            // Gives the memory back: a search of the whole sphere fills hundreds of buckets.
            *bucket = Vec::new();
            self.current += 1;
            self.next = 0;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_come_by_bucket_and_then_in_order() {
        let mut queue = BucketQueue::new();
        queue.push(3, 'c');
        queue.push(1, 'a');
        queue.push(3, 'd');
        assert_eq!(queue.pop(), Some((1, 'a')));
        // The bucket 0 is done.
        queue.push(0, 'b');
        assert_eq!(queue.pop(), Some((1, 'b')));
        assert_eq!(queue.pop(), Some((3, 'c')));
        assert_eq!(queue.pop(), Some((3, 'd')));
        assert_eq!(queue.pop(), None);
    }
}
