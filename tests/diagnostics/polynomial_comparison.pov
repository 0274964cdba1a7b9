// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison among exponents
#version 3.7;
polynomial { 2, xyz(1>2,0,0):1, xyz(0,2,0):1 }
