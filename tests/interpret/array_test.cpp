// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/said.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("arrays behave as POV-Ray's", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare A=array[2][3]{{1,2,3},{4,5,6}}; P(A[1][0]) P(A[0][2])", "4.000000 3.000000"},
        {"#declare A=array[3]{1,2,3}; P(A[1.9]) P(A[0.99999999999]) P(A[0])",
         "2.000000 2.000000 1.000000"},
        {"#declare A=array[2]{1,2} #declare C=A; #declare C[0]=5; P(A[0]) P(C[0])",
         "1.000000 5.000000"},
        {"#declare A=array[2]{<1,2,3>,x}; V(3,A[0]) P(A[1].x)", "<1.0000,2.0000,3.0000> 1.000000"},
        {"#declare A=array[2]{1,2,}; P(A[1])", "2.000000"},
        {"#declare A=array[3]{1 2 3} P(A[2])", "3.000000"},
        {"#declare A=array[2]{rgb 1, rgb <1,2,3>} V(5,A[1])",
         "<1.0000,2.0000,3.0000,0.0000,0.0000>"},
        {"#declare A=array[2]{1,2} #undef A[0] P(defined(A[0])) P(defined(A[1]))",
         "0.000000 1.000000"},
        {"#declare A=array[2]; #ifdef(A) P(1) #end #ifdef(A[0]) P(2) #else P(3) #end #declare "
         "A[0]=1; #ifdef(A[0]) P(4) #end",
         "1.000000 3.000000 4.000000"},
        {"#declare A=array[2]; #declare A[0]=array[3]{1,2,3}; #declare A[1]=array[1]{5} P(A[0][2]) "
         "P(A[1][0]) P(dimension_size(A[0],1))",
         "3.000000 5.000000 3.000000"},
        {"#declare A=array[2.9]; P(dimension_size(A,1))", "2.000000"},
        {"#declare A=array[1][1][1][1][1]; P(dimensions(A))", "5.000000"},
        {"#declare A=array[2][3]; P(dimensions(A)) P(dimension_size(A,2)) P(dimension_size(A,3)) "
         "P(dimension_size(A,0))",
         "2.000000 3.000000 0.000000 0.000000"},
        {"#macro M(e) #declare e = e + 1; #end #declare A=array[2]{1,2} M(A[1]) P(A[1])",
         "3.000000"},
        {"#macro M(a) #declare a[0] = 7; #end #declare A=array[2]{1,2} M(A) P(A[0])", "7.000000"},
        {"#declare A=array[2]{\"a\",\"b\"} #debug A[1]", "b"},
        {"#declare M=array mixed[3] {42, \"Fnord\", x} #debug M[1] V(3,M[2]) #declare M[0]=\"x\"; "
         "#debug M[0]",
         "Fnord<1.0000,0.0000,0.0000> x"},
        {"#declare T=array mixed [2][2] { {0, rgb x}, {1, \"end\"} } #debug T[1][1]", "end"},
        {"#declare A=array mixed; #declare A[1]=\"s\"; #declare A[0]=2; #declare A[1]=3; P(A[1])",
         "3.000000"},
        {"#declare A = array; #declare A[3] = 4; P(dimension_size(A,1)) #ifdef(A[9]) P(0) #end "
         "P(dimension_size(A,1)) #ifdef(A[2]) P(0) #end P(A[3])",
         "4.000000 10.000000 4.000000"},
        {"#declare B = array {1,2,3,} #declare B[dimension_size(B,1)] = 7; "
         "P(dimension_size(B,1)) P(B[3])",
         "4.000000 7.000000"},
        {"#declare A = array {} P(dimension_size(A,1))", "0.000000"},
        {"#declare A = array; #declare C = A; #declare A[1] = 5; P(dimension_size(C,1))",
         "0.000000"},
        {"#declare A = array; #for (I, 0, 99) #declare A[I] = I*I; #end P(A[99]) "
         "P(dimension_size(A,1))",
         "9801.000000 100.000000"},
        {"#macro M(r) #declare r[2] = 1; #end #declare A = array; M(A) P(dimension_size(A,1))",
         "3.000000"},
        {"#declare C = array[3] optional {1,,3} P(defined(C[1])) P(C[2])", "0.000000 3.000000"},
        {"#declare C = array[3] optional {1,U,3} P(defined(C[1])) P(C[0])", "0.000000 1.000000"},
        {"#declare C = array[2][2] { optional {,4}, {5,6} } P(defined(C[0][0])) P(C[0][1])",
         "0.000000 4.000000"},
        {"#declare C = array[3][2] optional { {1,2},, {5,6} } P(defined(C[1][1])) P(C[2][0])",
         "0.000000 5.000000"},
        {"#declare C = array[3] optional {<1,2>,,<3,4>,} P(C[2].y)", "4.000000"},
        {"#declare C = array optional {1,,3} P(dimension_size(C,1))", "3.000000"},
        {"#declare optional = 3; #declare mixed = array[1]{optional} P(mixed[0])", "3.000000"},
        {"#macro M() #declare A = array[1]{0} 0 #end #declare A = array[2]{5,6} P(A[M()])",
         "0.000000"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

TEST_CASE("a wrong array gets one message", "[interpret]") {
    const auto [script, result] = GENERATE(table<std::string, std::string>({
        {"#declare A=array[2]; #declare A[2]=1;",
         "error: the index must be from 0 to 1, but it is 2\n"},
        {"#declare A=array[2]; #declare A[-1]=1;",
         "error: the index must be from 0 to 1, but it is -1\n"},
        {"#declare A=array[2]; #declare b = A[0];",
         "error: this element of the array was never set\n"},
        {"#declare A=array[3]{1,2}", "error: here are 2 elements for a dimension of 3\n"},
        {"#declare A=array[2]{1,2,3}", "error: here are 3 elements for a dimension of 2\n"},
        {"#declare A=array[2]{1,\"a\"}",
         "error: all elements of an array are of one kind: the first is a number, and this is a "
         "string\n"},
        {"#declare A=array[2]; #declare A[0]=1; #declare A[1]=\"a\";",
         "error: all elements of an array are of one kind: others are a number, and this is a "
         "string\n"},
        {"#declare A=array{1,2} P(A[2])", "error: this element of the array was never set\n"},
        {"#declare A=array; #declare A[-1]=1;",
         "error: the index must be from 0 to -1, but it is -1\n"},
        {"#declare A=array; #declare A[0]=1; #declare A[1]=\"s\";",
         "error: all elements of an array are of one kind: others are a number, and this is a "
         "string\n"},
        {"#declare A=array[3] optional {1,,}  P(A[2])",
         "error: this element of the array was never set\n"},
        {"#declare A=array[3] optional {1,}", "error: here are 2 elements for a dimension of 3\n"},
        {"#declare A=array[3]{1,U,3}", "error: nothing is declared as `U`\n"},
        {"#declare A=array{{1},{2}}",
         "error: braces for a dimension that this array does not have\n"},
        {"#declare A=array[0]", "error: the size of an array must be at least 1, but it is 0\n"},
        {"#declare A=array[1][1][1][1][1][1]",
         "error: an array has at most 5 dimensions, but this has 6\n"},
        {"#declare A=array[1e6][1e6]", "error: an array has at most 100000000 elements\n"},
        {"#declare A=array[2][2]; #declare b = A[1];",
         "error: this array has 2 dimensions, and here is 1 index\n"},
        {"#declare A=1; #declare b = A[1];",
         "error: only arrays have elements, and this is a number\n"},
        {"#declare b = A[1];", "error: nothing is declared as `A`\n"},
        {"#declare A=array[2]{{1},{2}}",
         "error: braces for a dimension that this array does not have\n"},
        {"#declare A=array[1][1]{1}",
         "error: this array has 2 dimensions: its content is braces in braces\n"},
    }));
    INFO(script);
    CHECK(printed(script) == result);
}

}  // namespace candelabra
