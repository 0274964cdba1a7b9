#declare A = 2;
#switch (A)
    #case (1, 2) sphere { 0, 1 } #break
#end
