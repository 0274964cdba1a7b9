#include "colors.inc"
#include "finish.inc"

global_settings {assumed_gamma 1 max_trace_level 6}
background {color White}
camera {perspective
  right -4.31*x up 3.36*y
  direction 50.00*z
  location <0,0,50.00> look_at <0,0,0>}


light_source {<  2.00,   3.00,  40.00> color White
  area_light <0.70, 0, 0>, <0, 0.70, 0>, 3, 3
  adaptive 1 jitter}
// no fog
#declare simple = finish {phong 0.7}
#declare pale = finish {ambient 0.5 diffuse 0.85 roughness 0.001 specular 0.200 }
#declare intermediate = finish {ambient 0.3 diffuse 0.6 specular 0.1 roughness 0.04}
#declare vmd = finish {ambient 0.0 diffuse 0.65 phong 0.1 phong_size 40.0 specular 0.5 }
#declare jmol = finish {ambient 0.2 diffuse 0.6 specular 1 roughness 0.001 metallic}
#declare ase2 = finish {ambient 0.05 brilliance 3 diffuse 0.6 metallic specular 0.7 roughness 0.04 reflection 0.15}
#declare ase3 = finish {ambient 0.15 brilliance 2 diffuse 0.6 metallic specular 1.0 roughness 0.001 reflection 0.0}
#declare glass = finish {ambient 0.05 diffuse 0.3 specular 1.0 roughness 0.001}
#declare glass2 = finish {ambient 0.01 diffuse 0.3 specular 1.0 reflection 0.25 roughness 0.001}
#declare Rcell = 0.050;
#declare Rbond = 0.100;

#macro atom(LOC, R, COL, TRANS, FIN)
  sphere{LOC, R texture{pigment{color COL transmit TRANS} finish{FIN}}}
#end
#macro constrain(LOC, R, COL, TRANS FIN)
union{torus{R, Rcell rotate 45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     torus{R, Rcell rotate -45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     translate LOC}
#end

// no cell vertices
atom(<  0.88,  -0.42,  -1.79>, 0.76, rgb <0.56, 0.56, 0.56>, 0.0, ase3) // #0
atom(< -0.05,   0.41,  -0.92>, 0.76, rgb <0.56, 0.56, 0.56>, 0.0, ase3) // #1
atom(< -1.14,  -0.43,  -0.56>, 0.66, rgb <1.00, 0.05, 0.05>, 0.0, glass) // #2
atom(< -1.74,   0.09,   0.00>, 0.31, rgb <1.00, 1.00, 1.00>, 0.0, pale) // #3
atom(<  0.49,   0.76,  -0.03>, 0.31, rgb <1.00, 1.00, 1.00>, 0.0, vmd) // #4
atom(< -0.39,   1.29,  -1.47>, 0.31, rgb <1.00, 1.00, 1.00>, 0.0, jmol) // #5
atom(<  1.74,   0.17,  -2.10>, 0.31, rgb <1.00, 1.00, 1.00>, 0.0, intermediate) // #6
atom(<  1.23,  -1.29,  -1.24>, 0.31, rgb <1.00, 1.00, 1.00>, 0.0, simple) // #7
atom(<  0.34,  -0.76,  -2.68>, 0.31, rgb <1.00, 1.00, 1.00>, 0.0, ase2) // #8
cylinder {<  0.88,  -0.42,  -1.79>, <  0.41,  -0.01,  -1.35>, Rbond texture{pigment {color rgb <0.56, 0.56, 0.56> transmit 0.0} finish{ase3}}}
cylinder {< -0.05,   0.41,  -0.92>, <  0.41,  -0.01,  -1.35>, Rbond texture{pigment {color rgb <0.56, 0.56, 0.56> transmit 0.0} finish{ase3}}}
cylinder {<  0.88,  -0.42,  -1.79>, <  1.31,  -0.12,  -1.95>, Rbond texture{pigment {color rgb <0.56, 0.56, 0.56> transmit 0.0} finish{ase3}}}
cylinder {<  1.74,   0.17,  -2.10>, <  1.31,  -0.12,  -1.95>, Rbond texture{pigment {color rgb <1.00, 1.00, 1.00> transmit 0.0} finish{intermediate}}}
cylinder {<  0.88,  -0.42,  -1.79>, <  1.05,  -0.86,  -1.51>, Rbond texture{pigment {color rgb <0.56, 0.56, 0.56> transmit 0.0} finish{ase3}}}
cylinder {<  1.23,  -1.29,  -1.24>, <  1.05,  -0.86,  -1.51>, Rbond texture{pigment {color rgb <1.00, 1.00, 1.00> transmit 0.0} finish{simple}}}
cylinder {<  0.88,  -0.42,  -1.79>, <  0.61,  -0.59,  -2.23>, Rbond texture{pigment {color rgb <0.56, 0.56, 0.56> transmit 0.0} finish{ase3}}}
cylinder {<  0.34,  -0.76,  -2.68>, <  0.61,  -0.59,  -2.23>, Rbond texture{pigment {color rgb <1.00, 1.00, 1.00> transmit 0.0} finish{ase2}}}
cylinder {< -0.05,   0.41,  -0.92>, < -0.59,  -0.01,  -0.74>, Rbond texture{pigment {color rgb <0.56, 0.56, 0.56> transmit 0.0} finish{ase3}}}
cylinder {< -1.14,  -0.43,  -0.56>, < -0.59,  -0.01,  -0.74>, Rbond texture{pigment {color rgb <1.00, 0.05, 0.05> transmit 0.0} finish{glass}}}
cylinder {< -0.05,   0.41,  -0.92>, <  0.22,   0.58,  -0.47>, Rbond texture{pigment {color rgb <0.56, 0.56, 0.56> transmit 0.0} finish{ase3}}}
cylinder {<  0.49,   0.76,  -0.03>, <  0.22,   0.58,  -0.47>, Rbond texture{pigment {color rgb <1.00, 1.00, 1.00> transmit 0.0} finish{vmd}}}
cylinder {< -0.05,   0.41,  -0.92>, < -0.22,   0.85,  -1.20>, Rbond texture{pigment {color rgb <0.56, 0.56, 0.56> transmit 0.0} finish{ase3}}}
cylinder {< -0.39,   1.29,  -1.47>, < -0.22,   0.85,  -1.20>, Rbond texture{pigment {color rgb <1.00, 1.00, 1.00> transmit 0.0} finish{jmol}}}
cylinder {< -1.14,  -0.43,  -0.56>, < -1.44,  -0.17,  -0.28>, Rbond texture{pigment {color rgb <1.00, 0.05, 0.05> transmit 0.0} finish{glass}}}
cylinder {< -1.74,   0.09,   0.00>, < -1.44,  -0.17,  -0.28>, Rbond texture{pigment {color rgb <1.00, 1.00, 1.00> transmit 0.0} finish{pale}}}
// no constraints
