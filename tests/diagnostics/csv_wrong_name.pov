#version 3.7;
#declare Leds = read_csv("values.csv");
#declare A = Leds[0]["pos_x"];
#declare B = Leds[0]["radianc"];
#declare C = Leds["x"][0];
