#declare A = sphere { 0, 1 }
#for (I, 1, 40)
    #declare A = union { object { A } object { A translate x } }
#end
object { A }
