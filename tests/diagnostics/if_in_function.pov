#version 3.7;
#declare F = function (X) { if (X > 0) X else 0 };
