print("hello")
#declare A = None;
