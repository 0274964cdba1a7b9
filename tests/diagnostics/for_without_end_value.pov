// SPDX-License-Identifier: GPL-3.0-or-later
// A #for without end
#version 3.7;
#for (I, 1)
    sphere { I, 1 }
#end
