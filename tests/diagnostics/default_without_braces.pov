#default texture { pigment { rgb 1 } }
