#version 3.7;
#declare A = array[2][2] { { 1, 2 }, { 3, 4 } }
#debug str(A[1], 0, 0)
