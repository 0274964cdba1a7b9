#declare E = polynomial { 3, xyz(1, 0, 0) 1 }
#declare F = polynomial { 3, xyz<1, 0, 0>: 1 }
