#define SCALAR float
#define SCALAR_NAME "float"
#define ADD_BENCHMARKS add_float
#include "benchmarks.inc"
