#declare A = array[3] { 1, 2, 3 }
A.push(4)
