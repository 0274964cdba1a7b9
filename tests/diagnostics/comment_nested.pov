// SPDX-License-Identifier: GPL-3.0-or-later
// Comments nest
#version 3.7;
/* outer /* inner */
sphere { 0, 1 }
