camera { cylinder (1, 2, 3) }
