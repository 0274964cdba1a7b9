#include 'parts.inc'
