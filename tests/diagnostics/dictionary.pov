#declare D = dictionary { ["a"]: 1 };
