#declare A = 1;
#if (A = 1) then
    sphere { 0, 1 }
#end
