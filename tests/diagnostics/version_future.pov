// SPDX-License-Identifier: GPL-3.0-or-later
// A version that is not there yet
#version 4.2;
sphere { 0, 1 }
