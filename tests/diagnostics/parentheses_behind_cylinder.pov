light_source { 0, rgb 1 cylinder (1, 2, 3) }
