#declare A = 3²;
#declare B = √2;
