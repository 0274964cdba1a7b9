#declare A = 3²;
#declare B = √2;
#declare C = A³;
