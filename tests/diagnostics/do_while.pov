#declare I = 0;
#do
    #declare I = I + 1;
#while (I < 10)
