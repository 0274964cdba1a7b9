#declare S = spline { linear_spline 0, <0, 0, 0>, 1, <1, 0, 0> }
sphere { S[0.5], 1 }
