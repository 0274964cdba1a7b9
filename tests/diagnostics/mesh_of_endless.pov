mesh { union { box { 0, 1 } plane { y, 0 } } }
