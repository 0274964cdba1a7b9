#declare A = 2;
#switch (A)
    #range (2) sphere { 0, 1 } #break
#end
