#version 3.7;
bicubic_patch { type 1 uv_vectors <0, 0> 0, x, x*2, x*3, y, y+x, y+x*2, y+x*3, y*2, y*2+x, y*2+x*2, y*2+x*3, y*3, y*3+x, y*3+x*2, y*3+x*3 }
//! error: the third value of `uv_vectors` must be a vector of 2, but it is a vector of 3
//!  --> uv_vectors_of_one.pov:2:45
//!   |
//! 2 | bicubic_patch { type 1 uv_vectors <0, 0> 0, x, x*2, x*3, y, y+x, y+x*2, y+x*3, y*2, y*2+x, y*2+x*2,…
//!   |                                             ^ this is a vector of 3
//! help: bicubic_patch { ... uv_vectors v, v, v, v ... }   the third value: vector of 2, default 1
//! error: the fourth value of `uv_vectors` must be a vector of 2, but it is a vector of 3
//!  --> uv_vectors_of_one.pov:2:48
//!   |
//! 2 | bicubic_patch { type 1 uv_vectors <0, 0> 0, x, x*2, x*3, y, y+x, y+x*2, y+x*3, y*2, y*2+x, y*2+x*2,…
//!   |                                                ^^^ this is a vector of 3
//! help: bicubic_patch { ... uv_vectors v, v, v, v ... }   the fourth value: vector of 2, default <0, 1>
