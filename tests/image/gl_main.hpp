#pragma once

// main() of tests that draw: once per program, before anything of doctest.

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "support/gl_test.hpp"

int main(int argc, char** argv) {
    const auto context = support::open_context();
    return context == nullptr ? support::skipped : doctest::Context(argc, argv).run();
}
