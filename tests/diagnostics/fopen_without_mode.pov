#fopen F "numbers.txt"
#read (F, A)
