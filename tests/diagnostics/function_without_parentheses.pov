#declare A = sin 30;
#declare R = seed;
