//! The time-steppers against the published scenes, closed forms and invariants.

mod discrete;
mod drives;
mod drops;
mod failures;
mod hard_contacts;
mod order;
mod peers;
mod peers_accuracy;
mod properties;
mod published;
mod space;
mod space_made;
mod space_oracle;
mod spk_accuracy;
mod spk_fallback;
mod spk_full_form;
mod spk_moving;
mod spk_published;
mod spk_robust;
mod spk_symmetry;
mod spk_tumble;
