#declare A = 0;
#if (1) sphere { 0, 1 } #end if (A) sphere { x, 1 } #end
