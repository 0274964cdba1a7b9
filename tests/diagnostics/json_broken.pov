#version 3.7;
#declare Set = read_json("broken.json");
