#version 3.7;
#macro Close() } #end
union { sphere { 0, 1 } Close()
