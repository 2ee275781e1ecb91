#pragma once

#include <airlight/numeric.hpp>
//
#include <forgets_an_include.hpp>
