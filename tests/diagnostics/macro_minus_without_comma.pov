#macro M(A, B) sphere { A, B } #end
M(1 -2)
