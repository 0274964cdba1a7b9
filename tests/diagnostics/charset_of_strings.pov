#version 3.7;
global_settings { charset utf8 }
#declare Name = "café";
