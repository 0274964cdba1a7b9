// SPDX-License-Identifier: GPL-3.0-or-later
// A division by zero
#version 3.7;
#declare Columns = 0;
sphere { <10/Columns, 0, 0>, 1 }
