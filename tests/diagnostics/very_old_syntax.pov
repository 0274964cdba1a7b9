#version 2.0
#max_trace_level 10
camera { location <0, 2, -8> look_at <0, 0.5, 0> }
object { light_source { <5, 8, -10> colour red 1 green 1 blue 1 } }
fog { colour red 0.5 green 0.5 blue 1  20 }
sphere { <0, 1, 0> 1 colour red 1 }
composite {
    object { sphere { <0, 1, 0> 1 } texture { pigment { colour red 1 } } }
    translate <1, 0, 0>
}
