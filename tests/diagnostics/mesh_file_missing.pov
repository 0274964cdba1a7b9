#declare Rabbit = mesh { file "rabbit.ply" smooth }
object { Rabbit }
