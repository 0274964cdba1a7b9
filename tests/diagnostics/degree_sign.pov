sphere { 0, 1 rotate 90°*y }
