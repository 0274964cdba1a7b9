// SPDX-License-Identifier: GPL-3.0-or-later
// #for I = 1 to 10 ... #end
#version 3.7;
#for I = 1 to 10
  sphere { I, 0.1 }
#end
