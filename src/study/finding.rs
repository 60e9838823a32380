//! The findings of a study that its report puts into words.

use crate::solver::Method;

/// The shape that runs begin with.
#[derive(Clone, Copy, Debug)]
pub(super) enum StartShape {
    /// The panels as they are placed.
    Placed,
    /// The garment draped in still air, before the wind blows.
    DrapedInStillAir,
    /// The garment sewn without weight, before it falls.
    SewnWithoutWeight,
}

/// A finding about the reference that errors on one mesh are measured against.
#[derive(Clone, Copy, Debug)]
pub(super) enum ReferenceFinding {
    /// No method came to rest in time.
    NoneAtRest,
    /// One method alone came to rest in time.
    OneAtRest(Method),
    /// There are more rest shapes than are kept to compare.
    TooManyRestShapes,
    /// Two methods came to rest in the same shape.
    SameRestShape(RestPair),
    /// Two methods came to rest in different shapes, `apart_m` from each other.
    DifferentRestShapes {
        pair: RestPair,
        apart_m: f64,
        /// True if rest shapes of the scene depend on the way there.
        depends_on_path: bool,
    },
    /// No motion was finished in time.
    NoMotion,
    /// One method alone was finished in time, down to steps of a length \[s\].
    OneMotion(Method, f64),
    /// Two methods were finished, each down to steps of a length \[s\].
    TwoMotions {
        methods: [(Method, f64); 2],
        apart_m: f64,
    },
}

/// Two methods with the energies of their rest shapes \[J\].
#[derive(Clone, Copy, Debug)]
pub(super) struct RestPair {
    pub(super) methods: [Method; 2],
    pub(super) energies_j: [f64; 2],
}
