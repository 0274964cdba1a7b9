#declare A = 1;
#if (A <> 3) #end
