#declare A = B = 5;
