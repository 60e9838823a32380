//! Tests of `fit`: garments sewn from pattern to report.

mod garmentcode;
mod samples;
mod seams;
mod true_garments;
mod verdict;
