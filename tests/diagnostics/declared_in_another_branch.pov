#for (I, 0, 3)
    #if (I = 2) #declare Last = I; #end
    sphere { Last*x, 1 }
#end
