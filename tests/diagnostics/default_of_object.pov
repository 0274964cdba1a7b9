#default { sphere { 0, 1 } }
