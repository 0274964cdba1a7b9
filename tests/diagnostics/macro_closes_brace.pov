#version 3.7;
#macro Close() } #end
sphere { 0, 1 }
Close()
