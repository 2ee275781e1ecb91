// Traces light through the air of a habitat and between its walls into a table to judge approximations by.

#include <cstdio>
#include <string>

#include "habitat_table.hpp"
#include "support/command_line.hpp"

int main(int argc, char** argv) {
    CLI::App app(
        "Follows light through the air of a spinning cylinder and between its walls, backwards from the eye, "
        "and\n"
        "writes what the air of 64 rays adds and what the walls at their ends receive, with standard errors.",
        "trace_habitat");
    std::string table;
    double albedo = 0.3;
    std::uint64_t walks = 40000;
    std::uint64_t seed = 1;
    support::add_value(app, "--table", "<file.csv>", table, "to write; reference/data/habitat.csv is one")
        ->required();
    support::add_value(app, "--albedo", "<share>", albedo, "of walls and caps (default 0.3)")
        ->check(CLI::Range(0.0, 1.0));
    support::add_value(app, "--walks", "<count>", walks,
                       "for all orders, a channel and ray; twice as many for light scattered once "
                       "(default 40000)")
        ->check(CLI::Range(100.0, 1e12));
    support::add_value(app, "--seed", "<number>", seed, "another one gives another error (default 1)");
    app.footer("Exit status: 0 done, 1 an error, 2 wrong use.");
    return support::guarded_main(app, argc, argv, [&] {
        const reference::Habitat habitat{airlight::rama_air<double>(), airlight::rama_lights<double>(),
                                         reference::Vector(albedo), false};
        write_habitat_table(habitat, walks, seed, table);
        std::printf("%s: %zu rays\n", table.c_str(), judged_habitat_rays(habitat).size());
        return 0;
    });
}
