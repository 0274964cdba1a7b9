#if (clock > 0) #declare Size = 1; #end
sphere { 0, Size }
#undef Size
