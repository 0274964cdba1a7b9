#version 3.7;
#declare A = 5 6;
#declare B = 2(3 + 4);
#declare C = 2sin(1);
#declare D = 1, 2, 3;
#declare E = <1, 2, 3>[1];
