#pragma once

#include <string>
#include <vector>

#include "support/error.hpp"

namespace deferred {

/// "a, b, c" of items with a `name`.
template <typename Item>
std::string names(const std::vector<Item>& items) {
    std::string text;
    for (const Item& item : items) {
        text += (text.empty() ? "" : ", ") + item.name;
    }
    return text;
}

/// The item of this name. Throws support::Error when there is none; `kind` is what the message calls it.
template <typename Item>
const Item& by_name(const std::vector<Item>& items, const std::string& name, const std::string& kind) {
    for (const Item& item : items) {
        if (item.name == name) {
            return item;
        }
    }
    throw support::Error("no " + kind + " is called '" + name + "'; choose from " + names(items) +
                         "; see --help");
}

}  // namespace deferred
