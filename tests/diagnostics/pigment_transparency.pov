sphere { 0, 1 pigment { rgb 1 transparency 0.5 } }
