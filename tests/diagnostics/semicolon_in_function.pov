#version 3.7;
#declare F = function (X) { X*X; }
