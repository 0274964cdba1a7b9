#version 3.7;

global_settings {
  assumed_gamma 1.0
}

#declare lc_Color_007 = texture { pigment { rgb <0.500000, 0.500000, 0.500000> } finish { ambient 0.1 phong 0.2 phong_size 20 } }
#declare lc_Black = texture { pigment { rgb <0.105882, 0.164706, 0.203922> } finish { ambient 0.1 phong 0.2 phong_size 20 } }
#declare lc_Red = texture { pigment { rgb <0.705882, 0.000000, 0.000000> } finish { ambient 0.1 phong 0.2 phong_size 20 } }
#declare lc_Yellow = texture { pigment { rgb <0.980392, 0.784314, 0.039216> } finish { ambient 0.1 phong 0.2 phong_size 20 } }
#declare lc_Trans_Clear = texture { pigment { rgb <0.988235, 0.988235, 0.988235> filter 0.9 } finish { ambient 0.3 diffuse 0.2 reflection 0.25 phong 0.3 phong_size 60 } }
#declare lc_Main_Color = texture { pigment { rgb <1.000000, 1.000000, 0.500000> } finish { ambient 0.1 phong 0.2 phong_size 20 } }
#declare lc_Edge_Color = texture { pigment { rgb <0.500000, 0.500000, 0.500000> } finish { ambient 0.1 phong 0.2 phong_size 20 } }
#declare lc_Stud_Cylinder_Color = texture { pigment { rgb <0.105882, 0.164706, 0.203922> } finish { ambient 0.1 phong 0.2 phong_size 20 } }
#declare lc_No_Color = texture { pigment { rgb <0.500000, 0.500000, 0.500000> } finish { ambient 0.1 phong 0.2 phong_size 20 } }

#declare lc_brick_dat = mesh {
  smooth_triangle { <-0.80, -0.80, -0.00>, <-0.00, -0.00, 1.00>, <-0.80, 0.80, -0.00>, <-0.00, -0.00, 1.00>, <0.80, 0.80, -0.00>, <-0.00, -0.00, 1.00> }
  smooth_triangle { <0.80, 0.80, -0.00>, <-0.00, -0.00, 1.00>, <0.80, -0.80, -0.00>, <-0.00, -0.00, 1.00>, <-0.80, -0.80, -0.00>, <-0.00, -0.00, 1.00> }
  smooth_triangle { <0.80, -0.80, -0.96>, <-0.00, -0.00, -1.00>, <0.80, 0.80, -0.96>, <-0.00, -0.00, -1.00>, <-0.80, 0.80, -0.96>, <-0.00, -0.00, -1.00> }
  smooth_triangle { <-0.80, 0.80, -0.96>, <-0.00, -0.00, -1.00>, <-0.80, -0.80, -0.96>, <-0.00, -0.00, -1.00>, <0.80, -0.80, -0.96>, <-0.00, -0.00, -1.00> }
  smooth_triangle { <0.80, -0.80, -0.96>, <1.00, -0.00, 0.00>, <0.80, -0.80, -0.00>, <1.00, -0.00, 0.00>, <0.80, 0.80, -0.00>, <1.00, -0.00, 0.00> }
  smooth_triangle { <0.80, 0.80, -0.00>, <1.00, -0.00, 0.00>, <0.80, 0.80, -0.96>, <1.00, -0.00, 0.00>, <0.80, -0.80, -0.96>, <1.00, -0.00, 0.00> }
  smooth_triangle { <-0.80, -0.80, -0.96>, <-0.00, -1.00, 0.00>, <-0.80, -0.80, -0.00>, <-0.00, -1.00, 0.00>, <0.80, -0.80, -0.00>, <-0.00, -1.00, 0.00> }
  smooth_triangle { <0.80, -0.80, -0.00>, <-0.00, -1.00, 0.00>, <0.80, -0.80, -0.96>, <-0.00, -1.00, 0.00>, <-0.80, -0.80, -0.96>, <-0.00, -1.00, 0.00> }
  smooth_triangle { <-0.80, 0.80, -0.96>, <-1.00, -0.00, 0.00>, <-0.80, 0.80, -0.00>, <-1.00, -0.00, 0.00>, <-0.80, -0.80, -0.00>, <-1.00, -0.00, 0.00> }
  smooth_triangle { <-0.80, -0.80, -0.00>, <-1.00, -0.00, 0.00>, <-0.80, -0.80, -0.96>, <-1.00, -0.00, 0.00>, <-0.80, 0.80, -0.96>, <-1.00, -0.00, 0.00> }
  smooth_triangle { <0.80, 0.80, -0.96>, <-0.00, 1.00, 0.00>, <0.80, 0.80, -0.00>, <-0.00, 1.00, 0.00>, <-0.80, 0.80, -0.00>, <-0.00, 1.00, 0.00> }
  smooth_triangle { <-0.80, 0.80, -0.00>, <-0.00, 1.00, 0.00>, <-0.80, 0.80, -0.96>, <-0.00, 1.00, 0.00>, <0.80, 0.80, -0.96>, <-0.00, 1.00, 0.00> }
}

#declare lc_brick_dat_clear = lc_brick_dat

camera {
  perspective
  right x * image_width / image_height
  sky<0.235702,-0.235702,0.942809>
  location <-4.49754, 5.79754, 2.36877>
  look_at <0.24, 1.06, 0>
  angle 30 * image_width / image_height
}

background { color rgb <0.192157, 0.203922, 0.215686> }

light_source{ <0.240000, -2.684236, -3.744236>
  color rgb 0.75
  area_light 200, 200, 10, 10
  jitter
}

light_source{ <3.984236, -1.436157, 2.161737>
  color rgb 0.75
  area_light 200, 200, 10, 10
  jitter
}

light_source{ <0.240000, -3.932314, 0.000000>
  color rgb 0.5
  area_light 200, 200, 10, 10
  jitter
}

light_source{ <5.232314, 1.060000, -4.992314>
  color rgb 0.5
  area_light 200, 200, 10, 10
  jitter
}

object {
 lc_brick_dat
 texture { lc_Red }
 matrix <-1.0000, -0.0000, -0.0000, -0.0000, -1.0000, -0.0000, 0.0000, 0.0000, 1.0000, 0.0000, 0.0000, 0.0000>
}
object {
 lc_brick_dat
 texture { lc_Yellow }
 matrix <-1.0000, -0.0000, -0.0000, -0.0000, -1.0000, -0.0000, 0.0000, 0.0000, 1.0000, 0.8000, 0.0000, 0.9600>
}
object {
 lc_brick_dat_clear
 texture { lc_Trans_Clear }
 matrix <-0.8000, -0.6000, -0.0000, 0.6000, -0.8000, -0.0000, 0.0000, 0.0000, 1.0000, 0.0000, 1.8000, 0.0000>
}
