#pragma once

#include <glm/names.hpp>
