#version 3.7;
#macro Lamp(At)
    light_source { At, rgb 1
#end
sphere { 0, 1 }
