// SPDX-License-Identifier: GPL-3.0-or-later
// finish ambient 0.3
#version 3.7;
sphere { 0, 1 finish ambient 0.3 }
