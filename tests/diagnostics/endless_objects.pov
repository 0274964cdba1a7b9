#declare I = 0;
#while (I < 3)
  sphere { I*x, 1 }
  sphere { I*y, 1 }
#end
