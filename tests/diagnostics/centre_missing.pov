// SPDX-License-Identifier: GPL-3.0-or-later
// The centre is missing
#version 3.7;
sphere { 1 }
