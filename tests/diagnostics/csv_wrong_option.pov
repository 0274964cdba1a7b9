#version 3.7;
#declare Leds = read_csv("values.csv", "delimiter=;");
//! error: `delimiter=;` is no option of read_csv; there are header, no_header, text, comma, semicolon, tab, bar and blank
//!  --> csv_wrong_option.pov:2:40
//!   |
//! 2 | #declare Leds = read_csv("values.csv", "delimiter=;");
//!   |                                        ^^^^^^^^^^^^^
