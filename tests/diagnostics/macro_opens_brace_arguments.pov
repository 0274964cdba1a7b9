#version 3.7;
#macro Open(R) union { sphere { 0, R } #end
#macro Close() } #end
Open(1, 2) box { 0, 1 } Close()
