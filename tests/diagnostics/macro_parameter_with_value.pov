#version 3.7;
#macro Sum(A, B = 2) A + B #end
