//! The parameters that every integrator is made with.

/// Share of the stability limit that is used where the step is not given.
pub(crate) const SAFETY: f64 = 0.95;

/// Parameters of an integrator.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IntegratorSettings {
    /// Drag per mass `C_d / m` \[1/s\].
    pub(crate) drag: f64,
    /// Greatest speed of explicit steps \[m/s\].
    pub(crate) speed_limit: f64,
    /// Residual to which the equations of an implicit step are solved.
    pub(crate) residual: f64,
}
