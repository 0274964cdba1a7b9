camera { position <0, 0, -5> }
camera { fov 30 }
