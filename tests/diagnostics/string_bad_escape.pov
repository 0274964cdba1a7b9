// SPDX-License-Identifier: GPL-3.0-or-later
// An escape that does not exist
#version 3.7;
#declare A = "C:\data\new";
