#declare S = seed(1);
#declare F = function(X) { X*rand(S) }
