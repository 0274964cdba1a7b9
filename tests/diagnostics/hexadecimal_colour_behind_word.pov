sphere { 0, 1 pigment { color #ff8800 } }
