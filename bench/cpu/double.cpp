#define SCALAR double
#define SCALAR_NAME "double"
#define ADD_BENCHMARKS add_double
#include "benchmarks.inc"
