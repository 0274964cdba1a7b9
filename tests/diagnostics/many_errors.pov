// SPDX-License-Identifier: GPL-3.0-or-later
// More mistakes than are shown
#version 3.7;
#for (I, 1, 1)
    sphere { 0, Name_0 }
    sphere { 1, Name_1 }
    sphere { 2, Name_2 }
    sphere { 3, Name_3 }
    sphere { 4, Name_4 }
    sphere { 5, Name_5 }
    sphere { 6, Name_6 }
    sphere { 7, Name_7 }
    sphere { 8, Name_8 }
    sphere { 9, Name_9 }
    sphere { 10, Name_10 }
    sphere { 11, Name_11 }
    sphere { 12, Name_12 }
    sphere { 13, Name_13 }
    sphere { 14, Name_14 }
    sphere { 15, Name_15 }
    sphere { 16, Name_16 }
    sphere { 17, Name_17 }
    sphere { 18, Name_18 }
    sphere { 19, Name_19 }
    sphere { 20, Name_20 }
    sphere { 21, Name_21 }
    sphere { 22, Name_22 }
    sphere { 23, Name_23 }
    sphere { 24, Name_24 }
#end
