#pragma once

#include "support/manifest.hpp"

namespace parity {

using support::Constant;
using support::Flag;
using support::Function;
using support::Hook;
using support::Manifest;
using support::Member;
using support::read_manifest;
using support::Struct;

}  // namespace parity
