mesh { triangle { 0, x, y } file "rabbit.ply" }
