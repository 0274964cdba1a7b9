#declare A = 5, B = 6;
