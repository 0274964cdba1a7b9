#declare A = array(3);
