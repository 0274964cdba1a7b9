#declare Places = scatter(sphere { 0, 1 }, 0);
#declare More = scatter(sphere { 0, 1 }, 1e-5);
