//! Stiff and extreme cases, those that are small; `make stability` runs all of them.

#[path = "support/stability/mod.rs"]
mod stability;
