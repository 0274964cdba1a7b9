sphere { 0, 1 pigment { gradient } }
