#version 3.7;
#declare F = function (float X) { X*X }
