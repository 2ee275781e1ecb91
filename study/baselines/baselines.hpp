#pragma once

// All methods that airlight is compared with; glslgen translates them from here.

#include <baselines/cs562.hpp>
#include <baselines/double_loop.hpp>
#include <baselines/hdrp.hpp>
#include <baselines/hillaire.hpp>
#include <baselines/leenman.hpp>
#include <baselines/schueler.hpp>
