// SPDX-License-Identifier: GPL-3.0-or-later
// #for (I = 0; I < 10; I = I + 1)
#version 3.7;
#for (I = 0; I < 10; I = I + 1)
  sphere { I, 0.1 }
#end
