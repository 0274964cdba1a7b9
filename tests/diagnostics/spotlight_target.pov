light_source { <0, 10, 0>, rgb 1 spotlight target <0, 0, 0> }
