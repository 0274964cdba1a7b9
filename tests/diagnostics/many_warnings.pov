#version 3.7;
#for (I, 1, 60)
    #declare A = asin(1 + I);
#end
