#include "baker.hpp"

#include <utility>

namespace deferred {

Baker::~Baker() {
    give_up();
}

void Baker::start(TableKind kind, const World& world) {
    give_up();
    wanted_ = true;
    busy_ = true;
    share_ = 0;
    thread_ = std::thread([this, kind, world] {
        tables_ = bake_tables(kind, world, [this](double share) {
            share_ = share;
            return wanted_.load();
        });
        busy_ = false;
    });
}

std::optional<AirTables> Baker::take() {
    if (busy_ || !thread_.joinable()) {
        return std::nullopt;
    }
    thread_.join();
    return std::exchange(tables_, std::nullopt);
}

void Baker::give_up() {
    wanted_ = false;
    if (thread_.joinable()) {
        thread_.join();
    }
    tables_.reset();
}

}  // namespace deferred
