#version 3.7;
#declare Leds = read_csv("short_row.csv");
