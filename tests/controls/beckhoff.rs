//! Beckhoff, ISG: a list of set points and values in 0.1 um, actual less commanded.

use super::Added;
use super::axis::Files;
use super::text::{linear, value_of};

pub fn read(files: &Files) -> Added {
    let text = files.named("beckhoff.lis").to_string();
    let head = |key: &str| value_of(&text, &format!("kw.ssfk.{key} "));
    assert_eq!([head("unit"), head("interval"), head("bilateral")], [1.0, 0.0, 1.0]);
    let points = head("kw_nr_max") as usize;
    let cell = |i: usize, key: &str| 1e-4 * value_of(&text, &format!("kw.ssfk.table[{i}].{key} "));
    let column = |key: &str| (0..points).map(|i| (cell(i, "setpoint"), -cell(i, key))).collect::<Vec<_>>();
    let (ahead, back) = (column("pos"), column("neg"));
    assert!((1e-4 * head("kw_startpos") - ahead[0].0).abs() < 1e-9 && ahead.windows(2).all(|w| w[1].0 > w[0].0));
    Box::new(move |at, forward| linear(if forward { &ahead } else { &back }, at))
}
