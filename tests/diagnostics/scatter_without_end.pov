#declare Places = scatter(plane { y, 0 }, 0.1);
