#declare Name = "opening.inc";
#include Name
Begin(2) Finish()
