#version 3.7;
background { 1, 0, 0 }
