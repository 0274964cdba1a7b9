light_source { <0, 10, 0>, rgb 1 brightness 2 }
