//! Colours from light to dark, a hue for each body.

/// The path of a center of mass.
pub(super) const PATH: &str = "#9aa1a8";

/// Shades of one hue.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shades(&'static [&'static str; 10]);

const HUES: [[&str; 10]; 4] = [
    ["#c6dbef", "#b3d0e8", "#9ec5e1", "#86b8d9", "#6baad1", "#5199c6", "#3a86ba", "#2672ab", "#155d97", "#08447c"],
    ["#fdd9b4", "#fdcb98", "#fdba79", "#fda95c", "#f99641", "#f08229", "#e26f17", "#cf5c0b", "#b34b06", "#8f3a04"],
    ["#c9e8c5", "#b6dfb1", "#a0d59c", "#88c987", "#6dbc74", "#50ac62", "#389a51", "#248642", "#127033", "#045626"],
    ["#dedcee", "#cfcce5", "#bfbcdc", "#aeabd3", "#9e9ac8", "#8e85be", "#7e70b3", "#6f59a7", "#5f409a", "#4e258b"],
];

impl Shades {
    /// The shades of a body.
    pub(super) fn of(body: usize) -> Self {
        Self(&HUES[body % HUES.len()])
    }

    /// The shade at a share of the time, from 0 to 1.
    pub(super) fn shade(self, share: f64) -> &'static str {
        let index = (share.clamp(0.0, 1.0) * (self.0.len() - 1) as f64).round();
        self.0[(index as usize).min(self.0.len() - 1)]
    }
}
