//! Rows that contradict those which they repeat.

/// Largest part of the rows that can be single mistakes.
pub const FEW: f64 = 0.1;

/// Whether each row contradicts the rows of its group, whatever the model says: it lies far from their median,
/// measured by the median of all such distances.
pub fn contradicting(group: &[usize], z: &[f64]) -> Vec<bool> {
    /// Fewest rows that tell which of them is wrong.
    const LEAST: usize = 4;
    /// Distance, in standard deviations, beyond which a row contradicts the others.
    const FAR: f64 = 6.0;
    let mut members = vec![0_u32; group.iter().max().map_or(0, |most| most + 1)];
    group.iter().for_each(|group| members[*group] += 1);
    // Of a million rows that each have their own conditions none is told to be wrong, and no list is needed.
    if members.iter().all(|members| (*members as usize) < LEAST) {
        return vec![false; z.len()];
    }
    let mut groups = vec![Vec::new(); members.len()];
    group.iter().enumerate().for_each(|(row, group)| groups[*group].push(row));
    let mut distances = vec![0.0; z.len()];
    for rows in groups.iter().filter(|rows| rows.len() >= LEAST) {
        let mut values: Vec<f64> = rows.iter().map(|row| z[*row]).collect();
        values.sort_unstable_by(f64::total_cmp);
        let median = 0.5 * (values[(values.len() - 1) / 2] + values[values.len() / 2]);
        rows.iter().for_each(|row| distances[*row] = (z[*row] - median).abs());
    }
    let mut sizes: Vec<f64> = distances.iter().copied().filter(|d| *d > 0.0).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    let usual = sizes.get(sizes.len() / 2).map_or(f64::INFINITY, |median| median / 0.6745);
    distances.into_iter().map(|d| d > FAR * usual).collect()
}

/// The rows that contradict those of their groups; none where they are too many to be single mistakes.
pub fn contradictions(group: &[usize], values: &[f64]) -> Vec<usize> {
    let is_out = contradicting(group, values);
    let rows: Vec<usize> = (0..values.len()).filter(|row| is_out[*row]).collect();
    if rows.len() as f64 > FEW * values.len() as f64 { Vec::new() } else { rows }
}
