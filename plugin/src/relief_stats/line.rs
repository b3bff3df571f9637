//! The line of least squares through points of a power law.

/// The exponent p of y ~ x^-p through points (ln x, ln y): the slope, turned around, of the line of
/// least squares; `None` if all have the same x.
pub(super) fn falling_exponent(points: &[[f64; 2]]) -> Option<f64> {
    let n = points.len() as f64;
    let [mx, my] = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / n);
    let covariance: f64 = points.iter().map(|p| (p[0] - mx) * (p[1] - my)).sum();
    let variance: f64 = points.iter().map(|p| (p[0] - mx) * (p[0] - mx)).sum();
    (variance > 0.0).then(|| -covariance / variance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_has_its_exponent() {
        let points: Vec<[f64; 2]> = (0..5)
            .map(|x| [f64::from(x), 3.0 - 0.5 * f64::from(x)])
            .collect();
        assert!((falling_exponent(&points).unwrap() - 0.5).abs() < 1e-12);
        assert_eq!(falling_exponent(&[[1.0, 2.0], [1.0, 3.0]]), None);
        assert_eq!(falling_exponent(&[]), None);
    }
}
