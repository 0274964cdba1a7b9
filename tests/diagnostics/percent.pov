// SPDX-License-Identifier: GPL-3.0-or-later
// A percent sign
#version 3.7;
sphere { 0, 50% }
