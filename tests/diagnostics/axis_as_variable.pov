#version 3.7;
#if (x > 3) #debug "more" #end
