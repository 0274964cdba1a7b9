#declare Places = scatter(3, 0.1);
