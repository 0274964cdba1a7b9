// SPDX-License-Identifier: GPL-3.0-or-later
// Ball { ... }
#version 3.7;
#declare Ball = sphere { 0, 1 }
Ball { translate y }
