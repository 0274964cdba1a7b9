#version 3.7;
#fopen Points "short_row.txt" read
#while (defined(Points))
    #read (Points, X, Y, Z)
    sphere { <X, Y, Z>, 1 }
#end
