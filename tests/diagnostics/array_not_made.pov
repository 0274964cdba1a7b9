#declare B[0] = 1;
