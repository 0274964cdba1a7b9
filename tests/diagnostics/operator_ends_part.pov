#version 3.7;
#declare A = 1;
#declare B = (#if (A) 2 + #end);
#declare C = (1 #for (I, 1, 2) + I * #end 3);
