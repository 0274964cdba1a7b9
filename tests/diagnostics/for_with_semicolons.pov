#version 3.7;
#for (I; 0; 3) #debug "again" #end
