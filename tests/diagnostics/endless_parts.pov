union {
  #for (I, 1, 2)
    #while (1)
      box { -1, 1 }
      box { 0, 2 }
    #end
  #end
}
