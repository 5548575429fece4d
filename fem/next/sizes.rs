//! How large what no law of a model makes is, and what is usual of that. All are errors of the diameter.

use super::line::Line;

/// How many there are.
pub const COUNT: usize = 9;

/// Positions among the sizes.
pub const NOISE: usize = 0;
pub const OF_PART: usize = 1;
pub const WALK: usize = 2;
pub const RATE_WALK: usize = 3;
pub const FIRST_RATE: usize = 4;
pub const PROFILE: usize = 5;
pub const OF_SET_UP: usize = 6;
pub const OF_INSERT: usize = 7;
pub const OF_PAUSE: usize = 8;

/// Noise of a diameter where nobody says, m: of a micrometer in a shop.
const USUAL_NOISE: f64 = 1.5e-6;
/// What is usual, in the noise of a reading, and by which factor it may be off (one standard deviation).
const OF_NOISE: [(usize, f64, f64); 4] =
    [(NOISE, 1.0, 3.0), (OF_PART, 0.3, 2.0), (WALK, 0.3, 2.5), (PROFILE, 0.5, 5.0)];
/// The same in m: a drift that no law knows, by part, and how it changes; how well a set-up and an insert repeat, and what a rest
/// leaves that the model does not know.
const OF_MACHINE: [(usize, f64, f64); 5] = [
    (FIRST_RATE, 0.4e-6, 3.0),
    (RATE_WALK, 0.05e-6, 3.0),
    (OF_SET_UP, 20e-6, 2.5),
    (OF_INSERT, 8e-6, 2.5),
    (OF_PAUSE, 1e-6, 3.0),
];
/// The sizes, and what is usual of each.
#[derive(Clone, Debug)]
pub struct Sizes {
    /// Logarithms of the sizes.
    own: [f64; COUNT],
    /// What is usual: mean and standard deviation of the logarithm.
    usual: [(f64, f64); COUNT],
    /// Whether the readings say their noise themselves.
    is_noise_known: bool,
}

impl Sizes {
    /// Those that are usual with the readings of a line, before anything is learnt from it.
    pub fn usual(line: &Line) -> Self {
        let stated = || line.steps.iter().flat_map(|step| &step.readings).map(|own| own.sigma);
        let is_noise_known = stated().all(f64::is_finite) && stated().next().is_some();
        let (count, square) = stated().filter(|s| s.is_finite()).fold((0.0, 0.0), |(n, sum), s| (n + 1.0, sum + s * s));
        let noise = if count > 0.0 { f64::sqrt(square / count) } else { repeated(line).unwrap_or(USUAL_NOISE) };
        let of_noise = OF_NOISE.iter().map(|(i, of, factor)| (*i, of * noise, *factor));
        let mut usual = [(0.0, 1.0); COUNT];
        of_noise.chain(OF_MACHINE).for_each(|(i, size, factor)| usual[i] = (size.ln(), factor.ln()));
        Self { own: usual.map(|(mean, _)| mean), usual, is_noise_known }
    }

    /// A size, m.
    pub fn of(&self, which: usize) -> f64 {
        self.own[which].exp()
    }

    /// The logarithm of how probable they are before anything is measured, but for a constant.
    pub fn prior(&self) -> f64 {
        let one = |(own, (mean, deviation)): (&f64, &(f64, f64))| -0.5 * ((own - mean) / deviation).powi(2);
        self.own.iter().zip(&self.usual).map(one).sum()
    }

    /// Those that are to be found.
    pub fn open(&self) -> impl Iterator<Item = usize> + use<> {
        let is_noise_known = self.is_noise_known;
        (0..COUNT).filter(move |which| *which != NOISE || !is_noise_known)
    }

    /// The same with one that is larger by so much, in its logarithm.
    #[must_use]
    pub fn moved(&self, which: usize, by: f64) -> Self {
        let mut other = self.clone();
        other.own[which] += by;
        other
    }
}

/// Scatter of readings of one part that were taken at one place, if there are some.
fn repeated(line: &Line) -> Option<f64> {
    let (mut square, mut freedom) = (0.0, 0usize);
    for step in &line.steps {
        let mut own: Vec<(f64, f64)> = step.readings.iter().map(|own| (own.place, own.error)).collect();
        own.sort_by(|a, b| a.0.total_cmp(&b.0));
        for group in own.chunk_by(|a, b| a.0 == b.0) {
            let mean = group.iter().map(|(_, error)| error).sum::<f64>() / group.len() as f64;
            square += group.iter().map(|(_, error)| (error - mean).powi(2)).sum::<f64>();
            freedom += group.len() - 1;
        }
    }
    (freedom > 2 && square > 0.0).then(|| (square / freedom as f64).sqrt())
}
