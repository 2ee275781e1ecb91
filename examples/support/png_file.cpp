#include <png.h>

#include <cstring>
#include <string>

#include "support/error.hpp"
#include "support/files.hpp"
#include "support/image.hpp"

// libpng reports errors by longjmp. So the functions it may jump out of hold no object with a destructor:
// they work on a Job that their caller owns.

namespace support {
namespace {

struct Job {
    std::string bytes;             // the file
    std::size_t position = 0;      // of the reader in `bytes`
    std::string message;           // of libpng, when it failed
    std::vector<png_byte> pixels;  // rows, tightly packed
    png_uint_32 width = 0;
    png_uint_32 height = 0;
    int bytes_per_pixel = 0;
    png_structp png = nullptr;
    png_infop info = nullptr;
};

void on_error(png_structp png, png_const_charp message) {
    static_cast<Job*>(png_get_error_ptr(png))->message = message;
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep data, std::size_t count) {
    Job& job = *static_cast<Job*>(png_get_io_ptr(png));
    if (job.bytes.size() - job.position < count) {
        png_error(png, "the file ends too early");
    }
    std::memcpy(data, job.bytes.data() + job.position, count);
    job.position += count;
}

void append_bytes(png_structp png, png_bytep data, std::size_t count) {
    static_cast<Job*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(data), count);
}

void flush_nothing(png_structp) {}

void allocate_pixels(Job& job) {
    job.pixels.resize(std::size_t(job.width) * job.height * std::size_t(job.bytes_per_pixel));
}

png_bytep row(Job& job, png_uint_32 y) {
    return job.pixels.data() + std::size_t(y) * job.width * std::size_t(job.bytes_per_pixel);
}

bool read_header(Job& job) {
    if (setjmp(png_jmpbuf(job.png)) != 0) {
        return false;
    }
    png_set_read_fn(job.png, &job, read_bytes);
    png_set_user_limits(job.png, png_uint_32(max_image_size), png_uint_32(max_image_size));
    png_read_info(job.png, job.info);
    job.width = png_get_image_width(job.png, job.info);
    job.height = png_get_image_height(job.png, job.info);
    return true;
}

bool read_rows(Job& job) {
    if (setjmp(png_jmpbuf(job.png)) != 0) {
        return false;
    }
    const int passes = png_set_interlace_handling(job.png);
    png_read_update_info(job.png, job.info);
    if (png_get_rowbytes(job.png, job.info) != std::size_t(job.width) * std::size_t(job.bytes_per_pixel)) {
        png_error(job.png, "an unexpected pixel layout");
    }
    for (int pass = 0; pass < passes; ++pass) {
        for (png_uint_32 y = 0; y < job.height; ++y) {
            png_read_row(job.png, row(job, y), nullptr);
        }
    }
    png_read_end(job.png, nullptr);
    return true;
}

bool write_rows(Job& job) {
    if (setjmp(png_jmpbuf(job.png)) != 0) {
        return false;
    }
    png_set_write_fn(job.png, &job, append_bytes, flush_nothing);
    png_set_IHDR(job.png, job.info, job.width, job.height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(job.png, job.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(job.png, job.info);
    for (png_uint_32 y = 0; y < job.height; ++y) {
        png_write_row(job.png, row(job, y));
    }
    png_write_end(job.png, nullptr);
    return true;
}

/// Opens the file up to its header, and gives libpng's memory back at the end.
class Reader {
  public:
    explicit Reader(const std::filesystem::path& path) : path_(path) {
        job.bytes = read_file(path);
        job.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, on_error, on_warning);
        job.info = job.png != nullptr ? png_create_info_struct(job.png) : nullptr;
        if (job.info == nullptr) {
            png_destroy_read_struct(&job.png, nullptr, nullptr);
            throw Error("libpng has no memory left to read '" + path.string() + "'; use a smaller image");
        }
        if (!read_header(job)) {
            png_destroy_read_struct(&job.png, &job.info, nullptr);
            fail();
        }
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() {
        png_destroy_read_struct(&job.png, &job.info, nullptr);
    }

    void read_pixels() {
        allocate_pixels(job);
        if (!read_rows(job)) {
            fail();
        }
    }

    Job job;

  private:
    [[noreturn]] void fail() const {
        throw Error("'" + path_.string() + "' is not a whole PNG file (" + job.message +
                    "); fetch it anew or give another");
    }

    std::filesystem::path path_;
};

}  // namespace

Picture read_picture_png(const std::filesystem::path& path) {
    Reader reader(path);
    Job& job = reader.job;
    png_set_expand(job.png);
    png_set_strip_16(job.png);
    png_set_strip_alpha(job.png);
    png_set_gray_to_rgb(job.png);
    job.bytes_per_pixel = 3;
    reader.read_pixels();
    return Picture{int(job.width), int(job.height), job.pixels};
}

GreyImage read_grey_png(const std::filesystem::path& path) {
    Reader reader(path);
    Job& job = reader.job;
    const int bits = png_get_bit_depth(job.png, job.info);
    if (png_get_color_type(job.png, job.info) != PNG_COLOR_TYPE_GRAY || (bits != 8 && bits != 16)) {
        throw Error("'" + path.string() +
                    "' is not a grey PNG of 8 or 16 bits; convert it, without alpha or colour");
    }
    job.bytes_per_pixel = bits / 8;
    reader.read_pixels();

    GreyImage image{int(job.width), int(job.height), {}};
    const std::size_t count = std::size_t(job.width) * job.height;
    image.pixels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        image.pixels[i] = bits == 8 ? std::uint16_t(job.pixels[i])
                                    : std::uint16_t(job.pixels[2 * i] * 256 + job.pixels[2 * i + 1]);
    }
    return image;
}

void write_png(const std::filesystem::path& path, const Picture& picture) {
    Job job;
    job.width = png_uint_32(picture.width);
    job.height = png_uint_32(picture.height);
    job.bytes_per_pixel = 3;
    job.pixels = picture.pixels;
    job.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, on_error, on_warning);
    job.info = job.png != nullptr ? png_create_info_struct(job.png) : nullptr;
    const bool written = job.info != nullptr && write_rows(job);
    png_destroy_write_struct(&job.png, &job.info);
    if (!written) {
        throw Error("cannot encode '" + path.string() + "' as PNG: " + job.message +
                    "; use a smaller picture");
    }
    write_file(path, job.bytes);
}

}  // namespace support
