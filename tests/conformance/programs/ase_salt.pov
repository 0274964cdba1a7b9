#include "colors.inc"
#include "finish.inc"

global_settings {assumed_gamma 1 max_trace_level 6}
background {color White transmit 1.0}
camera {orthographic
  right -8.16*x up 8.81*y
  direction 1.00*z
  location <0,0,50.00> look_at <0,0,0>}
light_source {<  5.00,   5.00,  20.00> color White}
// no area light
fog {fog_type 1 distance 200.0000 color color White}
#declare simple = finish {phong 0.7}
#declare pale = finish {ambient 0.5 diffuse 0.85 roughness 0.001 specular 0.200 }
#declare intermediate = finish {ambient 0.3 diffuse 0.6 specular 0.1 roughness 0.04}
#declare vmd = finish {ambient 0.0 diffuse 0.65 phong 0.1 phong_size 40.0 specular 0.5 }
#declare jmol = finish {ambient 0.2 diffuse 0.6 specular 1 roughness 0.001 metallic}
#declare ase2 = finish {ambient 0.05 brilliance 3 diffuse 0.6 metallic specular 0.7 roughness 0.04 reflection 0.15}
#declare ase3 = finish {ambient 0.15 brilliance 2 diffuse 0.6 metallic specular 1.0 roughness 0.001 reflection 0.0}
#declare glass = finish {ambient 0.05 diffuse 0.3 specular 1.0 roughness 0.001}
#declare glass2 = finish {ambient 0.01 diffuse 0.3 specular 1.0 reflection 0.25 roughness 0.001}
#declare Rcell = 0.100;
#declare Rbond = 0.100;

#macro atom(LOC, R, COL, TRANS, FIN)
  sphere{LOC, R texture{pigment{color COL transmit TRANS} finish{FIN}}}
#end
#macro constrain(LOC, R, COL, TRANS FIN)
union{torus{R, Rcell rotate 45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     torus{R, Rcell rotate -45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     translate LOC}
#end

cylinder {< -2.07,  -3.03,  -1.79>, <  3.23,  -3.03,  -3.72>, Rcell pigment {Black}}
cylinder {< -3.89,  -1.10,  -6.77>, <  1.41,  -1.10,  -8.70>, Rcell pigment {Black}}
cylinder {< -3.23,   4.20,  -4.95>, <  2.07,   4.20,  -6.88>, Rcell pigment {Black}}
cylinder {< -1.41,   2.27,   0.03>, <  3.89,   2.27,  -1.90>, Rcell pigment {Black}}
cylinder {< -2.07,  -3.03,  -1.79>, < -3.89,  -1.10,  -6.77>, Rcell pigment {Black}}
cylinder {<  3.23,  -3.03,  -3.72>, <  1.41,  -1.10,  -8.70>, Rcell pigment {Black}}
cylinder {<  3.89,   2.27,  -1.90>, <  2.07,   4.20,  -6.88>, Rcell pigment {Black}}
cylinder {< -1.41,   2.27,   0.03>, < -3.23,   4.20,  -4.95>, Rcell pigment {Black}}
cylinder {< -2.07,  -3.03,  -1.79>, < -1.41,   2.27,   0.03>, Rcell pigment {Black}}
cylinder {<  3.23,  -3.03,  -3.72>, <  3.89,   2.27,  -1.90>, Rcell pigment {Black}}
cylinder {<  1.41,  -1.10,  -8.70>, <  2.07,   4.20,  -6.88>, Rcell pigment {Black}}
cylinder {< -3.89,  -1.10,  -6.77>, < -3.23,   4.20,  -4.95>, Rcell pigment {Black}}
atom(< -2.07,  -3.03,  -1.79>, 1.16, rgb <0.67, 0.36, 0.95>, 0.0, ase3) // #0
atom(<  0.58,  -3.03,  -2.75>, 0.71, rgb <0.12, 0.94, 0.12>, 0.0, ase3) // #1
atom(< -2.65,   0.58,  -3.37>, 1.16, rgb <0.67, 0.36, 0.95>, 0.0, ase3) // #2
atom(<  0.00,   0.58,  -4.34>, 0.71, rgb <0.12, 0.94, 0.12>, 0.0, ase3) // #3
atom(<  0.91,  -0.38,  -1.84>, 1.16, rgb <0.67, 0.36, 0.95>, 0.0, ase3) // #4
atom(< -1.74,  -0.38,  -0.88>, 0.71, rgb <0.12, 0.94, 0.12>, 0.0, ase3) // #5
atom(< -0.33,  -2.07,  -5.24>, 1.16, rgb <0.67, 0.36, 0.95>, 0.0, ase3) // #6
atom(< -2.98,  -2.07,  -4.28>, 0.71, rgb <0.12, 0.94, 0.12>, 0.0, ase3) // #7

// no constraints
