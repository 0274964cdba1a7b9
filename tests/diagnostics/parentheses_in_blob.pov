blob { threshold 0.5 sphere { 0, 1, 1 } sphere (<1, 0, 0>, 1, 1) }
