#version 3.7;
#macro Open() union { #end
#macro Close() } #end
Open() sphere { 0, 1 } Close()
