#define BAKE_FIRST_ORDER
#include "scattering_incident.comp"
