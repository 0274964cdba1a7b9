#declare A = sphere { 0, 1 }
#for (I, 1, 40)
    #declare A = difference { object { A } object { A translate x } }
#end
