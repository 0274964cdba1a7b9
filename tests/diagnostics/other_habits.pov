sphere { 0, 1 rotate 45 y }
sphere { 0, 1 rotate y 45 }
#declare T = texture { pigment { rgb 1 } }
sphere { 0, 1 texture T }
#declare C = rgba <1, 0, 0, 0.5>;
