// SPDX-License-Identifier: GPL-3.0-or-later
// A loop without an end
#version 3.7;
#for (I, 10) #end
