union { M()
sphere{5,1}
}
#macro M() sphere { 0, 1
#end
