#pragma once

// A table as it is read after it has been stored.

#include <airlight/table_storage.hpp>
#include <airlight/tables/table.hpp>
#include <cstddef>
#include <vector>

#include "kinds.hpp"

namespace bake_tables {

/// How a table's numbers are kept between baking and reading.
enum class Storage { single_float, half_float, root_half };

/// A table of any number of channels, stored and read back.
class StoredNumbers {
  public:
    StoredNumbers(const support::TableSize& size, std::size_t channels, const Numbers& numbers,
                  Storage storage)
        : storage_(storage) {
        for (std::size_t c = 0; c < channels; ++c) {
            airlight::Table<float> layer = airlight::make_table<float>(size.width, size.height, size.depth);
            for (std::size_t n = 0; n < layer.texels.size(); ++n) {
                layer.texels[n] = stored(numbers[n * channels + c]);
            }
            layers_.push_back(std::move(layer));
        }
    }

    /// Every channel at texture coordinates.
    std::vector<double> at(const airlight::vec3<double>& uvw) const {
        std::vector<double> numbers;
        for (const airlight::Table<float>& layer : layers_) {
            const float read = airlight::sample(layer, airlight::vec3<float>(uvw));
            numbers.push_back(storage_ == Storage::root_half
                                  ? double(airlight::light_from_stored(airlight::vec3<float>(read)).x)
                                  : double(read));
        }
        return numbers;
    }

  private:
    float stored(float number) const {
        switch (storage_) {
            case Storage::half_float:
                return support::rounded_to_half(number);
            case Storage::root_half:
                return support::rounded_to_half(airlight::stored_light(airlight::vec3<float>(number)).x);
            default:
                return number;
        }
    }

    Storage storage_;
    std::vector<airlight::Table<float>> layers_;
};

}  // namespace bake_tables
