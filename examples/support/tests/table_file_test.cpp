#include "support/table_file.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <airlight/atmospheres.hpp>
#include <airlight/table_storage.hpp>
#include <cmath>
#include <limits>

#include "folder.hpp"
#include "support/files.hpp"
#include "support/image.hpp"

using support::StoredTable;
using support::TableDescription;
using support::TableFormat;

namespace {

struct OneFlagOff : airlight::DefaultScene {
    static constexpr bool mie = false;
};

TableDescription small_description() {
    return {"transmittance",
            "transmittance_uv",
            "share of light that reaches space",
            "1",
            4,
            3,
            2,
            {"R", "G", "B"},
            false,
            "plain",
            support::table_world<airlight::DefaultScene>(airlight::earth<double>())};
}

/// Every number another.
StoredTable small_table() {
    StoredTable table{small_description(), {}};
    for (int n = 0; n < 4 * 3 * 2 * 3; ++n) {
        table.texels.push_back(std::ldexp(1.0F + float(n) / 1024.0F, n / 8 - 6));
    }
    return table;
}

std::string refusal(const std::filesystem::path& path, const TableDescription& wanted) {
    return complaint([&] { support::read_table(path, wanted); });
}

}  // namespace

TEST_CASE("a table comes back as it was written, to the bit in float and rounded once in half") {
    const Folder folder;
    const StoredTable table = small_table();
    support::write_table(folder.path / "f.exr", table, TableFormat::single_float);
    CHECK(support::read_table(folder.path / "f.exr", table.about).texels == table.texels);

    support::write_table(folder.path / "h.exr", table, TableFormat::half_float);
    const StoredTable halves = support::read_table(folder.path / "h.exr", table.about);
    REQUIRE(halves.texels.size() == table.texels.size());
    for (std::size_t n = 0; n < table.texels.size(); ++n) {
        CHECK(halves.texels[n] == support::rounded_to_half(table.texels[n]));
    }
    CHECK(std::filesystem::file_size(folder.path / "h.exr") <
          std::filesystem::file_size(folder.path / "f.exr"));
    CHECK(folder.files() == 2);
}

TEST_CASE("halves lose what is dark, their square roots keep three digits of it") {
    StoredTable table = small_table();
    for (std::size_t n = 0; n < table.texels.size(); ++n) {
        table.texels[n] = std::pow(10.0F, -float(n) / 5.0F);  // to 6e-15
    }
    const StoredTable roots = support::in_roots(table);
    CHECK(roots.about.storage == "square root");
    for (std::size_t n = 0; n < table.texels.size(); ++n) {
        const float root = support::rounded_to_half(roots.texels[n]);
        const float light = airlight::light_from_stored(airlight::vec3<float>(root)).x;
        // Twice a half's roundoff, 2^-11, and floats' own.
        if (table.texels[n] > 5.7e-14F) {
            CHECK(std::fabs(light - table.texels[n]) <= 0.98e-3F * table.texels[n]);
        }
    }
    CHECK(support::rounded_to_half(table.texels[40]) == 0.0F);  // 1e-8 is below every half
}

TEST_CASE("slices lie below each other, and texels become tables of vectors") {
    const Folder folder;
    const StoredTable table = small_table();
    support::write_table(folder.path / "t.exr", table, TableFormat::single_float);
    const support::ExrImage image = support::read_exr(folder.path / "t.exr");
    CHECK(image.width == 4);
    CHECK(image.height == 6);
    CHECK(image.attributes.at("airlight.kind") == "transmittance");
    CHECK(image.attributes.at("airlight.units") == "1");
    CHECK(image.attributes.at("airlight.world.atmosphere.mie_g") ==
          support::number_text(airlight::earth<double>().mie_g));

    const auto vectors = support::table_of<airlight::vec3<float>>(table);
    CHECK(vectors.texel(1, 2, 1).y == table.texels[std::size_t(((1 * 3 + 2) * 4 + 1) * 3 + 1)]);
    CHECK(support::numbers_of(vectors) == table.texels);
}

TEST_CASE("a table of anything else is refused, in one line that says what to do") {
    const Folder folder;
    const std::filesystem::path path = folder.path / "t.exr";
    support::write_table(path, small_table(), TableFormat::half_float);
    CHECK(refusal(path, small_description()).empty());

    const auto says = [&](const TableDescription& wanted, const std::string& what,
                          const std::string& advice) {
        const std::string message = refusal(path, wanted);
        CAPTURE(message);
        CHECK(message.find(what) != std::string::npos);
        CHECK(message.find(advice) != std::string::npos);
        CHECK(message.find('\n') == std::string::npos);
    };
    TableDescription wanted = small_description();
    wanted.kind = "irradiance";
    says(wanted, "holds a table of transmittance, not of irradiance", "another file");
    wanted = small_description();
    wanted.mapping = "extinction_uv";
    says(wanted, "is read by transmittance_uv, not by extinction_uv", "bake it anew");
    wanted = small_description();
    wanted.width = 8;
    says(wanted, "has 4 x 3 x 2 texels, not 8 x 3 x 2", "--size");
    wanted = small_description();
    wanted.world = support::table_world<airlight::DefaultScene>(airlight::mars<double>());
    says(wanted, "made for another world (world.atmosphere.ground_albedo", "bake it anew");
    airlight::Atmosphere<double> air = airlight::earth<double>();
    air.mie_scattering.y = std::nextafter(air.mie_scattering.y, 1.0);  // the last digit counts
    wanted.world = support::table_world<airlight::DefaultScene>(air);
    says(wanted, "world.atmosphere.mie_scattering.g", "bake it anew");
    wanted.world = support::table_world<OneFlagOff>(airlight::earth<double>());
    says(wanted, "world.scene.mie is 1 there, 0 here", "bake it anew");
    wanted = small_description();
    wanted.world["orders"] = "4";
    says(wanted, "world.orders is missing there, 4 here", "bake it anew");
    wanted = small_description();
    wanted.world.erase("scene.ozone");
    says(wanted, "world.scene.ozone is 1 there, nothing here", "bake it anew");
    wanted = small_description();
    wanted.storage = "square root";
    says(wanted, "holds plain numbers, not square root ones", "--format");
    wanted = small_description();
    wanted.channels = {"R", "G"};
    says(wanted, "other channels", "bake it anew");
}

TEST_CASE("a file that is no table, or not whole, is refused") {
    const Folder folder;
    const std::filesystem::path path = folder.path / "t.exr";
    CHECK(refusal(path, small_description()).find("cannot read") != std::string::npos);

    support::write_file(path, "not a picture");
    CHECK(refusal(path, small_description()).find("is not a whole OpenEXR file") != std::string::npos);

    support::write_exr(path, {4, 6, {{"R", std::vector<float>(24, 0.5F)}}, {}});
    CHECK(refusal(path, small_description()).find("no table of airlight") != std::string::npos);

    support::write_table(path, small_table(), TableFormat::single_float);
    const std::string whole = support::read_file(path);
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        support::write_file(path, whole.substr(0, length));
        CAPTURE(length);
        CHECK_FALSE(refusal(path, small_description()).empty());
    }

    // Another version, in as many letters.
    std::string older = whole;
    const std::size_t at = older.find("version", older.find("airlight.version"));
    REQUIRE(at != std::string::npos);
    older.replace(older.find(AIRLIGHT_VERSION, at), std::string(AIRLIGHT_VERSION).size(), "9.8.7");
    support::write_file(path, older);
    CHECK(refusal(path, small_description()).find("is by airlight 9.8.7, and this is") != std::string::npos);
}

TEST_CASE("a texel that is no number, infinite or negative is refused, reading and writing") {
    const Folder folder;
    const std::filesystem::path path = folder.path / "t.exr";
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -1e-6F}) {
        StoredTable table = small_table();
        table.texels[std::size_t(((1 * 3 + 2) * 4 + 1) * 3 + 2)] = bad;
        const std::string writing =
            complaint([&] { support::write_table(path, table, TableFormat::single_float); });
        CHECK(writing.find("channel B of texel (1, 2, 1) is") != std::string::npos);
        CHECK(folder.files() == 0);  // nothing half written

        // The same by another hand.
        support::write_table(path, small_table(), TableFormat::single_float);
        support::ExrImage image = support::read_exr(path);
        image.channels[0].pixels[5] = bad;
        support::write_exr(path, image);
        const std::string reading = refusal(path, small_description());
        CHECK(reading.find("is damaged: channel B of texel (1, 1, 0) is") != std::string::npos);
        CHECK(reading.find("bake it anew") != std::string::npos);
        std::filesystem::remove(path);
    }
    StoredTable moments = small_table();
    moments.about.may_be_negative = true;
    moments.texels[3] = -1.0F;
    support::write_table(path, moments, TableFormat::single_float);
    CHECK(support::read_table(path, moments.about).texels[3] == -1.0F);

    StoredTable bright = small_table();
    bright.texels[0] = 70000.0F;
    const std::string half_says =
        complaint([&] { support::write_table(path, bright, TableFormat::half_float); });
    CHECK(half_says.find("try the format float") != std::string::npos);
}

TEST_CASE("two processes that write the same table leave one whole table") {
    const Folder folder;
    const std::filesystem::path path = folder.path / "t.exr";
    // Tables large enough for the writers to meet; whose it is in the end does not matter.
    StoredTable tables[2];
    for (int n = 0; n < 2; ++n) {
        tables[n].about = small_description();
        tables[n].about.width = 128;
        tables[n].about.height = 64;
        tables[n].about.depth = 4;
        tables[n].texels.assign(std::size_t(128 * 64 * 4 * 3), float(n + 1));
    }
    pid_t writers[2];
    for (int n = 0; n < 2; ++n) {
        writers[n] = ::fork();
        REQUIRE(writers[n] >= 0);
        if (writers[n] == 0) {
            bool written = true;
            for (int round = 0; round < 20; ++round) {
                written = complaint([&] {
                              support::write_table(path, tables[n], TableFormat::single_float);
                          }).empty() &&
                          written;
            }
            ::_exit(written ? 0 : 1);
        }
    }
    int whole = 0;
    int running = 2;
    while (running > 0) {
        int status = 0;
        const pid_t ended = ::waitpid(-1, &status, WNOHANG);
        if (ended > 0) {
            CHECK(WIFEXITED(status));
            CHECK(WEXITSTATUS(status) == 0);
            --running;
        }
        if (std::filesystem::exists(path)) {  // at every moment it is one of the two
            const StoredTable read = support::read_table(path, tables[0].about);
            CHECK((read.texels == tables[0].texels || read.texels == tables[1].texels));
            ++whole;
        }
    }
    CHECK(whole > 0);
    CHECK(folder.files() == 1);  // and no temporary is left
}
