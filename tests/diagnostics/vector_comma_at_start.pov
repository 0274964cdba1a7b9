// SPDX-License-Identifier: GPL-3.0-or-later
// A comma before the first component
#version 3.7;
sphere { <, 0, 1>, 1 }
