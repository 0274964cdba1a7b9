light_source { 0, rgb 1 spotlight target z }
