#version 3.7;
#declare Leds = read_csv("values.csv");
#declare A = Leds[0]["pos_x"];
//! error: there is nothing called `pos_x` here
//!  --> csv_wrong_name.pov:3:22
//!   |
//! 3 | #declare A = Leds[0]["pos_x"];
//!   |                      ^^^^^^^
//! help: the names here are x, y, radiance
#declare B = Leds[0]["radianc"];
//! error: there is nothing called `radianc` here
//!  --> csv_wrong_name.pov:4:22
//!   |
//! 4 | #declare B = Leds[0]["radianc"];
//!   |                      ^^^^^^^^^
//! help: did you mean "radiance"?
#declare C = Leds["x"][0];
//! error: this index must be a number: nothing here has a name
//!  --> csv_wrong_name.pov:5:19
//!   |
//! 5 | #declare C = Leds["x"][0];
//!   |                   ^^^
