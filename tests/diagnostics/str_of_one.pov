// SPDX-License-Identifier: GPL-3.0-or-later
// A number as text needs its form
#version 3.7;
#debug str(3)
