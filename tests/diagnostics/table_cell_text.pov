#version 3.7;
camera { location <0, 1, -5> look_at 0 }
#declare Height = "two and a half, or perhaps a little more than that";
light_source { <1, Height, 0.5>, rgb 1 }
