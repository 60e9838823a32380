//! Tests of `solver`: drapes and motions against closed forms, orders of convergence and limits.

mod buckling;
mod cantilever;
mod contact;
mod drape;
mod estimates;
mod hanging;
mod hard_scenes;
mod layer_friction;
mod levels;
mod motion_closed_forms;
mod motion_order;
mod motion_rest;
mod patch;
mod self_contact;
mod stability;
mod wind;
mod wind_closed_forms;
