#declare A = array[2] { 1, 2 };
#declare A[1]: 3;
