sphere { 0, 1 pigment { image_map { jpg "x.jpg" } } }
sphere { 0, 1 pigment { image_map { tif "x.tif" } } }
height_field { jpg "x.jpg" }
