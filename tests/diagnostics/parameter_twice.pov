#macro M(a, b, a) a + b #end
