//! Integration tests in one program; its modules mirror those of `src`.

mod export;
mod fit;
mod http;
mod job;
mod mesh;
mod pattern;
mod scene;
mod seam;
mod solver;
mod structure;
mod study;
