//! What a run is asked for.

/// What a run is asked for besides the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Which model steps.
    pub model: ModelKind,
    /// Which of several motions that a step allows is followed.
    pub policy: Policy,
    /// Step (s), instead of the scene's.
    pub step: Option<f64>,
    /// Error of the final poses (m) that the automatic choice of the step aims at.
    pub tolerance: f64,
    /// Fastest recovery from overlap (m/s); without it the paper's φ/h.
    pub recovery_speed: Option<f64>,
    /// Whether compliant contacts are stepped by a scheme of second order where their dashpots allow it, instead of
    /// the paper's first-order one.
    pub second_order: bool,
    /// Whether to look for all forces that the last step allows, where contacts are rigid: they may be many that move the
    /// bodies alike, which a note then says.
    pub forces: bool,
    /// Most frames kept, evenly spaced.
    pub frames: usize,
    /// Most steps, substeps counted.
    pub max_steps: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            model: ModelKind::Auto,
            policy: Policy::First,
            step: None,
            tolerance: 1e-3,
            recovery_speed: None,
            second_order: false,
            forces: false,
            frames: 2_000,
            max_steps: 50_000_000,
        }
    }
}

/// Which model steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ModelKind {
    /// The cheapest that the scene allows, by computed criteria.
    #[default]
    Auto,
    /// Stewart and Trinkle's, equations (10)-(13), as printed.
    StewartTrinkle,
    /// Moreau's midpoint step with impacts located inside it.
    Moreau,
    /// Song, Pang and Kumar's, equations (14)-(17).
    SongPangKumar,
}

/// Which of several motions that a step allows is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Policy {
    /// The one that the solver finds first.
    #[default]
    First,
    /// Of all, the one after which the gaps are largest together: the worst for a part that is to be seated. For one free
    /// body in the plane, by Stewart and Trinkle's model.
    Adverse,
}
