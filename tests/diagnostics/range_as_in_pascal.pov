#for (I, 0..9)
sphere { I*x, 1 }
#end
