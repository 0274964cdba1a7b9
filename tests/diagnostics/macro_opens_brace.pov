#version 3.7;
#macro Open() union { #end
#for (I, 1, 2)
    Open() sphere { 0, 1 }
#end
