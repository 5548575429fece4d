//! Time stepping: diagonally implicit Runge–Kutta with one γ, so that all stages share one factor of C + γ Δt
//! K.
//!
//! ```text
//!   (C + γ Δt K) kᵢ = f(t + cᵢ Δt) − K (T + Δt Σⱼ aᵢⱼ kⱼ),     T ← T + Δt Σ bᵢ kᵢ
//! ```

/// A scheme of time stepping.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub enum Scheme {
    /// One stage, second order, no damping of what is faster than the step: rings after jumps.
    CrankNicolson,
    /// One stage, first order, strong damping.
    BackwardEuler,
    /// Two stages, second order, L-stable and stiffly accurate, γ = 1 − 1/√2 (Alexander 1977): follows jumps
    /// without ringing.
    #[default]
    Sdirk2,
}

/// 1 − 1/√2.
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;

impl Scheme {
    /// The coefficient γ.
    pub(in crate::solve) fn gamma(self) -> f64 {
        match self {
            Self::CrankNicolson => 0.5,
            Self::BackwardEuler => 1.0,
            Self::Sdirk2 => GAMMA,
        }
    }

    /// Weights bᵢ of the stages. Both schemes of two stages here have a₂₁ = b₁.
    pub(in crate::solve) fn weights(self) -> &'static [f64] {
        match self {
            Self::CrankNicolson | Self::BackwardEuler => &[1.0],
            Self::Sdirk2 => &[1.0 - GAMMA, GAMMA],
        }
    }

    /// Places cᵢ of the stages.
    pub(in crate::solve) fn places(self) -> &'static [f64] {
        match self {
            Self::CrankNicolson => &[0.5],
            Self::BackwardEuler => &[1.0],
            Self::Sdirk2 => &[GAMMA, 1.0],
        }
    }
}
