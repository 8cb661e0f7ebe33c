//! Contact modes: one interaction letter per fixel (Balkcom & Trinkle 2002, Tables 1 and 2).

use std::fmt;
use std::str::FromStr;

/// What happens at one fixel; accelerations and forces in the contact frame `(n, t)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Interaction {
    /// `a`: approaches, `a_n < 0`, no force.
    Approach,
    /// `l`: slides left, `a_n = 0`, `a_t > 0`, `c_t = -μ_k c_n`.
    SlideLeft,
    /// `m`: maintains contact, `a_n = 0`, `|c_t| ≤ μ_s c_n`.
    Maintain,
    /// `n`: rolls or sticks, `a_n = a_t = 0`, `|c_t| ≤ μ_s c_n`.
    Roll,
    /// `r`: slides right, `a_n = 0`, `a_t < 0`, `c_t = μ_k c_n`.
    SlideRight,
    /// `s`: separates, `a_n ≥ 0` (or `> 0` where stated), no force.
    Separate,
    /// `u`: unconstrained, no force.
    Unconstrained,
}

impl Interaction {
    /// The letter.
    #[must_use]
    pub fn letter(self) -> char {
        match self {
            Self::Approach => 'a',
            Self::SlideLeft => 'l',
            Self::Maintain => 'm',
            Self::Roll => 'n',
            Self::SlideRight => 'r',
            Self::Separate => 's',
            Self::Unconstrained => 'u',
        }
    }

    fn from_letter(letter: char) -> Option<Self> {
        Some(match letter {
            'a' => Self::Approach,
            'l' => Self::SlideLeft,
            'm' => Self::Maintain,
            'n' => Self::Roll,
            'r' => Self::SlideRight,
            's' => Self::Separate,
            'u' => Self::Unconstrained,
            _ => return None,
        })
    }
}

/// An augmented contact mode, `als` for instance: one interaction per fixel in file order.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Mode(pub Vec<Interaction>);

impl FromStr for Mode {
    type Err = ModeError;

    fn from_str(text: &str) -> Result<Self, ModeError> {
        text.chars()
            .map(|letter| Interaction::from_letter(letter).ok_or(ModeError::UnknownLetter { letter }))
            .collect::<Result<Vec<_>, _>>()
            .map(Self)
    }
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|interaction| write!(f, "{}", interaction.letter()))
    }
}

/// Why a text is not a mode of a fixture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ModeError {
    /// Not one of the seven letters.
    #[error("'{letter}' is not an interaction; the letters are s a u l r n m")]
    UnknownLetter {
        /// The letter found.
        letter: char,
    },
    /// As many letters as fixels are needed.
    #[error("a mode has one letter per fixel: {fixels} for this case, not {letters}")]
    Length {
        /// Letters in the mode.
        letters: usize,
        /// Fixels in the case.
        fixels: usize,
    },
}
