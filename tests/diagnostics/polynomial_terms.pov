#declare A = polynomial { 2, xyz(2, 0, 0): 1, xyz(2, 0, 1): 3 }
#declare B = polynomial { 2, xyz(-1, 0, 0): 1 }
#declare C = polynomial { 40, xyz(1, 0, 0): 1 }
#declare D = polynomial { 3, xyz(1, 0): 1 }
