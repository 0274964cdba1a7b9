#fopen F "numbers.txt" "r"
#read (F, A)
