#macro M(A, B) text { ttf "timrom.ttf" A B, 0 } #end
M("x -y")
