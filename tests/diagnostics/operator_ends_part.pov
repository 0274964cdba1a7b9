#version 3.7;
#declare A = 1;
#declare B = (#if (A) 2 + #end);
