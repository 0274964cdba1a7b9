M()
#macro M() sphere { 0, 1
#end
