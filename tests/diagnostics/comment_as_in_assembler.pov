; this is a comment
sphere { 0, 1 }
