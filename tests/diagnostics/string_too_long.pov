#declare S = "0123456789";
#while (1)
    #declare S = concat(S, S);
#end
