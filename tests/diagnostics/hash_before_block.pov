#version 3.7;
#global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 }
#light_source { <2, 4, -3> rgb 1 }
sphere { 0, 1 #pigment { rgb 1 } }
