//! Medians and percentiles.

/// The median: the mean of the two middle values of an even number. NaN goes last; `None` of no
/// values.
pub(super) fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    let upper = *values.get(middle)?;
    Some(if values.len() % 2 == 1 {
        upper
    } else {
        0.5 * (values[middle - 1] + upper)
    })
}

/// The value that a share of `values` does not exceed, interpolated between ranks; 0 of no values.
pub(super) fn percentile(values: &mut [f32], share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let rank = share * (values.len() - 1) as f64;
    let (_, &mut low, above) = values.select_nth_unstable_by(rank as usize, f32::total_cmp);
    // The next rank is the least of those above.
    let high = above.iter().copied().min_by(f32::total_cmp).unwrap_or(low);
    f64::from(low) + (rank - rank.floor()) * (f64::from(high) - f64::from(low))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_are_middles() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), Some(2.5));
        assert_eq!(median(Vec::new()), None);
    }

    #[test]
    fn percentiles_lie_between_ranks() {
        assert_eq!(percentile(&mut [4.0, 0.0, 1.0, 3.0, 2.0], 0.5), 2.0);
        assert_eq!(percentile(&mut [0.0, 10.0], 0.75), 7.5);
        assert_eq!(percentile(&mut [], 0.5), 0.0);
    }
}
