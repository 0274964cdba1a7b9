#fopen F "out.txt" write
#write F, "a"
#fclose F
