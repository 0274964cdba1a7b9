// SPDX-License-Identifier: GPL-3.0-or-later
// The count says more than there are
#version 3.7;
polygon { 4, <0,0>, <1,0>, <1,1> }
