#declare A = mod(5, 0);
sphere { 0, A }
