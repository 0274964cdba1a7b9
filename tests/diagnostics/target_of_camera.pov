camera { location 0 target z }
