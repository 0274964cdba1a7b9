#declare A = 2*π;
