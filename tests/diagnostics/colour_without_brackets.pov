sphere { 0, 1 pigment { color rgb 1, 0, 0 } }
sphere { 0, 1 pigment { color 1, 0.5, 0 } }
sphere { 0, 1 pigment { rgbt 1, 0, 0, 0.5 } }
light_source { <0, 10, 0> rgb 1, 1, 1 }
background { rgb 0.1, 0.2, 0.3 }
