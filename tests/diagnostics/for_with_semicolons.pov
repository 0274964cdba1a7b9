#version 3.7;
#for (I; 0; 3) #debug "again" #end
//! error: expected a value, `)` or `,`, but found `;`
//!  --> for_with_semicolons.pov:2:8
//!   |
//! 2 | #for (I; 0; 3) #debug "again" #end
//!   |      - ^
//!   |      |
//!   |      opened here
//! help: a loop counts between commas: #for (I, 1, 10)
