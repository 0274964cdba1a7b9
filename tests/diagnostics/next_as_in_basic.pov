#for (I, 0, 10)
  sphere { I*x, 0.5 }
#next
