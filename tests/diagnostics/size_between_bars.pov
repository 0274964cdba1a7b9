#declare A = |-5|;
