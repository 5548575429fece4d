//! Heat over time, piece by piece, and what a decaying wave makes of it: all in closed form.

/// g(τ) = constant + slope τ + cosine cos ωτ + sine sin ωτ while it lasts.
#[derive(Debug, Clone, Copy, Default)]
pub struct Piece {
    /// s.
    pub from: f64,
    /// s.
    pub to: f64,
    /// Of any unit.
    pub constant: f64,
    /// 1/s of that.
    pub slope: f64,
    /// As `constant`.
    pub cosine: f64,
    /// As `constant`.
    pub sine: f64,
    /// ω, rad/s.
    pub frequency: f64,
}

impl Piece {
    /// A constant from a time on to another.
    pub fn constant(constant: f64, from: f64, to: f64) -> Self {
        Self { from, to, constant, ..Self::default() }
    }

    /// `factor` times as large.
    pub fn times(self, factor: f64) -> Self {
        Self {
            constant: factor * self.constant,
            slope: factor * self.slope,
            cosine: factor * self.cosine,
            sine: factor * self.sine,
            ..self
        }
    }

    /// Whether it is zero all along.
    pub fn is_nothing(&self) -> bool {
        [self.constant, self.slope, self.cosine, self.sine].iter().all(|part| *part == 0.0)
    }

    /// At a time; where one piece ends and another begins, that which ends.
    pub fn at(&self, time: f64) -> f64 {
        let (sine, cosine) = (self.frequency * time).sin_cos();
        let lasts = time > self.from && time <= self.to;
        f64::from(lasts) * (self.constant + self.slope * time + self.cosine * cosine + self.sine * sine)
    }

    /// ∫ e^(−λ(t−τ)) g(τ) dτ up to a time, with λ = `rate` (1/s).
    pub fn decayed(&self, rate: f64, time: f64) -> f64 {
        let until = time.min(self.to);
        if until <= self.from {
            return 0.0;
        }
        let at = |tau: f64| {
            let level = match rate {
                0.0 => self.constant * tau + 0.5 * self.slope * tau * tau,
                _ => self.constant / rate + self.slope * (tau - 1.0 / rate) / rate,
            };
            if self.frequency == 0.0 {
                return level;
            }
            let (sine, cosine) = (self.frequency * tau).sin_cos();
            let (even, odd) =
                (rate * self.cosine - self.frequency * self.sine, rate * self.sine + self.frequency * self.cosine);
            level + (even * cosine + odd * sine) / (rate * rate + self.frequency * self.frequency)
        };
        (-rate * (time - until)).exp() * at(until) - (-rate * (time - self.from)).exp() * at(self.from)
    }
}

/// What is seen of a wave that decays at a rate and is fed by some pieces.
#[derive(Debug)]
pub struct Answer<'a> {
    pieces: &'a [Piece],
    time: f64,
    /// 1/s of the sensor's lag, and what the sensor alone would make of the pieces.
    lag: Option<(f64, f64)>,
}

impl<'a> Answer<'a> {
    /// At a time, through a lag (s) or none (0).
    pub fn of(pieces: &'a [Piece], time: f64, lag: f64) -> Self {
        let sum = |rate: f64| pieces.iter().map(|piece| piece.decayed(rate, time)).sum();
        Self { pieces, time, lag: (lag > 0.0).then(|| (1.0 / lag, sum(1.0 / lag))) }
    }

    /// Long waves follow late; the shortest at once: that is `follows()` over their rate.
    pub fn follows(&self) -> f64 {
        match self.lag {
            Some((quick, alone)) => quick * alone,
            None => self.pieces.iter().map(|piece| piece.at(self.time)).sum(),
        }
    }

    /// With a rate, 1/s. The sensor divides by (λ_s − λ): one after the other is the difference of the two.
    pub fn at(&self, rate: f64) -> f64 {
        let of = |rate: f64| self.pieces.iter().map(|piece| piece.decayed(rate, self.time)).sum::<f64>();
        match self.lag {
            None => of(rate),
            Some((quick, alone)) => {
                let apart = (quick - rate) / quick;
                // As quick as the sensor itself: a little beside.
                if apart.abs() < 1e-7 { self.at(rate * (1.0 + 1e-6)) } else { (of(rate) - alone) / apart }
            }
        }
    }
}
