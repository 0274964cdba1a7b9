#fopen F "out.txt" write
#fclose "out.txt"
