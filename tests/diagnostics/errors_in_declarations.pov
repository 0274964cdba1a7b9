#declare A = 2 ** 3;
#declare B := 5;
#declare C = 5;
