#declare A = 2;
#switch (A)
    sphere { 0, 1 }
    #case (2) box { 0, 1 } #break
#end
