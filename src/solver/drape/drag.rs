//! Drag and speed limits of a drape by motion.

/// Residual at which an open seam counts as settled, and motion as ended: nothing moves any more.
pub(crate) const SETTLED: f64 = 1e-3;
/// Drag of a garment that comes to rest \[1/s\]. It sways at about 4 rad/s: twice that is critical.
pub(crate) const RELAXATION_DRAG: f64 = 8.0;
/// Speed limit of explicit steps of a garment that comes to rest \[m/s\].
pub(crate) const RELAXATION_SPEED_LIMIT: f64 = 5.0;
/// Drag while sewing \[1/s\].
pub(crate) const SEWING_DRAG: f64 = 40.0;
/// Speed limit of explicit steps while sewing \[m/s\].
pub(crate) const SEWING_SPEED_LIMIT: f64 = 2.0;
