// SPDX-License-Identifier: GPL-3.0-or-later
// #print
#version 3.7;
#print "hello"
