#declare Size = 1;
#undef Size
sphere { 0, Size }
