sphere { 0, 1 pigment { image_map { jpg "x.jpg" } } }
//! error: `image_map` has no word `jpg`
//!  --> image_kind_misspelt.pov:1:37
//!   |
//! 1 | sphere { 0, 1 pigment { image_map { jpg "x.jpg" } } }
//!   |                                     ^^^
//! help: did you mean `jpeg`?
sphere { 0, 1 pigment { image_map { tif "x.tif" } } }
//! error: `image_map` has no word `tif`
//!  --> image_kind_misspelt.pov:2:37
//!   |
//! 2 | sphere { 0, 1 pigment { image_map { tif "x.tif" } } }
//!   |                                     ^^^
//! help: did you mean `tiff`?
height_field { jpg "x.jpg" }
//! error: `height_field` has no word `jpg`
//!  --> image_kind_misspelt.pov:3:16
//!   |
//! 3 | height_field { jpg "x.jpg" }
//!   |                ^^^
//! help: did you mean `jpeg`?
