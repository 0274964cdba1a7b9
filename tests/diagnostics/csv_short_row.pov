#version 3.7;
#declare Leds = read_csv("short_row.csv");
//! error: line 3 of `short_row.csv` has 2 cells, and the header has 3
//!  --> short_row.csv:3:1
//!   |
//! 3 | 4,5
//!   | ^^^
//!   |
//!  ::: csv_short_row.pov:2:26
//!   |
//! 2 | #declare Leds = read_csv("short_row.csv");
//!   |                          --------------- read here
//! help: cells are separated by one sign and may stand in double quotes; read_csv(name, options) takes header, no_header, text, comma, semicolon, tab, bar and blank
