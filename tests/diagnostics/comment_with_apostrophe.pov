# don't do this
sphere { 0, 1 }
