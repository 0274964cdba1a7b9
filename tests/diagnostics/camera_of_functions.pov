camera { user_defined location { function(u, v) { 0 } } }
