#version 3.7;
#declare Leds = read_csv("values.csv", "delimiter=;");
