#version 3.7;
#macro Lamp(At)
    light_source { At, rgb 1
#end
union { Lamp(0) sphere { 0, 1 } }
Lamp(y)
