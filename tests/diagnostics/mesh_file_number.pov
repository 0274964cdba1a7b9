mesh { file 3 }
